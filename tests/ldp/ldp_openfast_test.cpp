// SPDX-License-Identifier: Apache-2.0
// The built library on OpenFAST's own lidar block, with the shipped input file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/units.hpp"
#include "support/discon_caller.hpp"
#include "support/openfast_lidar_host.hpp"
#include "support/temp_folder.hpp"

#include "support/no_alloc_guard.hpp"  // after <cstdlib>

namespace lac {
namespace {

using test::DisconCaller;
using test::OpenFastLidarHost;
using testing::HasSubstr;

constexpr double kRotor_m = -5.0;
constexpr double kWind_mps = 16.0;

std::string shipped() {
  return LAC_SOURCE_DIR "/config/openfast/ldp.IN";
}

class Flight {
 public:
  explicit Flight(const std::string& in_file = shipped()) : caller("liblac_ldp", in_file) {
    caller.set_time_step(host.time_step_s);
    caller.swap().set(Rec::HubWindSpeed, kWind_mps);
  }
  int step() {
    host.fill(caller.swap(), steps);
    if (spoil) spoil(caller.swap());
    const int fail = caller.call(steps++ == 0 ? 0 : 1);
    messages += fail != 0 ? 1 : 0;
    return fail;
  }
  void run(double seconds) {
    const long end = steps + std::lround(seconds / host.time_step_s);
    while (steps < end) ASSERT_GE(step(), 0) << caller.message();
  }
  double time_s() const { return static_cast<double>(steps - 1) * host.time_step_s; }
  double get(Rec record) { return caller.swap().get(record); }

