// SPDX-License-Identifier: Apache-2.0
#include "core/lidar_reader.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "core/error.hpp"
#include "support/lidar_scan.hpp"
#include "support/openfast_lidar_host.hpp"

namespace lac {
namespace {

struct Bench {
  explicit Bench(LidarReaderParams p = {}) : reader(std::move(p)), state(reader.initial_state()) {}

  bool read(double time_s) {
    notice.clear();
    return reader.read(swap(), time_s, state, m, notice);
  }
  bool send(double time_s, int beam, double shift_mps = 0.0) {
    LidarMeasurement sent = scan.measure(time_s, beam);
    for (auto& gate : sent.gates) gate.speed_mps += shift_mps;
    write_native_lidar(swap(), sent, true);
    return read(time_s);
  }
  SwapView swap() { return {array.data(), kExtendedArraySize}; }

  std::vector<float> array = std::vector<float>(kExtendedArraySize, 0.0f);
  LidarReader reader;
  LidarReader::State state;
  test::LidarScan scan;
  LidarMeasurement m;
  Notice notice;
};

// A measurement is taken once: not again while its flag stays up with the same time.
TEST(LidarReader, TakesAMeasurementOnce) {
  Bench b;
  EXPECT_TRUE(b.send(1.0, 0));
  EXPECT_FALSE(b.read(1.0125));
  EXPECT_TRUE(b.send(1.25, 1));
  write_native_lidar(b.swap(), {}, false);
  EXPECT_FALSE(b.read(1.2625));
}

// Every error value of the field, NaN, infinity and the implausible are invalid; the rest stays.
TEST(LidarReader, JudgesSamples) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {-99.0, -98.2, 999.0, std::nan(""), inf, -inf, -6.0, 61.0, 1e30}) {
    Bench b;
    LidarMeasurement sent = b.scan.measure(1.0, 0);
    sent.gates[1].speed_mps = bad;
    write_native_lidar(b.swap(), sent, true);
    ASSERT_TRUE(b.read(1.0));
    EXPECT_TRUE(b.m.gates[0].valid);
    EXPECT_FALSE(b.m.gates[1].valid) << bad;
    EXPECT_TRUE(b.m.gates[2].valid);
  }
}

// Geometry that is no number, or a beam across the wind, makes the whole beam invalid.
TEST(LidarReader, JudgesGeometry) {
  Bench b;
  LidarMeasurement sent = b.scan.measure(1.0, 0);
  sent.beam_dir_L = {0.0, 1.0, 0.0};
  write_native_lidar(b.swap(), sent, true);
  ASSERT_TRUE(b.read(1.0));
  EXPECT_FALSE(b.m.gates[0].valid);
  sent = b.scan.measure(1.25, 0);
  sent.yaw_rad = std::nan("");
  write_native_lidar(b.swap(), sent, true);
  ASSERT_TRUE(b.read(1.25));
  EXPECT_FALSE(b.m.gates[0].valid);
}

// Outside the limits of the range a sample is invalid; the limits themselves are inside.
TEST(LidarReader, JudgesRanges) {
  LidarReaderParams p;
  const double per_axis = 1.0 / test::LidarScan().direction(0).x;
  p.min_range_m = static_cast<float>(120.0 * per_axis);
  p.max_range_m = p.min_range_m + 1.0;
  Bench b(p);
  ASSERT_TRUE(b.send(1.0, 0));
  EXPECT_FALSE(b.m.gates[0].valid);
  EXPECT_TRUE(b.m.gates[1].valid);
  EXPECT_FALSE(b.m.gates[2].valid);
  InputFile in =
      InputFile::parse("4 ! NumberOfBeams\n90 ! MinimumRange\n80 ! MaximumRange\n", "ldp.IN");
  EXPECT_THROW(LidarReaderParams::read(in), Error);
}

