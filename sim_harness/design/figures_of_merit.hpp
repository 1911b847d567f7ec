// SPDX-License-Identifier: Apache-2.0
// What a correlation curve says in one number (methods section 5).
#pragma once

#include <optional>
#include <vector>

#include "sim_harness/design/correlation_curve.hpp"

namespace lac::sim {

inline constexpr double kMinus3dB = 0.70794578438413791;  // 10^(-3/20)

/// Where y first falls through the level, x rising and above 0: cubic through four neighbours in
/// log x. Empty if it does not: nothing is extrapolated.
std::optional<double> first_crossing(const std::vector<double>& x, const std::vector<double>& y,
                                     double level);

/// Wavelengths of 2 pi/k0.5 in diameters (lecture on lidar-assisted control).
enum class EddyClass { kVeryGood, kGood, kAverage, kSufficient, kPoor };
const char* text_of(EddyClass c);

struct FiguresOfMerit {
  std::optional<double> k05_radpm;         // gamma^2 = 1/2
  std::optional<double> cutoff_hz;         // |G_RL| = -3 dB
  std::optional<double> fitted_cutoff_hz;  // of the first-order low-pass closest to |G_RL|

  std::optional<double> smallest_eddy_m() const;
  std::optional<EddyClass> eddy_class(double rotor_diameter_m) const;
};

FiguresOfMerit figures_of_merit(const CorrelationCurve& curve);

}  // namespace lac::sim