  OpenFastLidarHost host;
  DisconCaller caller;
  std::function<void(SwapView)> spoil;
  long steps = 0;
  int messages = 0;
};

/// Frozen turbulence: what a point at x sees reaches the rotor (rotor - x)/U later.
double frozen_wind(double t, double x_m) {
  const double arrival_s = t + (kRotor_m - x_m) / kWind_mps;
  return kWind_mps + 1.5 * std::sin(2.0 * kPi * arrival_s / 30.0) +
         0.5 * std::sin(2.0 * kPi * arrival_s / 10.0);
}

// Steady wind: its speed, and as lead what is left of distance over speed after the one step by
// which OpenFAST's values are late.
TEST(LdpOpenFast, SpeedAndLead) {
  Flight f;
  f.run(20.0);
  EXPECT_NEAR(f.get(Rec::LidarRews), kWind_mps, 1e-5);
  EXPECT_NEAR(f.get(Rec::LidarRewsLead), 80.0 / kWind_mps - 0.00625, 1e-5);
  EXPECT_NEAR(f.get(Rec::LidarMeanSpeed), kWind_mps, 1e-5);
  EXPECT_EQ(f.get(Rec::LidarScanWindow), 0.25);
  EXPECT_EQ(f.get(Rec::LidarRewsSamples), 5.0);
  EXPECT_EQ(f.get(Rec::LidarRewsValid), 1.0);
  EXPECT_EQ(f.messages, 0);
}

// Turbulence that travels with the mean wind, hub in motion: at each step the wind that arrives
// after the lead, averaged over the window; no spike of the extrapolation is left in it. What a far
// gate gives is up to 12 s old, in which the mean that carries it has moved a little.
TEST(LdpOpenFast, FrozenTurbulence) {
  Flight f;
  f.host.wind_mps = frozen_wind;
  f.host.hub_m = [](double t) { return 0.5 * std::sin(2.0 * t); };
  f.run(120.0);
  double worst = 0.0, squares = 0.0;
  for (int k = 0; k < 9600; ++k) {
    ASSERT_EQ(f.step(), 0) << f.caller.message();
    ASSERT_EQ(f.get(Rec::LidarRewsValid), 1.0);
    const double middle_s = f.time_s() + f.get(Rec::LidarRewsLead) - 0.125;
    const double error = f.get(Rec::LidarRews) - frozen_wind(middle_s, kRotor_m);
    worst = std::max(worst, std::abs(error));
    squares += error * error;
  }
  EXPECT_LT(worst, 0.1);
  EXPECT_LT(std::sqrt(squares / 9600.0), 0.02);
  EXPECT_EQ(f.messages, 0);
}

// One point, measured once per window, hub in motion: there is a sample in every step.
TEST(LdpOpenFast, OnePointNeverRunsOut) {
  for (const int order : {1, 2}) {
    test::TempFolder folder;
    std::ifstream in(shipped());
    std::string text{std::istreambuf_iterator<char>(in), {}};
    text.replace(text.find("\n2  ") + 1, 1, std::to_string(order));
    Flight f(folder.write("ldp.IN", text));
    f.host.order = order;
    f.host.sensor_type = 1;
    f.host.x_m = {-165.0};
    f.host.wind_mps = frozen_wind;
    f.host.hub_m = [](double t) { return 0.5 * std::sin(2.0 * t); };
    f.run(15.0);
    for (int k = 0; k < 9600; ++k) {
      ASSERT_EQ(f.step(), 0) << f.caller.message();
      ASSERT_GE(f.get(Rec::LidarRewsSamples), 1.0) << f.time_s();
      ASSERT_EQ(f.get(Rec::LidarRewsValid), 1.0);
    }
  }
}

// Gates whose wind comes too soon for the feedforward are left out.
TEST(LdpOpenFast, LeadThatIsNeeded) {
  Flight f;
  f.caller.swap().set(Rec::FeedforwardLeadNeeded, 6.5);
  f.run(20.0);
  EXPECT_NEAR(f.get(Rec::LidarRewsLead), 110.0 / kWind_mps - 0.00625, 1e-5);
  EXPECT_EQ(f.get(Rec::LidarRewsSamples), 4.0);
}

// What OpenFAST's lidars cannot give is refused at the first call, with file, line, key and reason.
TEST(LdpOpenFast, RefusedAtStart) {
  const auto message = [](int type, std::vector<double> x_m) {
    Flight f;
    f.host.sensor_type = type;
    f.host.x_m = std::move(x_m);
    EXPECT_EQ(f.step(), -1);
    return f.caller.message();
  };
  EXPECT_THAT(message(2, {-105.0}), HasSubstr("ldp.IN:5: LidarLayout: found record 2001 is 2"));
  EXPECT_THAT(message(0, {-105.0}), HasSubstr("LidarLayout openfast in the master's input file"));
  EXPECT_THAT(message(3, {45.0, 75.0}), HasSubstr("ldp.IN:8: RotorPositionX: no measured point"));
}

// A block that turns to rubbish: no failure, no speed that never was, a handful of messages.
TEST(LdpOpenFast, RubbishInTheBlock) {
  const float rubbish[] = {std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity(),
                           3e38f,
                           -99.0f,
                           999.0f,
                           0.0f};
  std::mt19937 random(3);
  Flight f;
  f.host.wind_mps = frozen_wind;
  f.run(15.0);
  f.spoil = [&](SwapView swap) {
    if (random() % 20 != 0) return;
    for (unsigned n = random() % 4; n > 0; --n) {
      swap.put(kOpenFastLidarBlock.first + static_cast<int>(random() % 24),
               static_cast<double>(rubbish[random() % 7]));
    }
  };
  for (int k = 0; k < 16000; ++k) {
    ASSERT_GE(f.step(), 0) << f.caller.message();
    if (f.get(Rec::LidarRewsValid) == 1.0) {
      ASSERT_GE(f.get(Rec::LidarRews), -5.0);
      ASSERT_LE(f.get(Rec::LidarRews), 60.0);
    }
  }
  f.spoil = nullptr;
  f.run(700.0);
  EXPECT_EQ(f.get(Rec::LidarRewsValid), 1.0);
  EXPECT_NEAR(f.get(Rec::LidarRews), kWind_mps, 2.1);
}

// Back at a stored state the library repeats itself to the last bit, from the middle of a spike.
TEST(LdpOpenFast, StoreAndRestore) {
  Flight f;
  f.host.wind_mps = frozen_wind;
  f.run(15.0);
  while (f.steps % 40 != 2) f.step();
  ASSERT_EQ(f.caller.call(-11), 0);
  const long stored = f.steps;
  std::vector<double> first, second;
  for (std::vector<double>* record : {&first, &second}) {
    f.steps = stored;
    for (int i = 0; i < 400; ++i) {
      f.step();
      record->push_back(f.get(Rec::LidarRews));
      record->push_back(f.get(Rec::LidarRewsLead));
    }
    ASSERT_EQ(f.caller.call(-10), 0);
  }
  EXPECT_EQ(first, second);
  EXPECT_NE(first[0], first[798]);
}

// No step allocates, not even one that has something to say.
TEST(LdpOpenFast, NoAllocation) {
  if (!test::kCountsAllocations) GTEST_SKIP() << "malloc is out of reach here";
  Flight f;
  f.host.wind_mps = frozen_wind;
  f.run(1.0);
  test::NoAllocGuard guard;
  f.run(15.0);
  f.host.sensor_type = 1;
  f.run(5.0);
  EXPECT_EQ(guard.allocations(), 0U);
  EXPECT_EQ(f.messages, 2);  // another lidar; no valid wind speed
}

}  // namespace
}  // namespace lac
