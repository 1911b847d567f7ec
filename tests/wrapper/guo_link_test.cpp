// SPDX-License-Identifier: Apache-2.0
// Guo-type secondaries: what they find at record 63, and what becomes of their results.
#include "wrapper/guo_link.hpp"

#include <cmath>
#include <limits>

#include "core/native_path.hpp"
#include "support/lidar_scan.hpp"
#include "wrapper/chain_fixture.hpp"

namespace lac::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr int kBlock = kPrivateGuoBlock.first;
constexpr int kGates = guo_lidar::kMaxGates;  // as announced with our own lidar layout
constexpr int kSpeeds = kBlock + guo_lidar::kFirstSpeed;
constexpr int kResults = kSpeeds + kGates + 6;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// The link on an array that the test fills as HostLink would.
class GuoLinkAlone : public testing::Test {
 protected:
  void use(HostLidar layout) {
    WrapperParams params;
    params.lidar = layout;
    link = std::make_unique<GuoLink>(params);
    state = link->initial_state();
    view().set(Rec::TimeStep, 0.1);
  }
  SwapView view() { return array.view(); }

  /// One call in which the host sends this measurement, or none.
  void call(const LidarMeasurement* m) {
    time_s += 0.1;
    write_native_lidar(view(), m != nullptr ? *m : LidarMeasurement{}, m != nullptr);
    link->fill(array, 0, time_s, state, notice);
  }
  LidarMeasurement measurement(double speed_mps, int gates = 3) {
    LidarMeasurement m;
    m.time_s = time_s;
    m.gate_count = gates;
    m.position_I_m = {0.0, 0.0, 90.0};
    for (int g = 0; g < gates; ++g) {
      m.gates[static_cast<std::size_t>(g)] = {100.0 + 50.0 * g, speed_mps + g, true, 0.0};
    }
    return m;
  }
  void announce(double speed_mps) {
    const LidarMeasurement m = measurement(speed_mps);
    call(&m);
  }
  std::vector<float> records(int first, int count) {
    return {array.record(first), array.record(first) + count};
  }
  /// What their chain would write behind the block.
  void results(float rews, float buffered, float rate, float filtered) {
    const std::array<float, 4> all{rews, buffered, rate, filtered};
    std::copy(all.begin(), all.end(), array.record(kResults));
  }
  float get(Rec r) { return *array.record(static_cast<int>(r)); }

  PrivateArray array;
  std::unique_ptr<GuoLink> link;
  GuoLink::State state;
  Notice notice;
  double time_s = 0.0;
};

// A native measurement as their simulator would send it: flag, beam, gates, speeds, attitude,
// velocity. The flag is up for one call.
TEST_F(GuoLinkAlone, NativeMeasurement) {
  use(HostLidar::Native);
  LidarMeasurement m = measurement(12.0);
  m.beam_id = 2;
  m.roll_rad = 0.01;
  m.pitch_rad = 0.02;
  m.yaw_rad = 3.1;
  m.velocity_I_mps = {0.5, -0.25, 0.125};
  m.gates[2].valid = false;
  call(&m);
  EXPECT_THAT(records(kBlock, 6), ElementsAre(1.0f, 2.0f, kGates, 12.0f, 13.0f, -99.0f));
  EXPECT_THAT(records(kSpeeds + kGates, 6), ElementsAre(0.01f, 0.02f, 3.1f, 0.5f, -0.25f, 0.125f));
  call(nullptr);
  EXPECT_THAT(records(kBlock, 4), ElementsAre(0.0f, 2.0f, kGates, 12.0f));
  EXPECT_EQ(notice.level(), 0) << notice.text();
}

// The same measurement, its flag still up in the next call, counts once.
TEST_F(GuoLinkAlone, FlagThatStaysUp) {
  use(HostLidar::Native);
  const LidarMeasurement m = measurement(12.0);
  call(&m);
  EXPECT_EQ(*array.record(kBlock), 1.0f);
  call(&m);
  EXPECT_EQ(*array.record(kBlock), 0.0f);
}

