// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/filter_fit.hpp"

#include <cmath>
#include <complex>

#include "core/units.hpp"
#include "ffp/low_pass.hpp"
#include "sim_harness/analysis/golden_section.hpp"

namespace lac::sim {
namespace {

constexpr double kLowestDamping = 0.5;
constexpr double kHighestDamping = 1.5;
constexpr int kSections = 40;  // of an interval by the golden section: 1e-8 of it is left

std::complex<double> response(const LowPassDesign& filter, double f_hz) {
  const std::complex<double> s(0.0, f_hz / filter.frequency_hz);
  return filter.order == 1 ? 1.0 / (1.0 + s) : 1.0 / (s * s + 2.0 * filter.damping * s + 1.0);
}

/// Trapezoids over frequency.
template <typename Function>
double integral(const CorrelationCurve& c, Function&& f) {
  double sum = 0.0;
  for (std::size_t i = 1; i < c.k1_radpm.size(); ++i)
    sum += 0.5 * (f(i - 1) + f(i)) * (c.frequency_hz(i) - c.frequency_hz(i - 1));
  return sum;
}

/// The delay falls with the frequency: the lowest log frequency that the lead allows.
double lowest_log_hz(LowPassDesign filter, double first, double last, double delay_frequency_hz,
                     double longest_delay_s) {
  const auto too_slow = [&](double log_hz) {
    filter.frequency_hz = std::exp(log_hz);
    return delay_s(filter, delay_frequency_hz) > longest_delay_s;
  };
  if (!too_slow(first)) return first;
  for (int i = 0; i < kSections; ++i) {
    const double middle = 0.5 * (first + last);
    (too_slow(middle) ? first : last) = middle;
  }
  return last;
}

}  // namespace

double gain_of(const LowPassDesign& filter, double frequency_hz) {
  return filter.order == 1 ? 1.0 / std::hypot(1.0, frequency_hz / filter.frequency_hz)
                           : std::abs(response(filter, frequency_hz));
}

double delay_s(const LowPassDesign& filter, double frequency_hz) {
  return low_pass_delay_s(filter.order, filter.frequency_hz, filter.damping, frequency_hz);
}

double share_left_of_wiener(const CorrelationCurve& c) {
  const std::vector<double> coherence = c.coherence();
  return integral(c, [&](std::size_t i) { return c.s_rr[i] * (1.0 - coherence[i]); }) /
         integral(c, [&](std::size_t i) { return c.s_rr[i]; });
}

double share_left(const CorrelationCurve& c, const LowPassDesign& filter,
                  double delay_frequency_hz) {
  const double forward_s = delay_s(filter, delay_frequency_hz);
  const std::vector<double> gain = c.gain();
  const double missed = integral(c, [&](std::size_t i) {
    const double f_hz = c.frequency_hz(i);
    const auto h = response(filter, f_hz) * std::polar(1.0, radps_from_hz(f_hz) * forward_s);
    return c.s_ll[i] * std::norm(h - gain[i]);
  });
  return share_left_of_wiener(c) + missed / integral(c, [&](std::size_t i) { return c.s_rr[i]; });
}

LowPassDesign fit_low_pass(int order, const CorrelationCurve& c, double delay_frequency_hz,
                           double longest_delay_s) {
  const double first = std::log(c.frequency_hz(0)),
               last = std::log(c.frequency_hz(c.k1_radpm.size() - 1));
  const auto best_of = [&](double damping) {
    LowPassDesign filter{order, 0.0, damping};
    const double lowest = lowest_log_hz(filter, first, last, delay_frequency_hz, longest_delay_s);
    filter.frequency_hz = std::exp(golden_section(lowest, last, kSections, [&](double log_hz) {
      return share_left(c, {order, std::exp(log_hz), damping}, delay_frequency_hz);
    }));
    return filter;
  };
  if (order == 1) return best_of(0.0);
  return best_of(golden_section(kLowestDamping, kHighestDamping, kSections, [&](double damping) {
    return share_left(c, best_of(damping), delay_frequency_hz);
  }));
}

}  // namespace lac::sim