// A beam that repeats itself to the last bit while the wind moves is stuck; told once, and again
// when it is fresh. The same repetition in steady wind is no fault.
TEST(LidarReader, StuckBeam) {
  Bench b;
  b.swap().set(Rec::HubWindSpeed, 16.0);
  int warnings = 0;
  for (int i = 0; i < 40; ++i) {
    b.send(i * 0.25, i % 4);
    EXPECT_TRUE(b.m.gates[0].valid);
    warnings += b.notice.level();
  }
  EXPECT_EQ(warnings, 0);
  b.swap().set(Rec::HubWindSpeed, 17.0);
  for (int i = 40; i < 80; ++i) {
    b.send(i * 0.25, i % 4);
    EXPECT_FALSE(b.m.gates[0].valid);
    warnings += b.notice.level();
  }
  EXPECT_EQ(warnings, 4);
  b.swap().set(Rec::HubWindSpeed, 16.0);  // wind back where it was: still stuck
  for (int i = 80; i < 84; ++i) {
    b.send(i * 0.25, i % 4);
    EXPECT_FALSE(b.m.gates[0].valid);
    EXPECT_EQ(b.notice.level(), 0);
  }
  b.send(30.0, 0, 0.5);
  EXPECT_TRUE(b.m.gates[0].valid);
  EXPECT_THAT(std::string(b.notice.text()), testing::HasSubstr("beam 0 gives fresh values again"));
}

// A stuck beam that lacks some gates is found all the same.
TEST(LidarReader, StuckBeamWithGaps) {
  Bench b;
  LidarMeasurement sent = b.scan.measure(1.0, 0);
  sent.gates[1].speed_mps = std::nan("");
  for (int i = 0; i < 20; ++i) {
    b.swap().set(Rec::HubWindSpeed, 16.0 + 0.2 * i);
    sent.time_s = 1.0 + i;
    write_native_lidar(b.swap(), sent, true);
    ASSERT_TRUE(b.read(sent.time_s));
    EXPECT_EQ(b.m.gates[0].valid, i < 3) << i;
  }
}

// A carrier-to-noise ratio outside of its limits makes a sample invalid, NaN as well.
TEST(LidarReader, CarrierToNoise) {
  LidarReaderParams p;
  p.min_cnr_db = -22.0;
  p.max_cnr_db = 5.0;
  Bench b(p);
  LidarMeasurement sent = b.scan.measure(1.0, 0);
  const double cnr_db[] = {-22.5, -21.5, 4.5, 5.5, std::nan("")};
  for (std::size_t g = 0; g < 5; ++g) sent.gates[g].cnr_db = cnr_db[g];
  sent.gate_count = 5;
  write_native_lidar(b.swap(), sent, true);
  ASSERT_TRUE(b.read(1.0));
  for (std::size_t g = 0; g < 5; ++g) EXPECT_EQ(b.m.gates[g].valid, g == 1 || g == 2) << g;
}

// Time stamps ahead of the call: not used, told once, and when they are right again.
TEST(LidarReader, Future) {
  Bench b;
  for (const double ahead_s : {0.0, 0.09, 0.2, 2.0, 0.0}) {
    LidarMeasurement sent = b.scan.measure(1.0 + ahead_s, 0);
    write_native_lidar(b.swap(), sent, true);
    const bool was_future = b.state.future;
    ASSERT_TRUE(b.read(1.0));
    EXPECT_EQ(b.m.gates[0].valid, ahead_s < 0.1) << ahead_s;
    EXPECT_EQ(b.notice.level() != 0, was_future != (ahead_s >= 0.1)) << ahead_s;
  }
}

// Error values that repeat themselves are invalid, and no message of a stuck beam.
TEST(LidarReader, RepeatedErrorValuesAreNotStuck) {
  Bench b;
  for (int i = 0; i < 80; ++i) {
    b.swap().set(Rec::HubWindSpeed, 16.0 + 0.1 * i);
    LidarMeasurement sent = b.scan.measure(i * 0.25, i % 4);
    for (auto& gate : sent.gates) gate.speed_mps = 999.0;
    write_native_lidar(b.swap(), sent, true);
    ASSERT_TRUE(b.read(i * 0.25));
    EXPECT_FALSE(b.m.gates[0].valid);
    EXPECT_EQ(b.notice.level(), 0);
  }
}

// A beam id the input file does not know is told once and not used.
TEST(LidarReader, UnknownBeam) {
  Bench b;
  EXPECT_FALSE(b.send(1.0, 7));
  EXPECT_THAT(std::string(b.notice.text()), testing::HasSubstr("beam id 7, expected 0 to 3"));
  EXPECT_FALSE(b.send(1.25, 7));
  EXPECT_EQ(b.notice.level(), 0);
}