// The number of gates is the same from the first call on, whatever is measured: one of theirs takes
// its memory by it. What is not measured holds the error value.
TEST_F(GuoLinkAlone, NumberOfGatesNeverChanges) {
  use(HostLidar::Native);
  call(nullptr);
  EXPECT_THAT(records(kBlock, 3), ElementsAre(0.0f, 0.0f, kGates));
  *array.record(kResults) = 9.5f;
  const LidarMeasurement fewer = measurement(14.0, 2);
  call(&fewer);
  EXPECT_THAT(records(kBlock, 6), ElementsAre(1.0f, 0.0f, kGates, 14.0f, 15.0f, -99.0f));
  EXPECT_EQ(*array.record(kSpeeds + kGates - 1), -99.0f);
  const LidarMeasurement more = measurement(16.0, 5);
  call(&more);
  EXPECT_THAT(records(kBlock, 8),
              ElementsAre(1.0f, 0.0f, kGates, 16.0f, 17.0f, 18.0f, 19.0f, 20.0f));
  EXPECT_EQ(*array.record(kResults), 9.5f);
}

// Their LDP would take the error value of its gate for a wind speed: such a measurement is kept
// from it. Invalid by flag, and by value.
TEST_F(GuoLinkAlone, InvalidFirstGateIsNotAnnounced) {
  use(HostLidar::Native);
  LidarMeasurement m = measurement(12.0);
  m.gates[0].valid = false;
  call(&m);
  EXPECT_EQ(*array.record(kBlock), 0.0f);
  for (const double speed : {-99.0, 999.0, 61.0, std::nan("")}) {
    announce(speed);
    EXPECT_EQ(*array.record(kBlock), 0.0f) << speed;
  }
  announce(12.0);
  EXPECT_EQ(*array.record(kBlock), 1.0f);
}

// A block of the host's is copied with all it says, without the results that stand there.
TEST_F(GuoLinkAlone, HostsBlockIsCopied) {
  use(HostLidar::Guo);
  for (int i = 0; i < 16; ++i) *array.record(165 + i) = 0.5f * static_cast<float>(i);
  *array.record(165) = 1.0f;
  *array.record(167) = 2.0f;  // gates
  link->fill(array, 165, 0.0, state, notice);
  std::vector<float> expected = records(165, 11);
  EXPECT_EQ(records(kBlock, 11), expected);
  EXPECT_EQ(records(kBlock + 11, 4), std::vector<float>(4, 0.0f));
  *array.record(165) = 0.0f;
  link->fill(array, 165, 0.1, state, notice);
  EXPECT_EQ(*array.record(kBlock), 0.0f);
  EXPECT_EQ(notice.level(), 0) << notice.text();
}

// No block, or one with another number of gates: said once, nothing announced.
TEST_F(GuoLinkAlone, HostsBlockIsNotThere) {
  use(HostLidar::Guo);
  link->fill(array, 0, 0.0, state, notice);
  EXPECT_EQ(notice.level(), 1);
  EXPECT_THAT(std::string(notice.text()), HasSubstr("record 63 (0) of the host is not the start"));
  EXPECT_THAT(records(kBlock, 3), ElementsAre(0.0f, 0.0f, 1.0f));
  notice.clear();
  link->fill(array, 0, 0.1, state, notice);
  EXPECT_EQ(notice.level(), 0);
}

// Nothing counts before there is something: no REWS, feedforward off.
TEST_F(GuoLinkAlone, BeforeTheFirstMeasurement) {
  use(HostLidar::Native);
  call(nullptr);
  link->give(array, state);
  EXPECT_TRUE(std::isnan(get(Rec::LidarRews)));
  EXPECT_EQ(get(Rec::LidarRewsValid), 0.0f);
  EXPECT_EQ(get(Rec::FeedforwardPitchRate), 0.0f);
  EXPECT_EQ(get(Rec::FeedforwardActive), 0.0f);
  EXPECT_EQ(get(Rec::FeedforwardReason), 1.0f);
}

// The REWS is passed on if it is a wind speed, and for ten seconds after a measurement.
TEST_F(GuoLinkAlone, RewsAndItsValidity) {
  use(HostLidar::Native);
  announce(12.0);
  for (const float bad : {0.0f, 999.0f, -99.0f, 101.0f, kNan}) {
    results(bad, 0.0f, 0.0f, 0.0f);
    link->give(array, state);
    EXPECT_EQ(get(Rec::LidarRewsValid), 0.0f) << bad;
    EXPECT_TRUE(std::isnan(get(Rec::LidarRews)));
  }
  results(12.5f, 0.0f, 0.0f, 0.0f);
  for (int step = 0; step <= 105; ++step) {
    link->give(array, state);
    const bool fresh = step < 100;
    EXPECT_EQ(get(Rec::LidarRewsValid), fresh ? 1.0f : 0.0f) << step;
    EXPECT_EQ(std::isnan(get(Rec::LidarRews)), !fresh);
    EXPECT_NEAR(get(Rec::LidarDataAge), 0.1 * step, 1e-5);
    call(nullptr);
  }
}

