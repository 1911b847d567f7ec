// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_outages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

constexpr double kInterval_s = 0.25;
constexpr double kErrors = 4.5;  // standard errors; false alarm below 1e-5

LidarMeasurement measurement(int gates) {
  LidarMeasurement m;
  m.gate_count = gates;
  for (LidarGate& g : m.gates) g.valid = true;
  return m;
}

/// Lost or not, one measurement after the other.
std::vector<bool> lost(const OutageParams& p, int count, std::uint64_t seed = 1) {
  Outages outages(p, kInterval_s, seed);
  std::vector<bool> all;
  for (int k = 0; k < count; ++k) {
    LidarMeasurement m = measurement(2);
    outages.strike(m);
    EXPECT_EQ(m.gates[0].valid, m.gates[1].valid);
    all.push_back(!m.gates[0].valid);
  }
  return all;
}

double share_of(const std::vector<bool>& lost) {
  double count = 0.0;
  for (const bool l : lost) count += l;
  return count / static_cast<double>(lost.size());
}

// Whole measurements, independent: the share, and pairs in a row as often as chance has them.
TEST(LidarOutages, Measurements) {
  constexpr int kCount = 200000;
  OutageParams p;
  p.share = 0.1;
  const std::vector<bool> l = lost(p, kCount);
  EXPECT_NEAR(share_of(l), 0.1, kErrors * std::sqrt(0.09 / kCount));
  double pairs = 0.0;
  for (std::size_t k = 1; k < l.size(); ++k) pairs += l[k] && l[k - 1];
  EXPECT_NEAR(pairs / kCount, 0.01, kErrors * std::sqrt(0.01 / kCount) * 1.2);
}

// Gates, independent of each other within a measurement.
TEST(LidarOutages, Gates) {
  constexpr int kCount = 100000;
  OutageParams p;
  p.share = 0.3;
  p.per_gate = true;
  Outages outages(p, kInterval_s, 2);
  double one = 0.0, both = 0.0;
  for (int k = 0; k < kCount; ++k) {
    LidarMeasurement m = measurement(2);
    outages.strike(m);
    one += !m.gates[0].valid;
    both += !m.gates[0].valid && !m.gates[1].valid;
  }
  EXPECT_NEAR(one / kCount, 0.3, kErrors * std::sqrt(0.21 / kCount));
  EXPECT_NEAR(both / kCount, 0.09, kErrors * std::sqrt(0.09 * 0.91 / kCount));
}

// Bursts: mean length 5 s of a geometric distribution (variance L (L - 1) measurements), 20 % of
// all measurements; the share of a chain with correlation rho^k has (1 + rho)/(1 - rho) times the
// variance of independent draws.
TEST(LidarOutages, Bursts) {
  constexpr int kCount = 400000;
  OutageParams p;
  p.burst_share = 0.2;
  p.burst_length_s = 5.0;
  const std::vector<bool> l = lost(p, kCount);
  const double mean = 5.0 / kInterval_s, ends = 1.0 / mean, begins = ends * 0.25;
  const double rho = 1.0 - ends - begins;
  EXPECT_NEAR(share_of(l), 0.2, kErrors * std::sqrt(0.16 / kCount * (1.0 + rho) / (1.0 - rho)));
  double bursts = 0.0, inside = 0.0, longer = 0.0;
  int length = 0;
  for (const bool is_lost : l) {
    if (is_lost) {
      ++length;
    } else if (length > 0) {
      bursts += 1.0;
      inside += length;
      longer += length > 20;
      length = 0;
    }
  }
  EXPECT_NEAR(inside / bursts, mean, kErrors * std::sqrt(mean * (mean - 1.0) / bursts));
  const double tail = std::pow(1.0 - ends, 20.0);
  EXPECT_NEAR(longer / bursts, tail, kErrors * std::sqrt(tail * (1.0 - tail) / bursts));
}

// The first measurement is lost as often as any other: over many seeds, the share.
TEST(LidarOutages, StartsInTheSteadyState) {
  constexpr int kSeeds = 5000;
  OutageParams p;
  p.burst_share = 0.3;
  p.burst_length_s = 10.0;
  double first = 0.0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    first += lost(p, 1, static_cast<std::uint64_t>(seed)).front();
  }
  EXPECT_NEAR(first / kSeeds, 0.3, kErrors * std::sqrt(0.21 / kSeeds));
}

TEST(LidarOutages, OffTakesNothing) {
  EXPECT_EQ(share_of(lost({}, 1000)), 0.0);
}

// Bursts of less than one measurement, and bursts that would have to begin before they end.
TEST(LidarOutages, ImpossibleBursts) {
  const auto error = [](double share, double length_s) {
    OutageParams p;
    p.burst_share = share;
    p.burst_length_s = length_s;
    return test::error_text([&] { Outages(p, 0.5, 1); });
  };
  EXPECT_THAT(error(0.1, 0.4), HasSubstr("expected a mean length of at least 0.5 s"));
  EXPECT_THAT(error(0.8, 1.5), HasSubstr("expected a mean length of at least 2 s"));
}

TEST(LidarOutages, Keys) {
  const test::TempFolder folder;
  const auto read = [&](const std::string& text) {
    YamlReader in = YamlReader::load(folder.write("a.yaml", text));
    const OutageParams p = read_outages(in);
    in.finish();
    return p;
  };
  const OutageParams p = read("{share: 0.05, of: gates, burst_share: 0.1, burst_length_s: 4}");
  EXPECT_TRUE(p.per_gate);
  EXPECT_EQ(p.burst_length_s, 4.0);
  EXPECT_THAT(test::error_text([&] { read("burst_share: 0.1\n"); }),
              HasSubstr("burst_length_s: the key is missing"));
  EXPECT_THAT(test::error_text([&] { read("share: 5\n"); }), HasSubstr("share: found 5, expected"));
}

// Bursts switched off in a case that has them.
TEST(LidarOutages, BurstsSwitchedOff) {
  const test::TempFolder folder;
  YamlReader in = YamlReader::load(folder.write("a.yaml", "{burst_share: 0, burst_length_s: 4}"));
  const OutageParams p = read_outages(in);
  in.finish();
  EXPECT_FALSE(p.enabled());
}

}  // namespace
}  // namespace lac::sim
