// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/disk_mean.hpp"

#include <cmath>

#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr int kPoints = 48;
constexpr int kPanels = 200;  // of Simpson's rule, even
constexpr double kSeriesBelow = 1e-3;

/// ∫_0^r s exp(-c s) ds.
double within(double rate_per_m, double r_m) {
  const double x = rate_per_m * r_m;
  const double share =
      x < kSeriesBelow ? 0.5 - x / 3.0 + x * x / 8.0 : (1.0 - (1.0 + x) * std::exp(-x)) / (x * x);
  return share * r_m * r_m;
}

}  // namespace

double disk_mean(double rate_per_m, double radius_m, double distance_m) {
  if (radius_m == 0.0) return std::exp(-rate_per_m * distance_m);
  const double near_m = std::abs(radius_m - distance_m), far_m = radius_m + distance_m;
  const double difference = radius_m * radius_m - distance_m * distance_m;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double t = (i + 0.5) * kPi / kPoints;
    const double r_m = 0.5 * (far_m + near_m) - 0.5 * (far_m - near_m) * std::cos(t);
    sum += within(rate_per_m, r_m) * (r_m * r_m + difference) /
           (r_m * std::sqrt((r_m + near_m) * (r_m + far_m)));
  }
  return 2.0 * sum / (kPoints * radius_m * radius_m);
}

double disk_mean_of_pairs(double rate_per_m, double radius_m) {
  double sum = 0.0;
  for (int i = 1; i < kPanels; ++i) {  // r = 2 R cos(phi); nothing at both ends
    const double phi = 0.5 * kPi * i / kPanels, c = std::cos(phi), s = std::sin(phi);
    const double weight = i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * c * s * (phi - c * s) * std::exp(-2.0 * rate_per_m * radius_m * c);
  }
  return 8.0 / 3.0 * sum / kPanels;
}

}  // namespace lac::sim