// The pitch rate is passed on from the second call on in which their buffer gives a wind speed: the
// step from what it was filled with, 0 or 999, would be a huge pulse.
TEST_F(GuoLinkAlone, PulseOfTheFullBufferIsKeptBack) {
  for (const float filling : {0.0f, 999.0f}) {
    use(HostLidar::Native);
    array = PrivateArray();
    view().set(Rec::TimeStep, 0.1);
    announce(12.0);
    results(12.0f, filling, 0.0f, 12.0f);
    link->give(array, state);
    EXPECT_EQ(get(Rec::FeedforwardActive), 0.0f);
    announce(12.0);
    results(12.0f, 12.0f, 1.6f, 12.0f);
    link->give(array, state);
    EXPECT_EQ(get(Rec::FeedforwardPitchRate), 0.0f);
    announce(12.1);
    results(12.1f, 12.0f, 0.25f, 12.05f);
    link->give(array, state);
    EXPECT_EQ(get(Rec::FeedforwardPitchRate), 0.25f);
    EXPECT_EQ(get(Rec::FeedforwardActive), 1.0f);
    EXPECT_EQ(get(Rec::FeedforwardReason), 0.0f);
    EXPECT_EQ(get(Rec::RewsBuffered), 12.0f);
    EXPECT_EQ(get(Rec::RewsFiltered), 12.05f);
  }
}

// Off again with rates no pitch drive could mean, and while the lidar is silent.
TEST_F(GuoLinkAlone, ImplausibleRates) {
  use(HostLidar::Native);
  for (int i = 0; i < 2; ++i) {
    announce(12.0 + i);
    results(12.0f, 12.0f, 0.1f, 12.0f);
    link->give(array, state);
  }
  EXPECT_EQ(get(Rec::FeedforwardActive), 1.0f);
  for (const float bad : {2.1f, -2.1f, kNan}) {
    results(12.0f, 12.0f, bad, 12.0f);
    link->give(array, state);
    EXPECT_EQ(get(Rec::FeedforwardActive), 0.0f) << bad;
    EXPECT_EQ(get(Rec::FeedforwardPitchRate), 0.0f);
  }
  results(12.0f, 12.0f, 0.1f, 12.0f);
  for (int step = 0; step < 101; ++step) call(nullptr);
  link->give(array, state);
  EXPECT_EQ(get(Rec::FeedforwardActive), 0.0f);
}

// Records that a library of ours writes are left to it, and its REWS, while it is valid, is what
// their FFP reads.
TEST_F(GuoLinkAlone, OursGoFirst) {
  use(HostLidar::Native);
  announce(12.0);
  view().set(Rec::LidarRews, 13.5);
  view().set(Rec::LidarRewsValid, 1.0);
  link->take(array, state);
  EXPECT_EQ(*array.record(kResults), 13.5f);
  results(11.0f, 0.0f, 0.0f, 0.0f);
  link->give(array, state);
  EXPECT_EQ(get(Rec::LidarRews), 13.5f);
  view().set(Rec::LidarRewsValid, 0.0);
  view().set(Rec::LidarRews, std::nan(""));
  link->take(array, state);
  EXPECT_EQ(*array.record(kResults), 11.0f);
  view().set(Rec::FeedforwardPitchRate, 0.03);
  link->give(array, state);
  EXPECT_EQ(get(Rec::FeedforwardPitchRate), 0.03f);
}

class GuoSecondaries : public ChainTest {
 protected:
  /// Their LDP and FFP (toy_guo), then a controller that shows what it sees: record 63, LidarRews,
  /// FeedforwardPitchRate, FeedforwardActive.
  std::string chain(const std::string& keys = "native ! LidarLayout -\n") {
    return write_chain(
        {{"ldp", "toy_guo", "", "LDP"},
         {"ffp", "toy_guo", "", "FFP"},
         {"eye", "toy_script", "add 41 63 0\nadd 46 3303 0\nadd 47 3321 0\nadd 48 3323 0\n", ""}},
        keys + "ldp ffp ! GuoSecondaries -\n");
  }
  static void scan(TestHost& host, int step, double speed_mps) {
    LidarMeasurement m;
    m.time_s = 0.0125 * step;
    m.gate_count = 2;
    m.position_I_m = {0.0, 0.0, 90.0};
    m.gates[0] = {100.0, speed_mps, true, 0.0};
    m.gates[1] = {150.0, speed_mps, true, 0.0};
    write_native_lidar({host.array.data(), kExtendedArraySize}, m, true);
  }
};

