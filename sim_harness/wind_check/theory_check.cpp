// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/theory_check.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "sim_harness/analysis/quantiles.hpp"
#include "sim_harness/wind/parameter_check.hpp"
#include "sim_harness/wind_check/component_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "wind check";
constexpr int kMostPoints = 900;
constexpr double kShown = 0.95;

void check(const CheckSettings& s) {
  require(s.confidence > 0.0 && s.confidence < 1.0, kWhere, "confidence", s.confidence,
          "above 0 and below 1");
  require(s.spectrum_allowance >= 0.0, kWhere, "spectrum_allowance", s.spectrum_allowance,
          "0 or above");
  require(s.coherence_allowance >= 0.0, kWhere, "coherence_allowance", s.coherence_allowance,
          "0 or above");
}

/// One step, an eighth, a quarter and a half of the width, and a quarter of the height.
std::vector<LatticeSteps> separations_of(const Lattice& l) {
  std::vector<LatticeSteps> all;
  for (const int y : {1, (l.ny - 1) / 8, (l.ny - 1) / 4, (l.ny - 1) / 2}) {
    if (y > 0 && (all.empty() || y > all.back().y)) all.push_back({y, 0});
  }
  all.push_back({0, std::max((l.nz - 1) / 4, 1)});
  return all;
}

BlockTransform transform_of(const GridSpec& g, const CheckSettings& settings) {
  const auto samples = static_cast<std::size_t>(g.nt);
  if (g.periodic) return {samples, g.dt_s, samples, Taper::kNone};
  const double block_s = settings.block_s > 0.0 ? settings.block_s : 0.25 * g.nt * g.dt_s;
  const auto block = 2 * static_cast<std::size_t>(0.5 * block_s / g.dt_s);
  return {samples, g.dt_s, block, Taper::kHamming};
}

std::size_t end_bin_of(const BlockTransform& transform, const CheckSettings& settings) {
  std::size_t end = transform.end_bin();
  while (end > 0 && transform.frequency_hz(end - 1) > settings.max_frequency_hz) --end;
  require(end > transform.first_bin(), kWhere, "max_frequency_hz", settings.max_frequency_hz,
          "a frequency that the field resolves");
  return end;
}

/// Limits that hold so much of the probability.
std::pair<double, double> power_limits(double confidence, const Estimate& e) {
  const double degrees = 2.0 / e.variance;
  return {e.expected * chi_square_quantile(0.5 * (1.0 - confidence), degrees) / degrees,
          e.expected * chi_square_quantile(0.5 * (1.0 + confidence), degrees) / degrees};
}

std::pair<double, double> coherence_limits(double confidence, const Estimate& e) {
  const double reach = normal_quantile(0.5 * (1.0 + confidence)) * std::sqrt(e.variance);
  const double middle = std::atanh(e.expected);
  return {std::tanh(middle - reach), std::tanh(middle + reach)};
}

/// Judges estimates once it is known how many there are.
class Judge {
 public:
  Judge(const CheckSettings& settings, int tests)
      : settings_(settings), confidence_(std::pow(settings.confidence, 1.0 / tests)) {}

  CheckPoint power(const Estimate& e) {
    const auto [least, most] = power_limits(confidence_, e);
    const double allowed = settings_.spectrum_allowance * e.expected;
    return judged(e, power_limits(kShown, e), least - allowed, most + allowed);
  }
  CheckPoint coherence(const Estimate& e) {
    const auto [least, most] = coherence_limits(confidence_, e);
    const double allowed = settings_.coherence_allowance;
    return judged(e, coherence_limits(kShown, e), least - allowed, most + allowed);
  }
  int outside() const { return outside_; }

 private:
  CheckPoint judged(const Estimate& e, std::pair<double, double> shown, double least, double most) {
    const bool inside = e.found >= least && e.found <= most;
    if (!inside) ++outside_;
    return {e.frequency_hz, e.found, e.expected, shown.first, shown.second, inside};
  }

  const CheckSettings& settings_;
  double confidence_;
  int outside_ = 0;
};

/// All of one component.
struct Estimates {
  int component;
  std::vector<Estimate> spectrum;
  Estimate variance;
  std::vector<std::vector<Estimate>> coherences;  // per separation

  int count() const {
    std::size_t n = spectrum.size() + 1;
    for (const auto& bands : coherences) n += bands.size();
    return static_cast<int>(n);
  }
};

CheckPoint root(CheckPoint p) {
  for (double* value : {&p.found, &p.expected, &p.low, &p.high}) *value = std::sqrt(*value);
  return p;
}

void judge_component(const Estimates& e, const std::vector<LatticeSteps>& separations,
                     const Lattice& lattice, Judge& judge, TheoryCheck& to) {
  CheckCurve spectrum;
  spectrum.component = e.component;
  for (const Estimate& band : e.spectrum) spectrum.points.push_back(judge.power(band));
  to.spectra.push_back(std::move(spectrum));
  to.sigmas.push_back(root(judge.power(e.variance)));
  for (std::size_t i = 0; i < separations.size(); ++i) {
    CheckCurve curve{
        e.component, separations[i].y * lattice.dy_m, separations[i].z * lattice.dz_m, {}};
    for (const Estimate& band : e.coherences[i]) curve.points.push_back(judge.coherence(band));
    to.coherences.push_back(std::move(curve));
  }
}

}  // namespace

TheoryCheck check_field(const GriddedWind& wind, const TurbulenceTheory& theory,
                        const CheckSettings& settings) {
  check(settings);
  const GridSampling sampling = sample_grid(wind.grid().spec(), kMostPoints);
  const BlockTransform transform = transform_of(wind.grid().spec(), settings);
  const std::size_t end_bin = end_bin_of(transform, settings);
  const std::vector<LatticeSteps> separations = separations_of(sampling.lattice);

  std::vector<Estimates> all;
  TheoryCheck result;
  for (int component = 0; component < 3; ++component) {
    const ComponentCheck c(wind, theory, component, sampling, transform, end_bin);
    Estimates e{component, c.spectrum(), {}, c.coherence(separations)};
    e.variance = c.variance(e.spectrum);
    result.tests += e.count();
    all.push_back(std::move(e));
  }

  Judge judge(settings, result.tests);
  for (const Estimates& e : all) judge_component(e, separations, sampling.lattice, judge, result);
  result.lowest_hz = transform.frequency_hz(transform.first_bin());
  result.highest_hz = transform.frequency_hz(end_bin - 1);
  result.lattice_points = sampling.lattice.points();
  result.outside = judge.outside();
  return result;
}

}  // namespace lac::sim
