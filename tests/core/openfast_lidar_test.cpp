// SPDX-License-Identifier: Apache-2.0
#include "core/openfast_lidar.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/openfast_lidar_bench.hpp"

namespace lac {
namespace {

using Bench = test::OpenFastBench;
using test::kOpenFastStep_s;
using test::with_order;
using testing::HasSubstr;

/// Wind that is another one at each measurement, point by point, within 10 and 22 m/s.
double rough_wind(double time_s, double x_m) {
  return 16.0 + 4.0 * std::sin(37.0 * time_s + 0.3 * x_m) + 2.0 * std::sin(101.0 * time_s);
}

// The sequences received from OpenFAST 5.0 at 0.25 s and after, in both orders: the first of them
// that can know it gives the new value, with the time at which it was measured.
TEST(OpenFastLidar, ObservedSequences) {
  const float a = 16.8947f, b = 17.2453f;
  const std::vector<std::vector<float>> sequences = {{a, 17.5958f, b, b, b},
                                                     {a, 17.9463f, a, b, b}};
  for (const int order : {1, 2}) {
    for (const double interval_s : {0.25, 0.0}) {
      Bench bench(with_order(order, interval_s));
      bench.host.x_m = {-205.0};
      for (int k = 0; k < 40; ++k) {
        bench.host.fill(bench.swap(), 0);
        bench.put(openfast_lidar::kFirstSpeed, static_cast<double>(a));
        EXPECT_EQ(bench.fetch(), k == 0);
      }
      int news = 0;
      for (const float received : sequences[static_cast<std::size_t>(order - 1)]) {
        bench.put(openfast_lidar::kFirstSpeed, static_cast<double>(received));
        if (!bench.fetch()) continue;
        ++news;
        EXPECT_EQ(bench.step, 42);  // the call at 0.25625 s
        EXPECT_DOUBLE_EQ(bench.m.time_s, 0.25);
        EXPECT_NEAR(bench.m.gates[0].speed_mps, static_cast<double>(b), 1e-4);
      }
      EXPECT_EQ(news, 1) << order << " " << interval_s;
    }
  }
}

// Ten minutes, hub in motion: every measurement once, at its time, speed and distance as measured.
TEST(OpenFastLidar, LongRunGivesTheTruth) {
  for (const int order : {1, 2}) {
    for (const double interval_s : {0.25, 0.0}) {
      Bench bench(with_order(order, interval_s));
      bench.host.order = order;
      bench.host.wind_mps = rough_wind;
      bench.host.hub_m = [](double t) { return 0.6 * std::sin(2.0 * t); };
      long count = 0;
      for (long k = 0; k < 96000; ++k) {
        if (!bench.call()) continue;
        const double t = 0.25 * static_cast<double>(count++);
        ASSERT_NEAR(bench.m.time_s, t, 1e-9);
        ASSERT_EQ(bench.m.gate_count, 5);
        for (std::size_t i = 0; i < 5; ++i) {
          const auto [speed_mps, x_m] = bench.host.held(k - 1, i);
          ASSERT_NEAR(bench.m.gates[i].speed_mps, speed_mps, 1e-5);
          ASSERT_NEAR(bench.m.gates[i].range_m, -5.0 - x_m, 5e-5);
          ASSERT_TRUE(bench.m.gates[i].valid);
        }
      }
      EXPECT_EQ(count, 2400);
      EXPECT_TRUE(bench.messages.empty()) << bench.messages[0];
    }
  }
}

// A lidar that measures in every step: one measurement per call, one step old, without a ripple.
TEST(OpenFastLidar, EveryStep) {
  for (const int order : {1, 2}) {
    for (const double interval_s : {kOpenFastStep_s, 0.0}) {
      Bench bench(with_order(order, interval_s));
      bench.host.order = order;
      bench.host.steps_per_measurement = 1;
      bench.host.wind_mps = rough_wind;
      EXPECT_TRUE(bench.call());
      bench.call();  // carries the same as the first
      for (long k = 2; k < 2000; ++k) {
        ASSERT_TRUE(bench.call());
        ASSERT_NEAR(bench.m.time_s, static_cast<double>(k - 1) * kOpenFastStep_s, 1e-9);
        ASSERT_NEAR(bench.m.gates[2].speed_mps, bench.host.held(k - 1, 2).first, 1e-5);
      }
      EXPECT_TRUE(bench.messages.empty());
    }
  }
}

// A measurement that OpenFAST skips: with the interval the held value is taken once more, without
// it nothing new is seen.
TEST(OpenFastLidar, SkippedMeasurement) {
  for (const double interval_s : {0.25, 0.0}) {
    Bench bench(with_order(2, interval_s));
    bench.host.wind_mps = rough_wind;
    bench.host.skips = [](long step) { return step == 80; };
    std::vector<double> times, speeds;
    for (int k = 0; k < 160; ++k) {
      if (!bench.call()) continue;
      times.push_back(bench.m.time_s);
      speeds.push_back(bench.m.gates[0].speed_mps);
    }
    if (interval_s > 0.0) {
      EXPECT_EQ(times, (std::vector<double>{0.0, 0.25, 0.5, 0.75}));
      EXPECT_NEAR(speeds[2], speeds[1], 1e-5);
    } else {
      EXPECT_EQ(times, (std::vector<double>{0.0, 0.25, 0.75}));
    }
    EXPECT_NEAR(speeds.back(), rough_wind(0.75, -205.0), 1e-5);
  }
}

// Steady wind: with the interval measurements go on, without it none can be told from the last.
TEST(OpenFastLidar, SteadyWind) {
  Bench scheduled(with_order(2)), by_change(with_order(2, 0.0));
  int news = 0, changes = 0;
  for (int k = 0; k < 1600; ++k) {
    news += scheduled.call() ? 1 : 0;
    changes += by_change.call() ? 1 : 0;
  }
  EXPECT_EQ(news, 40);
  EXPECT_EQ(changes, 1);
}

// A controller step of 4 DT with measurements on its grid: values taken as they come are clean.
TEST(OpenFastLidar, LongControllerStepNeedsNoInverse) {
  for (const double interval_s : {0.25, 0.0}) {
    Bench bench(with_order(0, interval_s));
    bench.host.wind_mps = rough_wind;
    int news = 0;
    for (long k = 0; k < 400; ++k) {
      bench.host.fill(bench.swap(), 4 * k);
      bench.notice.clear();
      const double time_s = static_cast<double>(k) * 4.0 * kOpenFastStep_s;
      if (!bench.lidar.fetch(bench.swap(), time_s, bench.state, bench.m, bench.notice)) continue;
      EXPECT_EQ(bench.notice.level(), 0) << bench.notice.text();
      ASSERT_NEAR(bench.m.time_s, 0.25 * news++, 1e-9);
      ASSERT_NEAR(bench.m.gates[4].speed_mps, rough_wind(bench.m.time_s, -85.0), 1e-5);
    }
    EXPECT_EQ(news, 40);
  }
}

// Points at or behind the rotor are invalid and told once; those ahead go on.
TEST(OpenFastLidar, PointsBehindTheRotor) {
  Bench bench(with_order(2));
  bench.host.x_m = {-65.0, -35.0, -5.0, 25.0, 55.0};
  EXPECT_EQ(bench.start_error(), "no error");
  for (int k = 0; k < 200; ++k) bench.call();
  EXPECT_TRUE(bench.m.gates[0].valid);
  EXPECT_EQ(bench.m.gates[0].range_m, 60.0);
  EXPECT_TRUE(bench.m.gates[1].valid);
  for (std::size_t i = 2; i < 5; ++i) {
    EXPECT_FALSE(bench.m.gates[i].valid);
    EXPECT_EQ(bench.m.gates[i].range_m, 0.0);
  }
  ASSERT_EQ(bench.messages.size(), 1U);
  EXPECT_THAT(bench.messages[0], HasSubstr("3 of 5 points are at or behind the rotor"));
}

// Another lidar in mid-run is not used and told once; back as it was, it is used after a pause.
TEST(OpenFastLidar, ChangedHeader) {
  Bench bench(with_order(2));
  for (int k = 0; k < 100; ++k) bench.call();
  for (int k = 0; k < 100; ++k) {
    bench.host.fill(bench.swap(), bench.step);
    bench.put(2, k < 50 ? 4.0 : std::nan(""));
    EXPECT_FALSE(bench.fetch());
  }
  ASSERT_EQ(bench.messages.size(), 1U);
  EXPECT_THAT(bench.messages[0], HasSubstr("says sensor type 3, 1 beams, 4 gates, at the start it "
                                           "said 3, 1, 5"));
  for (int k = 0; k < 100; ++k) bench.call();
  EXPECT_TRUE(bench.m.gates[0].valid);
  EXPECT_EQ(bench.messages.size(), 1U);
}

// A bad speed or position costs its own point until it is forgotten, and no other.
TEST(OpenFastLidar, GarbageInOnePoint) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const int offset : {5, 10}) {  // speed and x of the second point
    for (const double bad : {std::nan(""), inf, -inf, 3e38}) {
      Bench bench(with_order(2));
      bench.host.wind_mps = rough_wind;
      int invalid = 0;
      for (int k = 0; k < 400; ++k) {
        bench.host.fill(bench.swap(), bench.step);
        if (k >= 75 && k < 85) bench.put(offset, bad);
        if (!bench.fetch()) continue;
        EXPECT_TRUE(bench.m.gates[0].valid && bench.m.gates[2].valid);
        invalid += bench.m.gates[1].valid ? 0 : 1;
      }
      EXPECT_EQ(invalid, 1) << offset << " " << bad;
      EXPECT_TRUE(bench.m.gates[1].valid);
      EXPECT_NEAR(bench.m.gates[1].speed_mps, rough_wind(2.25, -175.0), 1e-5);
      EXPECT_NEAR(bench.m.gates[1].range_m, 170.0, 1e-4);
      EXPECT_TRUE(bench.messages.empty());
    }
  }
}

