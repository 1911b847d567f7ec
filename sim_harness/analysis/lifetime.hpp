// SPDX-License-Identifier: Apache-2.0
// From figures at some wind speeds to those of a life (methods sections 14 and 17).
#pragma once

#include <span>
#include <vector>

namespace lac::sim {

/// How often the ten-minute mean wind speed at hub height is what it is: Weibull, F(v) =
/// 1 - exp(-(v / scale)^shape).
struct WindDistribution {
  double scale_mps = 0.0;
  double shape = 2.0;

  /// Rayleigh (shape 2) of this mean; IEC 61400-1: 0.2 V_ref, 10, 8.5 and 7.5 m/s for the classes
  /// I, II and III. Throws lac::Error unless the mean is above 0.
  static WindDistribution rayleigh(double mean_speed_mps);

  double probability_below(double speed_mps) const;
};

/// Share of the time in the bin of each speed. Bins reach half way to the neighbours, the outer
/// ones as far to their other side (not below 0); one speed alone has a bin 2 m/s wide. The sum is
/// what the bins cover, below 1. Throws lac::Error unless speeds rise.
std::vector<double> bin_probabilities(const WindDistribution& wind,
                                      std::span<const double> speeds_mps);

/// (mean of load^m)^(1/m): one damage-equivalent load of several of equal duration (seeds).
double mean_load(std::span<const double> loads, double woehler_exponent);

/// (sum p_i L_i^m)^(1/m) of loads that refer to one cycle per second: the load that does, once a
/// second of the whole life, the damage of the shares p_i of it; what the bins leave out does none.
double lifetime_load(std::span<const double> loads, std::span<const double> probabilities,
                     double woehler_exponent);

/// sum p_i P_i 8760 h: the energy of a year [unit of the power times h].
double annual_energy(std::span<const double> mean_powers, std::span<const double> probabilities);

}  // namespace lac::sim
