// SPDX-License-Identifier: Apache-2.0
// Spikes and availability.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/units.hpp"
#include "ldp/availability.hpp"
#include "ldp/spike_filter.hpp"

namespace lac {
namespace {

constexpr double kMeasurement_s = 0.25;

/// A lidar with gates along the wind, 13.3 m apart, in a wind that travels with 18 m/s.
struct Gates {
  explicit Gates(int gates, SpikeFilterParams params = {4.0, 1.0})
      : filter(params), state(filter.initial_state()), wind(static_cast<std::size_t>(gates)) {}

  template <class Wind>
  int measure(Wind&& wind_mps, double t) {
    for (std::size_t g = 0; g < wind.size(); ++g) {
      wind[g] = wind_mps(t + (50.0 + 13.3 * static_cast<double>(g)) / 18.0, g);
    }
    return filter.clean(wind, state);
  }
  SpikeFilter filter;
  SpikeFilter::State state;
  std::vector<double> wind;
};

/// Extreme operating gust of IEC 61400-1 at 18 m/s, class IA, 126 m: trough, peak of 9 m/s.
double gust_mps(double t) {
  constexpr double kDuration_s = 10.5, kHeight_mps = 9.0;
  if (t < 0.0 || t > kDuration_s) return 18.0;
  return 18.0 - 0.37 * kHeight_mps * std::sin(3.0 * kPi * t / kDuration_s) *
                    (1.0 - std::cos(2.0 * kPi * t / kDuration_s));
}

// A gust of the standard passes whole; a lidar that measures but once or twice a second loses a few
// of its samples, one with a single gate up to 6 %.
TEST(SpikeFilter, GustPasses) {
  const auto gust = [](double s, std::size_t) { return gust_mps(s); };
  for (const int gates : {1, 10}) {
    for (const double interval_s : {0.25, 0.5, 1.0}) {
      int found = 0, all = 0;
      for (double from_s = 0.0; from_s < interval_s; from_s += 0.1) {
        Gates lidar(gates);
        for (double t = -15.0 + from_s; t < 12.0; t += interval_s, all += gates) {
          found += lidar.measure(gust, t);
        }
      }
      const double share = interval_s < 0.3 ? 0.0 : gates == 1 ? 0.06 : 0.02;
      EXPECT_LE(found, share * all) << gates << " gates, " << interval_s;
    }
  }
}

// A hard target that one of four beams always sees, in seven of ten gates, is found in every
// sample, and nothing beside it.
TEST(SpikeFilter, HardTargetIsFound) {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 0.3);
  Gates lidar(10);
  int found = 0, wrong = 0;
  for (int k = 0; k < 400; ++k) {
    const bool target = k > 10 && k % 4 == 0;
    found += lidar.measure(
        [&](double s, std::size_t g) {
          const bool hit = target && g > 1 && g < 9;
          return hit ? 0.0 : 18.0 + 2.0 * std::sin(0.5 * s) + noise(random);
        },
        k * kMeasurement_s);
    for (std::size_t g = 0; g < 10; ++g) {
      const bool hit = target && g > 1 && g < 9;
      wrong += std::isnan(lidar.wind[g]) != hit ? 1 : 0;
    }
  }
  EXPECT_EQ(found, 7 * 97);
  EXPECT_EQ(wrong, 0);
}

// White turbulence of 2 m/s, far worse than any that is connected in space: with a limit of 4 of
// robust standard deviations that eight values give, few are lost. (Theory for a known
// deviation is 1e-4; the deviation of eight values scatters.)
TEST(SpikeFilter, TurbulencePasses) {
  std::mt19937 random(12);
  std::normal_distribution<double> noise(0.0, 2.0);
  Gates lidar(10);
  int found = 0;
  for (int k = 0; k < 4000; ++k) {
    found += lidar.measure([&](double, std::size_t) { return 18.0 + noise(random); },
                           k * kMeasurement_s);
  }
  EXPECT_LT(found, 0.03 * 40000);
  EXPECT_GT(found, 0);
}

// A front of 10 m/s that stays is believed after four measurements, by one gate and by ten.
TEST(SpikeFilter, AFrontIsBelieved) {
  for (const int gates : {10, 1}) {
    Gates lidar(gates);
    int lost = 0;
    for (int k = 0; k < 60; ++k) {
      const auto front = [](double s, std::size_t) { return s < 10.0 ? 12.0 : 22.0; };
      const int found = lidar.measure(front, k * kMeasurement_s);
      lost += found;
    }
    EXPECT_LE(lost, 4 * gates);
    EXPECT_GT(lost, 0);
  }
}

// Few neighbours, gates that come and go: no verdict rather than a wrong one.
TEST(SpikeFilter, WithoutNeighboursNoVerdict) {
  Gates lidar(1);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(lidar.measure([&](double, std::size_t) { return k == 3 ? 50.0 : 12.0; }, k), 0);
  }
  Gates gone(3);
  EXPECT_EQ(gone.measure([](double, std::size_t) { return std::nan(""); }, 0.0), 0);
  EXPECT_TRUE(std::isnan(gone.wind[0]));
}

// Availability by hand: all, then three of four beams with half of their gates, then silence.
TEST(Availability, CountsWhatDoesNotCome) {
  const Availability::Params p{4, 1.0, 100.0};
  Availability a;
  EXPECT_TRUE(std::isnan(a.value()));
  auto fly = [&, step = 0](int seconds, double share, int beams) mutable {
    for (const int end = step + 80 * seconds; step < end; ++step) {
      a.advance(step * 0.0125, p);
      if (step % 20 == 0 && step / 20 % 4 < beams) a.count(share);
    }
  };
  fly(50, 1.0, 4);
  EXPECT_NEAR(a.value(), 1.0, 1e-12);
  fly(50, 0.5, 3);
  EXPECT_NEAR(a.value(), 0.5 * (1.0 + 0.375), 0.01);
  fly(100, 1.0, 0);
  EXPECT_NEAR(a.value(), 0.6875 * std::exp(-1.0), 0.01);
}

}  // namespace
}  // namespace lac
