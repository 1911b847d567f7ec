// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/figures_of_merit.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "sim_harness/analysis/golden_section.hpp"

namespace lac::sim {
namespace {

constexpr int kBisections = 60;
constexpr double kLargestEddy_D[] = {1.0, 1.5, 2.0, 3.0};

/// Polynomial through the points first ... last at x (Lagrange).
double polynomial(const std::vector<double>& x, const std::vector<double>& y, std::size_t first,
                  std::size_t last, double at) {
  double sum = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    double term = y[i];
    for (std::size_t j = first; j <= last; ++j)
      if (j != i) term *= (at - x[j]) / (x[i] - x[j]);
    sum += term;
  }
  return sum;
}

/// Squared distance of |1/(1 + i f/f_c)| from the gain, equal weight per octave.
double misfit(const std::vector<double>& f_hz, const std::vector<double>& gain, double cutoff_hz) {
  double sum = 0.0;
  for (std::size_t i = 0; i < f_hz.size(); ++i) {
    const double d = 1.0 / std::hypot(1.0, f_hz[i] / cutoff_hz) - gain[i];
    sum += d * d;
  }
  return sum;
}

/// Golden section over log f_c between the ends of the curve; empty if an end is best.
std::optional<double> fit(const std::vector<double>& f_hz, const std::vector<double>& gain) {
  const double first = std::log(f_hz.front()), last = std::log(f_hz.back());
  const double best = golden_section(first, last, kBisections, [&](double log_hz) {
    return misfit(f_hz, gain, std::exp(log_hz));
  });
  constexpr double kEnd = 1e-3;
  if (best - first < kEnd || last - best < kEnd) return std::nullopt;
  return std::exp(best);
}

}  // namespace

std::optional<double> first_crossing(const std::vector<double>& x, const std::vector<double>& y,
                                     double level) {
  std::size_t i = 1;
  while (i < x.size() && !(y[i - 1] >= level && y[i] < level)) ++i;
  if (i >= x.size()) return std::nullopt;
  const std::size_t first = i >= 2 ? i - 2 : 0, last = std::min(i + 1, x.size() - 1);
  std::vector<double> log_x(x.size());
  std::ranges::transform(x, log_x.begin(), [](double v) { return std::log(v); });
  double above = log_x[i - 1], below = log_x[i];
  for (int n = 0; n < kBisections; ++n) {
    const double middle = 0.5 * (above + below);
    (polynomial(log_x, y, first, last, middle) >= level ? above : below) = middle;
  }
  return std::exp(0.5 * (above + below));
}

const char* text_of(EddyClass c) {
  switch (c) {
    case EddyClass::kVeryGood:
      return "very good";
    case EddyClass::kGood:
      return "good";
    case EddyClass::kAverage:
      return "average";
    case EddyClass::kSufficient:
      return "sufficient";
    default:
      return "poor";
  }
}

std::optional<double> FiguresOfMerit::smallest_eddy_m() const {
  if (!k05_radpm) return std::nullopt;
  return 2.0 * kPi / *k05_radpm;
}

std::optional<EddyClass> FiguresOfMerit::eddy_class(double rotor_diameter_m) const {
  const std::optional<double> eddy_m = smallest_eddy_m();
  if (!eddy_m) return std::nullopt;
  const auto* limit = std::ranges::find_if(
      kLargestEddy_D, [&](double d) { return *eddy_m <= d * rotor_diameter_m; });
  return static_cast<EddyClass>(limit - std::begin(kLargestEddy_D));
}

FiguresOfMerit figures_of_merit(const CorrelationCurve& curve) {
  const std::vector<double> gain = curve.gain();
  std::vector<double> f_hz;
  for (std::size_t i = 0; i < curve.k1_radpm.size(); ++i) f_hz.push_back(curve.frequency_hz(i));
  return {first_crossing(curve.k1_radpm, curve.coherence(), 0.5),
          first_crossing(f_hz, gain, kMinus3dB), fit(f_hz, gain)};
}

}  // namespace lac::sim