// An order that is not the host's is told once, with the right one; so is another interval.
TEST(OpenFastLidar, WrongOrderOrIntervalIsTold) {
  const auto messages = [](int host_order, OpenFastLidarParams p) {
    Bench bench(std::move(p));
    bench.host.order = host_order;
    bench.host.wind_mps = rough_wind;
    for (int k = 0; k < 20000; ++k) bench.call();
    EXPECT_LE(bench.messages.size(), 1U);
    return bench.messages.empty() ? "" : bench.messages[0];
  };
  EXPECT_THAT(messages(2, with_order(1)), HasSubstr("is 1, but the speeds come as from order 2"));
  EXPECT_THAT(messages(1, with_order(2)), HasSubstr("is 2, but the speeds come as from order 1"));
  EXPECT_THAT(messages(1, with_order(0, 0.0)),
              HasSubstr("is 0, but the speeds come as from order 1"));
  EXPECT_THAT(messages(0, with_order(1, 0.0)),
              HasSubstr("is 1, but the speeds come as from order 0"));
  EXPECT_EQ(messages(2, with_order(2)), "");
  EXPECT_THAT(messages(2, with_order(2, 0.2)),
              HasSubstr("between the multiples of MeasurementInterval, "
                        "0.2 s"));
}

// A loaded state continues to the last bit, in the middle of a spike.
TEST(OpenFastLidar, StateContinuesExactly) {
  const auto hub_m = [](double t) { return 0.6 * std::sin(2.0 * t); };
  Bench first(with_order(2));
  first.host.wind_mps = rough_wind;
  first.host.hub_m = hub_m;
  for (int k = 0; k < 42; ++k) first.call();
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  first.state.visit(save);

  Bench second(with_order(2));
  second.host.wind_mps = rough_wind;
  second.host.hub_m = hub_m;
  second.step = first.step;
  StateArchive load{std::span<const std::byte>(bytes)};
  second.state.visit(load);
  ASSERT_TRUE(load.complete());
  for (int k = 0; k < 200; ++k) {
    const bool is_new = first.call();
    ASSERT_EQ(second.call(), is_new);
    if (!is_new) continue;
    ASSERT_EQ(second.m.time_s, first.m.time_s);
    for (std::size_t i = 0; i < 5; ++i) {
      ASSERT_EQ(second.m.gates[i].speed_mps, first.m.gates[i].speed_mps);
      ASSERT_EQ(second.m.gates[i].range_m, first.m.gates[i].range_m);
    }
  }
}

}  // namespace
}  // namespace lac
