// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/filter_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <utility>

#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr double kDelayFrequency_hz = 0.08;
constexpr double kNoLimit_s = 1e3;

/// Spectra over frequency whose |G_RL| is a given gain and whose S_LL falls as that of turbulence
/// does; what the lidar cannot know is a tenth.
template <typename Gain>
CorrelationCurve curve_of(Gain&& gain) {
  CorrelationCurve c{16.0, {}, {}, {}, {}};
  for (int i = 0; i < 120; ++i) {
    const double f_hz = 0.002 * std::pow(1.05, i);
    c.k1_radpm.push_back(radps_from_hz(f_hz) / 16.0);
    const double s_ll = 100.0 / (1.0 + std::pow(f_hz / 0.01, 5.0 / 3.0));
    c.s_ll.push_back(s_ll);
    c.s_rl.emplace_back(gain(f_hz) * s_ll, 0.0);
    c.s_rr.push_back(gain(f_hz) * gain(f_hz) * s_ll / 0.9);
  }
  return c;
}

// Where the rotor follows the lidar without any filter nothing but the unknown tenth is left; a
// filter that lets nothing through leaves everything.
TEST(FilterFit, ShareLeftBetweenNothingAndAll) {
  const CorrelationCurve c = curve_of([](double) { return 1.0; });
  EXPECT_NEAR(share_left_of_wiener(c), 0.1, 1e-12);
  EXPECT_NEAR(share_left(c, {1, 1e6, 0.0}, kDelayFrequency_hz), 0.1, 1e-6);
  EXPECT_NEAR(share_left(c, {2, 1e-6, 0.7}, kDelayFrequency_hz), 1.0, 1e-6);
}

// No filter leaves less than Wiener's, whatever its order, and the fit leaves least of all those
// that the lead allows: none of its neighbours is better.
TEST(FilterFit, NothingNearIsBetter) {
  const CorrelationCurve c = curve_of([](double f) { return std::exp(-f * f / 0.005); });
  for (const auto& [order, longest_s] :
       {std::pair{1, kNoLimit_s}, {1, 1.5}, {2, kNoLimit_s}, {2, 3.0}, {2, 1.5}}) {
    const LowPassDesign best = fit_low_pass(order, c, kDelayFrequency_hz, longest_s);
    const double least = share_left(c, best, kDelayFrequency_hz);
    EXPECT_GT(least, share_left_of_wiener(c));
    EXPECT_LE(delay_s(best, kDelayFrequency_hz), longest_s + 1e-6);
    EXPECT_TRUE(order == 1 || (best.damping >= 0.5 && best.damping <= 1.5));
    for (const double a : {0.97, 1.0, 1.03}) {
      for (const double b : {0.97, 1.0, 1.03}) {
        const LowPassDesign near{order, a * best.frequency_hz, b * best.damping};
        if (delay_s(near, kDelayFrequency_hz) > longest_s || near.damping > 1.5) continue;
        EXPECT_GE(share_left(c, near, kDelayFrequency_hz), least - 1e-9) << longest_s;
      }
    }
  }
}

// A lead that shrinks costs: what is left rises as the filter has to become quicker.
TEST(FilterFit, LessLeadLeavesMore) {
  const CorrelationCurve c = curve_of([](double f) { return std::exp(-f * f / 0.005); });
  double before = 0.0;
  for (const double longest_s : {8.0, 3.0, 2.0, 1.0, 0.5}) {
    const LowPassDesign fit = fit_low_pass(2, c, kDelayFrequency_hz, longest_s);
    const double left = share_left(c, fit, kDelayFrequency_hz);
    EXPECT_GE(left, before - 1e-9);
    before = left;
  }
}

// Delay and gain are those of the transfer function: phase over angular frequency.
TEST(FilterFit, DelayAndGainOfTheTransferFunction) {
  const double f = 0.05;
  for (const LowPassDesign d : {LowPassDesign{1, 0.04, 0.0}, LowPassDesign{2, 0.06, 0.8}}) {
    const std::complex<double> s(0.0, f / d.frequency_hz);
    const auto h = d.order == 1 ? 1.0 / (1.0 + s) : 1.0 / (1.0 + 2.0 * d.damping * s + s * s);
    EXPECT_NEAR(gain_of(d, f), std::abs(h), 1e-12);
    EXPECT_NEAR(delay_s(d, f), -std::arg(h) / radps_from_hz(f), 1e-12);
  }
}

}  // namespace
}  // namespace lac::sim
