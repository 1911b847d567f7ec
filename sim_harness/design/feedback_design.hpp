// SPDX-License-Identifier: Apache-2.0
// The feedback controller of a design: its gains from turbine and rotor table.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "feedback/feedback_params.hpp"
#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/turbine/turbine_params.hpp"

namespace lac::sim {

struct FeedbackDesign {
  std::filesystem::path file;     // the template
  std::vector<double> winds_mps;  // points of the gain schedule, above rated
  LoopTarget pitch, torque;
  FeedbackParams params;  // of the template, with the gains designed here
};

/// Keys: template, gain_wind_speeds_mps (default: those above rated wind by 0.5 m/s), damping,
/// frequency_radps, torque_damping, torque_frequency_radps (0.7, 0.5). Throws lac::Error, also if
/// rated speed, torque or gearbox of the template are not the turbine's.
FeedbackDesign read_feedback_design(YamlReader in, const TurbineParams& turbine,
                                    const std::vector<double>& winds_mps);

/// The turbine at rated speed and torque, as feedback/gain_design.hpp wants it.
DesignPlant design_plant(const TurbineParams& turbine);

/// The template with `Gains given` and the arrays in the place of its own gains, their origin in
/// comments. Precondition: the template was read.
std::string designed_feedback_input(std::string_view template_text, const FeedbackDesign& design,
                                    const TurbineParams& turbine);

}  // namespace lac::sim
