// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "support/lidar_scan.hpp"

namespace lac::test {

inline constexpr double kChainStep_s = 0.0125;

/// What one of several turbines tells its controller, from step to step: a generator speed with
/// noise, pitch, wind, and the four-beam lidar in a wind of its own. Turbines differ in
/// everything; the same turbine is always the same.
class ChainInputs {
 public:
  explicit ChainInputs(int turbine)
      : random_(static_cast<std::mt19937::result_type>(1000 + turbine)),
        mean_mps_(15.0 + 0.7 * turbine),
        rate_radps_(0.25 + 0.03 * turbine) {
    scan_.travel_mps = mean_mps_;
    scan_.gate_distance_m.clear();
    for (int gate = 0; gate < 10; ++gate) scan_.gate_distance_m.push_back(50.0 + 13.3 * gate);
    scan_.wind_mps = [this](double t) { return wind_mps(t); };
  }
  ChainInputs(const ChainInputs&) = delete;
  ChainInputs& operator=(const ChainInputs&) = delete;

  /// Fills the records of the next step, in the order of steps. Allocates nothing.
  void fill(SwapView swap) {
    const double time_s = static_cast<double>(step_) * kChainStep_s;
    const double noise = static_cast<double>(random_() % 2048) / 2048.0 - 0.5;
    const double speed_radps =
        122.91 * (1.0 + 0.02 * std::sin(rate_radps_ * time_s + 1.0) + 0.002 * noise);
    swap.set(Rec::GeneratorSpeed, speed_radps);
    swap.set(Rec::RotorSpeed, speed_radps / 97.0);
    swap.set(Rec::GeneratorTorque, 43093.55 * 122.91 / speed_radps);
    swap.set(Rec::GeneratorContactor, 1.0);
    swap.set(Rec::HubWindSpeed, wind_mps(time_s) + noise);
    for (const Rec r : {Rec::PitchBlade1, Rec::PitchBlade2, Rec::PitchBlade3}) {
      swap.set(r, 0.22 + 0.03 * std::sin(rate_radps_ * time_s));
    }
    const bool is_new = lidar_alive && step_ % kStepsPerBeam == 0;
    if (is_new) {
      const auto beam = static_cast<int>(step_ / kStepsPerBeam % 4);
      measurement_ = scan_.measure(time_s, beam);
    }
    write_native_lidar(swap, measurement_, is_new);
    ++step_;
  }

  /// Goes past steps that another host made.
  void skip(int steps) {
    std::vector<float> nobody(kExtendedArraySize);
    for (int i = 0; i < steps; ++i) fill({nobody.data(), kExtendedArraySize});
  }

  bool lidar_alive = true;

 private:
  static constexpr long kStepsPerBeam = 20;  // 0.25 s

  double wind_mps(double t) const {
    return mean_mps_ + 1.5 * std::sin(rate_radps_ * t) + 0.5 * std::sin(2.3 * rate_radps_ * t);
  }

  std::mt19937 random_;
  double mean_mps_;
  double rate_radps_;
  LidarScan scan_;
  LidarMeasurement measurement_;
  long step_ = 0;
};

}  // namespace lac::test
