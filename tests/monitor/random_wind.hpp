// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "core/units.hpp"

namespace lac::test {

/// A wind speed known at any time: sines of random phase with the spectrum of a REWS, S ~
/// 1/(1 + f/f0)^(5/3) with a cut-off at 0.2 Hz, standard deviation `sigma_mps`.
class RandomWind {
 public:
  RandomWind(unsigned seed, double mean_mps, double sigma_mps) : mean_mps_(mean_mps) {
    std::mt19937 random(seed);
    double power = 0.0;
    for (int i = 0; i < kSines; ++i) {
      const double f_hz = 0.003 * (i + static_cast<double>(random() % 1000) / 1000.0);
      const double roll_off = 1.0 + std::pow(f_hz / 0.2, 4.0);
      const double amplitude = std::pow(1.0 + f_hz / 0.02, -5.0 / 6.0) / roll_off;
      const double phase = 2.0 * kPi * static_cast<double>(random() % 10000) / 10000.0;
      sines_.push_back({radps_from_hz(f_hz), amplitude, phase});
      power += 0.5 * amplitude * amplitude;
    }
    for (Sine& s : sines_) s.amplitude_mps *= sigma_mps / std::sqrt(power);
  }
  double at(double time_s) const {
    double v = mean_mps_;
    for (const Sine& s : sines_) {
      v += s.amplitude_mps * std::sin(s.frequency_radps * time_s + s.phase_rad);
    }
    return v;
  }

 private:
  static constexpr int kSines = 70;
  struct Sine {
    double frequency_radps, amplitude_mps, phase_rad;
  };
  double mean_mps_;
  std::vector<Sine> sines_;
};

}  // namespace lac::test
