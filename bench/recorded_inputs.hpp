// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "core/swap_view.hpp"

namespace lac::bench {

inline constexpr int kRecorded = 8000;  // 100 s of inputs at 80 Hz, repeated

struct HostInput {
  float generator_speed_radps, rotor_speed_radps, wind_mps, pitch_rad;
};

/// Inputs like those of a turbine at 18 m/s in turbulence: everything moves at every step.
inline std::vector<HostInput> recorded_inputs() {
  std::vector<HostInput> inputs;
  inputs.reserve(kRecorded);
  for (int i = 0; i < kRecorded; ++i) {
    const double t = i * 0.0125;
    const double slow = std::sin(0.31415926 * t), fast = 0.3 * std::sin(2.1 * t);
    const double speed = 122.91 * (1.0 + 0.02 * (slow + fast));
    inputs.push_back({static_cast<float>(speed), static_cast<float>(speed / 97.0),
                      static_cast<float>(18.0 + 2.0 * slow + fast),
                      static_cast<float>(0.26 + 0.02 * slow)});
  }
  return inputs;
}

inline void set_inputs(SwapView swap, const HostInput& in) {
  swap.set(Rec::GeneratorSpeed, static_cast<double>(in.generator_speed_radps));
  swap.set(Rec::RotorSpeed, static_cast<double>(in.rotor_speed_radps));
  swap.set(Rec::GeneratorTorque, 43093.55);
  swap.set(Rec::GeneratorContactor, 1.0);
  swap.set(Rec::HubWindSpeed, static_cast<double>(in.wind_mps));
  swap.set(Rec::PitchBlade1, static_cast<double>(in.pitch_rad));
  swap.set(Rec::PitchBlade2, static_cast<double>(in.pitch_rad));
  swap.set(Rec::PitchBlade3, static_cast<double>(in.pitch_rad));
}

}  // namespace lac::bench
