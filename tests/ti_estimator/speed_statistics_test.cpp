// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/speed_statistics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "core/units.hpp"

namespace lac {
namespace {

/// One beam, one gate, 4 Hz.
StatisticsSpec spec(Window window, Detrending detrending) {
  StatisticsSpec s;
  s.window = window;
  s.detrending = detrending;
  s.window_s = 120.0;
  s.scan_time_s = 0.25;
  s.beams = s.gates = 1;
  return s;
}

/// Statistics of a signal at the end of 600 s.
SpeedStatistics::Series after_600_s(const StatisticsSpec& s,
                                    const std::function<double(double)>& speed_mps) {
  SpeedStatistics statistics(s);
  double t_s = 0.0;
  for (int i = 0; i <= 2400; ++i) {
    t_s = 0.25 * i;
    statistics.expire(t_s);
    const std::array<std::int32_t, 1> row{RunningMoments::quantise(speed_mps(t_s))};
    EXPECT_TRUE(statistics.add(t_s, 0, row));
  }
  EXPECT_TRUE(statistics.has_lasted(t_s));
  return statistics.series(0, 0, t_s);
}

// A sine through the three kinds: the mean of its variance over the phase is what window_response()
// says (equal steps of phase; a sine has one frequency, so eight of them are exact).
TEST(SpeedStatistics, SineLeavesTheResponse) {
  const std::array<StatisticsSpec, 3> kinds{spec(Window::Sliding, Detrending::Mean),
                                            spec(Window::Sliding, Detrending::Linear),
                                            spec(Window::Exponential, Detrending::Mean)};
  for (const StatisticsSpec& s : kinds) {
    for (const double periods : {0.3, 0.8, 1.4, 5.3}) {
      double variance = 0.0;
      for (int phase = 0; phase < 8; ++phase) {
        const auto series = after_600_s(s, [&](double t_s) {
          return 16.0 + 2.0 * std::sin(2.0 * kPi * (periods * t_s / s.window_s + phase / 8.0));
        });
        ASSERT_TRUE(series.filled);
        variance += series.standard_deviation_mps * series.standard_deviation_mps / 8.0;
      }
      EXPECT_NEAR(variance / 2.0, window_response(periods, s.window, s.detrending), 0.01)
          << periods << " periods, window " << static_cast<int>(s.window) << ", detrending "
          << static_cast<int>(s.detrending);
    }
  }
}

// A ramp of 1 m/s per minute is a standard deviation of 0.58 m/s to the plain window and none to
// the detrended one.
TEST(SpeedStatistics, Ramp) {
  const auto ramp = [](double t_s) { return 12.0 + t_s / 60.0; };
  EXPECT_NEAR(after_600_s(spec(Window::Sliding, Detrending::Mean), ramp).standard_deviation_mps,
              2.0 / std::sqrt(12.0), 2e-3);
  EXPECT_LT(after_600_s(spec(Window::Sliding, Detrending::Linear), ramp).standard_deviation_mps,
            1e-4);
}

// Half of the samples are asked for; with every third alone a series does not count.
TEST(SpeedStatistics, MinimumFill) {
  for (const Window window : {Window::Sliding, Window::Exponential}) {
    SpeedStatistics statistics(spec(window, Detrending::Mean));
    const std::array<std::int32_t, 1> row{RunningMoments::quantise(10.0)};
    const std::array<std::int32_t, 1> none{SampleWindow::kNone};
    for (int i = 0; i < 2400; ++i) {
      statistics.expire(0.25 * i);
      statistics.add(0.25 * i, 0, i % 3 == 0 ? row : none);
    }
    EXPECT_FALSE(statistics.series(0, 0, 600.0).filled);
  }
}

}  // namespace
}  // namespace lac