// Guo's layout gets range, direction and position from the input file, and its time from the call.
TEST(LidarReader, GuoLayout) {
  InputFile in = InputFile::parse(
      "guo ! LidarLayout\n2 ! NumberOfBeams\n15 -15 ! BeamAzimuth\n0 0 ! BeamElevation\n"
      "120 ! GateRanges\n-1 0 92 ! LidarPosition\n",
      "ldp.IN");
  Bench b(LidarReaderParams::read(in));
  b.swap().set(Rec::LogStart, 165);
  const float block[] = {1, 1, 1, 14.5f, 0, 0, 3.14159265f, 0, 0, 0};
  std::copy(std::begin(block), std::end(block), b.array.begin() + 164);
  ASSERT_TRUE(b.read(3.5));
  EXPECT_EQ(b.m.time_s, 3.5);
  EXPECT_EQ(b.m.gates[0].range_m, 120.0);
  EXPECT_NEAR(b.m.beam_dir_L.y, -std::sin(rad_from_deg(15.0)), 1e-12);
  EXPECT_EQ(b.m.position_I_m.x, -1.0);
  EXPECT_TRUE(b.m.gates[0].valid);
  b.array[164] = 0.0f;
  EXPECT_FALSE(b.read(3.5125));
}

/// A lidar of OpenFAST for ten seconds; gives the number of measurements and calls `each`.
int fly_openfast(Bench& b, const test::OpenFastLidarHost& host,
                 const std::function<void(double)>& each) {
  int count = 0;
  for (long k = 0; k < 1600; ++k) {
    host.fill(b.swap(), k);
    if (!b.read(static_cast<double>(k) * host.time_step_s)) continue;
    ++count;
    each(b.m.time_s);
  }
  return count;
}

LidarReaderParams openfast_params() {
  InputFile in = InputFile::parse(
      "openfast ! LidarLayout\n2 ! InterpolationOrder\n0.25 ! MeasurementInterval\n"
      "-5 ! RotorPositionX\n",
      "ldp.IN");
  return LidarReaderParams::read(in);
}

// OpenFAST's block: error values that are held and extrapolated like all others are invalid for as
// long as they are measured, and the values after them are right at once.
TEST(LidarReader, OpenFastErrorValues) {
  for (const double bad : {-99.0, 999.0, -200.0}) {
    Bench b(openfast_params());
    test::OpenFastLidarHost host;
    host.wind_mps = [bad](double t, double x) { return x < -200.0 && t > 4 && t < 6 ? bad : 12.5; };
    const int count = fly_openfast(b, host, [&](double t) {
      EXPECT_EQ(b.m.gates[0].valid, !(t > 4 && t < 6)) << bad << " at " << t;
      EXPECT_NEAR(b.m.gates[0].speed_mps, host.wind_mps(t, -205.0), 1e-4);
      EXPECT_TRUE(b.m.gates[1].valid);
      EXPECT_EQ(b.m.beam_dir_I().x, -1.0);
    });
    EXPECT_EQ(count, 40);
  }
}

// OpenFAST's block: settled values that stand still while the wind moves are stuck.
TEST(LidarReader, OpenFastStuck) {
  Bench b(openfast_params());
  test::OpenFastLidarHost host;
  host.wind_mps = [](double t, double) { return t < 5.0 ? 12.5 + std::sin(t) : 12.0; };
  fly_openfast(b, host, [&](double t) {
    EXPECT_EQ(b.m.gates[0].valid, t < 7.75) << t;  // three repeats, and the wind elsewhere
    b.swap().set(Rec::HubWindSpeed, t < 7.5 ? 12.0 : 13.0);
  });
}

// Plausible speeds have their own plausible range.
TEST(LidarReader, RangeOfSpeedsIsChecked) {
  InputFile in = InputFile::parse("4 ! NumberOfBeams\n130 ! MaximumSpeed\n", "ldp.IN");
  try {
    LidarReaderParams::read(in);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("ldp.IN:2: MaximumSpeed: found 130, expected a number "
                                             "from 1 to 120"));
  }
}

// Too small an array for the native block is refused at start with both sizes.
TEST(LidarReader, TooSmallAnArray) {
  std::vector<float> array(164, 0.0f);
  const LidarReader reader{LidarReaderParams{}};
  try {
    Notice notice;
    reader.require(SwapView(array.data(), 164), 0.0125, notice);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("the host's array has 164 known records"));
  }
}

}  // namespace
}  // namespace lac
