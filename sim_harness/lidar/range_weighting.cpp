// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/range_weighting.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace lac::sim {
namespace {

constexpr double kReach = 3.0;          // standard deviations that the weighting covers
constexpr double kWidestSpacing = 1.5;  // of quadrature points, in standard deviations
constexpr int kMostPoints = 201;
constexpr int kFewestPoints = 5;
constexpr int kLorentzianPoints = 21;
constexpr double kShortest_m = 0.01;
constexpr double kLongest_m = 1e5;

Range length_m() {
  return Range::between(kShortest_m, kLongest_m);
}

/// Not an int: it may be too large for one.
double fewest_points(const RangeWeighting& w, double spacing) {
  return 2.0 * std::ceil(w.reach_m() / (spacing * w.sigma_m()) - 1e-9) + 1.0;
}

int read_points(YamlReader& in, int fallback, int fewest) {
  const int points = in.integer("weighting_points", fallback, Range::between(fewest, kMostPoints));
  if (points % 2 == 0) in.fail("weighting_points", "expected an odd number");
  return points;
}

RangeWeighting read_gaussian(YamlReader& in) {
  RangeWeighting w;
  w.fwhm_m = in.number("fwhm_m", Range::between(0.0, kLongest_m));
  if (w.fwhm_m > 0.0 && w.fwhm_m < kShortest_m) {
    in.fail("fwhm_m", "expected 0 (a point) or at least 0.01");
  }
  w.points = read_points(in, w.points, kFewestPoints);
  return w;
}

RangeWeighting read_pulse(YamlReader& in) {
  RangeWeighting w;
  w.kind = ProbeKind::kPulse;
  w.pulse_length_m = in.number("pulse_length_m", length_m());
  w.gate_length_m = in.number("gate_length_m", length_m());
  const double fewest = fewest_points(w, kWidestSpacing);
  if (fewest > kMostPoints) {
    in.fail("gate_length_m", "the gate is so much longer than the pulse that more than " +
                                 std::to_string(kMostPoints) + " weighting points were needed");
  }
  const double usual = std::min(fewest_points(w, 1.0), static_cast<double>(kMostPoints));
  w.points = read_points(in, static_cast<int>(usual), static_cast<int>(fewest));
  return w;
}

RangeWeighting read_lorentzian(YamlReader& in) {
  RangeWeighting w;
  w.kind = ProbeKind::kLorentzian;
  w.rayleigh_length_m = in.number("rayleigh_length_m", length_m());
  w.rayleigh_at_m = in.number("rayleigh_at_m", length_m());
  w.reach_rayleigh =
      in.number("reach_rayleigh_lengths", w.reach_rayleigh, Range::between(1.0, 1000.0));
  w.points = read_points(in, kLorentzianPoints, kFewestPoints);
  return w;
}

}  // namespace

double RangeWeighting::sigma_m() const {
  return (kind == ProbeKind::kPulse ? pulse_length_m : fwhm_m) /
         (2.0 * std::sqrt(2.0 * std::log(2.0)));
}

double RangeWeighting::rayleigh_m(double range_m) const {
  const double ratio = range_m / rayleigh_at_m;
  return rayleigh_length_m * ratio * ratio;
}

double RangeWeighting::reach_m() const {
  return kReach * sigma_m() + (kind == ProbeKind::kPulse ? 0.5 * gate_length_m : 0.0);
}

double RangeWeighting::shape(double s_m) const {
  if (kind == ProbeKind::kPulse) {
    const double scale = 1.0 / (sigma_m() * std::sqrt(2.0));
    return std::erf((s_m + 0.5 * gate_length_m) * scale) -
           std::erf((s_m - 0.5 * gate_length_m) * scale);
  }
  const double s = s_m / sigma_m();
  return std::exp(-0.5 * s * s);
}

RangeWeighting read_range_weighting(YamlReader& in) {
  switch (in.choice("probe", 0, {"gaussian", "pulse", "continuous_wave", "point"})) {
    case 0:
      return read_gaussian(in);
    case 1:
      return read_pulse(in);
    case 2:
      return read_lorentzian(in);
    default: {
      RangeWeighting point;
      point.fwhm_m = 0.0;
      return point;
    }
  }
}

}  // namespace lac::sim