// Through the C boundary, a wind that rises by 0.01 m/s a step: 0.02 rad per m/s at 80 Hz make
// 0.016 rad/s, without the pulse when the buffer is full. Only those named see the block.
TEST_F(GuoSecondaries, RateReachesOurLibraries) {
  TestHost host = host_for(chain());
  for (int step = 0; step < 20; ++step) {
    scan(host, step, 12.0 + 0.01 * step);
    ASSERT_EQ(host.call(step == 0 ? 0 : 1), 0) << host.message();
    EXPECT_EQ(host.get(Rec::YawTorqueDemand), static_cast<float>(kPrivateLogBlock.first));
    EXPECT_NEAR(host.get(Rec::PitchRateDemand), 12.0 + 0.01 * std::max(0.0, step - 0.5), 1e-5);
    EXPECT_LE(std::abs(host.get(Rec::TorqueDemand)), 0.0165f);
    if (step > 6) {
      EXPECT_NEAR(host.get(Rec::TorqueDemand), 0.016, 2e-4);
      EXPECT_EQ(host.get(Rec::YawRateDemand), 1.0f);
    }
  }
}

// OpenFAST's lidar, one point: u as it comes, new when it changes.
TEST_F(GuoSecondaries, OnOpenFastsLidar) {
  TestHost host =
      host_for(chain("openfast ! LidarLayout -\n0 ! InterpolationOrder -\n"
                     "0 ! RotorPositionX -\n"));
  const int first = kOpenFastLidarBlock.first;
  host.put(first + openfast_lidar::kSensorType, 1.0f);
  host.put(first + openfast_lidar::kNumberOfBeams, 1.0f);
  host.put(first + openfast_lidar::kNumberOfGates, 1.0f);
  host.put(first + openfast_lidar::kFirstSpeed + 1, -100.0f);  // x
  for (int step = 0; step < 10; ++step) {
    host.put(first + openfast_lidar::kFirstSpeed, step < 5 ? 14.0f : 15.0f);
    ASSERT_GE(host.call(step == 0 ? 0 : 1), 0) << host.message();
  }
  EXPECT_EQ(host.get(Rec::PitchRateDemand), 14.5f);  // mean of two measurements
}

// A host without a lidar.
TEST_F(GuoSecondaries, NeedALidar) {
  TestHost none = host_for(chain("none ! LidarLayout -\n"));
  EXPECT_EQ(none.call(0), -1);
  EXPECT_THAT(none.message(), HasSubstr("GuoSecondaries: needs a lidar, and LidarLayout is none"));
  TestHost small(master.entry(), chain(), folder.file("case.SrvD"), 164);
  EXPECT_EQ(small.call(0), -1);
  EXPECT_THAT(small.message(), HasSubstr("LidarLayout native needs records 1101-1320"));
}

// -8 and -9, which their libraries take for a step or do not survive, stay away from them; they
// start anew, and that is said.
TEST_F(GuoSecondaries, Checkpoint) {
  const std::string in = chain();
  TestHost host = host_for(in);
  for (int step = 0; step < 20; ++step) {
    scan(host, step, 12.0);
    ASSERT_EQ(host.call(step == 0 ? 0 : 1), 0) << host.message();
  }
  EXPECT_EQ(host.call_with(-8, folder.file("c.chkp")), 1);
  EXPECT_THAT(host.message(), HasSubstr("ldp (libtoy_guo" LAC_LIBRARY_SUFFIX
                                        ") does not know checkpoints: it will start anew"));
  host.call(-1);
  TestHost again = host_for(in);
  EXPECT_EQ(again.call_with(-9, folder.file("c.chkp")), 1);
  EXPECT_THAT(again.message(), HasSubstr("ffp (libtoy_guo" LAC_LIBRARY_SUFFIX
                                         ") does not know checkpoints: it starts anew"));
  scan(again, 20, 12.0);
  EXPECT_EQ(again.call(1), 0);
  EXPECT_EQ(again.get(Rec::PitchRateDemand), 12.0f);
}

}  // namespace
}  // namespace lac::test
