// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "core/units.hpp"
#include "feedback/feedback.hpp"

namespace lac::test {

inline const std::string kShippedInput = LAC_SOURCE_DIR "/config/nrel5mw/feedback.IN";

/// The shipped input file with the line of a key replaced (or removed by an empty text), as a
/// text that can be parsed at the place of the shipped file.
inline std::string shipped_text(const std::string& key = "", const std::string& line = "") {
  std::ifstream file(kShippedInput);
  std::string result;
  bool found = key.empty();
  for (std::string one; std::getline(file, one);) {
    const bool here = !key.empty() && one.find("! " + key + " ") != std::string::npos;
    found = found || here;
    result += (here ? line : one) + "\n";
  }
  if (!found) throw std::runtime_error("no key " + key + " in the shipped file");
  return result;
}

inline FeedbackParams parsed(const std::string& text) {
  InputFile in = InputFile::parse(text, kShippedInput);
  return FeedbackParams::read(in);
}

inline FeedbackParams shipped_params() {
  return parsed(shipped_text());
}

inline DesignPlant nrel5mw_plant() {
  const FeedbackParams p = shipped_params();
  DesignPlant plant{
      {RotorTable::load(LAC_SOURCE_DIR "/config/turbines/nrel5mw/cp_ct.txt"), 63.0, 1.225}};
  plant.inertia_kgm2 = 4.3703e7;
  plant.gearbox_ratio = 97.0;
  plant.rated_generator_speed_radps = p.torque.rated_speed_radps;
  plant.rated_generator_torque_Nm = p.torque.rated_torque_Nm;
  return plant;
}

/// The rotor as one degree of freedom, with demands that act at once; Euler steps of a fifth of
/// the control step.
struct OneDofRotor {
  DesignPlant plant;
  double speed_radps = 0.0;  // rotor side

  double generator_speed_radps() const { return plant.gearbox_ratio * speed_radps; }
  void advance(double wind_mps, double pitch_rad, double torque_Nm, double time_step_s) {
    for (int i = 0; i < 5; ++i) {
      const double torque = plant.aero.torque_Nm(wind_mps, speed_radps, pitch_rad) -
                            plant.gearbox_ratio * torque_Nm / plant.gearbox_efficiency;
      speed_radps += 0.2 * time_step_s * torque / plant.inertia_kgm2;
    }
  }
};

}  // namespace lac::test
