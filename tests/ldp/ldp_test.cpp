// SPDX-License-Identifier: Apache-2.0
#include "ldp/ldp.hpp"

#include <gtest/gtest.h>

#include "support/lidar_scan.hpp"

namespace lac {
namespace {

constexpr double kStep_s = 0.0125;

LdpParams four_beams() {
  LdpParams p;
  p.reader.number_of_beams = 4;
  p.mean_speed_window_s = 600.0;
  return p;
}

/// Flies the scan for a time and keeps the last output.
struct Flight {
  explicit Flight(LdpParams params, test::LidarScan s = {})
      : ldp(std::move(params), kStep_s), state(ldp.initial_state()), scan(std::move(s)) {}

  Ldp::Outputs run_until(double end_s) {
    const int every = static_cast<int>(std::lround(scan.beam_time_s / kStep_s));
    Ldp::Outputs out;
    for (; step * kStep_s < end_s + 1e-9; ++step) {
      Ldp::Inputs in;
      in.time_s = step * kStep_s;
      in.lead_needed_s = lead_needed_s;
      LidarMeasurement m;
      if (step % every == 0) {
        m = scan.measure(in.time_s, step / every % 4);
        if (change) change(m);
        in.measurement = silent ? nullptr : &m;
      }
      out = ldp.step(in, state);
    }
    return out;
  }

  Ldp ldp;
  Ldp::State state;
  test::LidarScan scan;
  std::function<void(LidarMeasurement&)> change;
  double lead_needed_s = 0.0;
  bool silent = false;
  int step = 0;
};

// Beam (0.8, 0.6, 0) looking up-wind: v_los = 0.8 u + 0.6 v, and back by 1/0.8 for v = 0.
TEST(Ldp, LineOfSightOfTheLectureExercise) {
  const Ldp ldp(four_beams(), kStep_s);
  LidarMeasurement m;
  m.beam_dir_L = {0.8, 0.6, 0.0};
  const Vec3 wind_I{10.0, 3.0, 0.0};
  const double v_los = -dot(m.beam_dir_I(), wind_I);
  EXPECT_NEAR(v_los, 0.8 * 10.0 + 0.6 * 3.0, 1e-12);
  EXPECT_NEAR(ldp.projection(m).longitudinal_mps(v_los), 10.0 + 0.6 * 3.0 / 0.8, 1e-12);
}

// Before anything is measured there is no number.
TEST(Ldp, NothingYetIsNotANumber) {
  Flight flight(four_beams());
  flight.silent = true;
  const auto out = flight.run_until(2.0);
  EXPECT_TRUE(std::isnan(out.rews_mps));
  EXPECT_TRUE(std::isnan(out.mean_speed_mps));
  EXPECT_FALSE(out.valid);
}

// Steady wind comes out as it is, with the lead of the nearest gate and all samples of a scan.
TEST(Ldp, SteadyWind) {
  Flight flight(four_beams());
  const auto out = flight.run_until(30.0);
  EXPECT_NEAR(out.rews_mps, 16.0, 2e-6);
  EXPECT_NEAR(out.mean_speed_mps, 16.0, 1e-9);
  EXPECT_NEAR(out.lead_s, 60.0 / 16.0, 1e-9);
  EXPECT_EQ(out.samples, 12);
  EXPECT_TRUE(out.valid);
}

// A ramp shows the timing: the mean over one scan lags t + lead by the mean age of the samples.
// Samples arrive at lead, lead - 0.25, -0.5, -0.75 s right after a measurement, all gates alike.
TEST(Ldp, RampArrivesWithItsLeadMinusHalfAScan) {
  test::LidarScan scan;
  scan.wind_mps = [](double arrival_s) { return 16.0 + 0.01 * (arrival_s - 40.0); };
  LdpParams p = four_beams();
  Flight flight(p, scan);
  flight.state.mean_speed.add(16.0, 600.0, 600.0);  // speed of travel known
  const auto out = flight.run_until(40.0);
  const double expected = 16.0 + 0.01 * (out.lead_s - (0.0 + 0.25 + 0.5 + 0.75) / 4.0);
  EXPECT_NEAR(out.rews_mps, expected, 5e-4);  // arrivals are rounded to whole steps
}

// Gates that come too early for the controller are left out: the lead is the next gate's.
TEST(Ldp, RequiredLeadDropsNearGates) {
  LdpParams p = four_beams();
  p.required_lead_s = 5.0;  // 60 m at 16 m/s are 3.75 s
  Flight flight(p);
  const auto out = flight.run_until(30.0);
  EXPECT_NEAR(out.lead_s, 120.0 / 16.0, 1e-9);
  EXPECT_EQ(out.samples, 8);
}

// What the feedforward behind needs, with the margin, drops near gates likewise.
TEST(Ldp, LeadNeededBehindDropsNearGates) {
  Flight flight(four_beams());
  flight.lead_needed_s = 3.7;  // + 0.1 s of margin: more than the 3.75 s of 60 m
  EXPECT_NEAR(flight.run_until(30.0).lead_s, 120.0 / 16.0, 1e-9);
  Flight not_known(four_beams());
  not_known.lead_needed_s = std::nan("");
  EXPECT_NEAR(not_known.run_until(30.0).lead_s, 60.0 / 16.0, 1e-9);
}

// Beams that reach different distances up-wind share one lead: it does not flip with the beam.
TEST(Ldp, LeadIsTheFarthestOfTheBeamsNearestGates) {
  Flight flight(four_beams());
  flight.change = [](LidarMeasurement& m) { m.position_I_m.x = m.beam_id < 2 ? 1.0 : -2.0; };
  for (double t = 20.0; t < 22.0; t += 0.1) {
    EXPECT_NEAR(flight.run_until(t).lead_s, 62.0 / 16.0, 1e-9);
  }
}

// The time between two visits of a beam is told, whatever gaps there are.
TEST(Ldp, TellsTheScanTime) {
  Flight flight(four_beams());
  flight.run_until(20.0);
  flight.silent = true;
  flight.run_until(25.0);
  flight.silent = false;
  EXPECT_NEAR(flight.run_until(30.0).scan_time_s, 1.0, 1e-9);
}

// The nearest gate does not change to and fro with the mean wind: a nearer one comes into use only
// with a margin over the required lead, the one in use leaves below the required lead itself.
TEST(Ldp, NearestGateHasAHysteresis) {
  LdpParams p = four_beams();
  p.required_lead_s = 60.0 / 16.5;  // the first gate's lead at 16.5 m/s
  p.mean_speed_window_s = 5.0;
  test::LidarScan scan;
  double speed_mps = 16.0;
  scan.wind_mps = [&](double) { return speed_mps; };
  Flight flight(p, scan);
  const auto nearest_m = [&](double wind_mps, double until_s) {
    speed_mps = wind_mps;
    const auto out = flight.run_until(until_s);
    return out.lead_s * out.mean_speed_mps;
  };
  EXPECT_NEAR(nearest_m(16.0, 60.0), 60.0, 1e-6);
  EXPECT_NEAR(nearest_m(17.0, 120.0), 120.0, 1e-6);
  EXPECT_NEAR(nearest_m(16.0, 180.0), 120.0, 1e-6);  // lead there again, to spare not
  EXPECT_NEAR(nearest_m(14.0, 240.0), 60.0, 1e-6);
}

// The speed of travel is not trusted before it has been averaged for a while.
TEST(Ldp, NotValidBeforeTheMeanHasSettled) {
  Flight flight(four_beams());
  EXPECT_FALSE(flight.run_until(9.0).valid);
  EXPECT_TRUE(flight.run_until(11.0).valid);
}

// Gates at or behind the rotor are never used.
TEST(Ldp, GatesBehindTheRotorAreIgnored) {
  test::LidarScan scan;
  scan.gate_distance_m = {60.0};
  Flight flight(four_beams(), scan);
  flight.change = [](LidarMeasurement& m) { m.position_I_m.x = 61.0; };
  const auto out = flight.run_until(10.0);
  EXPECT_FALSE(out.valid);
  EXPECT_EQ(out.samples, 0);
}

// Invalid samples are left out; the mean is over what is there.
TEST(Ldp, InvalidSamplesAreLeftOut) {
  Flight flight(four_beams());
  flight.change = [](LidarMeasurement& m) {
    m.gates[1].valid = false;
    m.gates[1].speed_mps = 1000.0;
  };
  const auto out = flight.run_until(30.0);
  EXPECT_EQ(out.samples, 8);
  EXPECT_NEAR(out.rews_mps, 16.0, 2e-6);
}

// When the lidar falls silent the estimate turns invalid after MaximumAge, and its age is told.
TEST(Ldp, SilenceIsInvalidAfterTheMaximumAge) {
  Flight flight(four_beams());
  flight.run_until(30.0);
  flight.silent = true;
  EXPECT_TRUE(flight.run_until(31.7).valid);
  const auto out = flight.run_until(32.1);
  EXPECT_FALSE(out.valid);
  EXPECT_GT(out.data_age_s, 2.0);
}

// Own motion and attitude of the lidar are taken out exactly in uniform wind.
TEST(Ldp, MotionIsCompensated) {
  Flight flight(four_beams());
  flight.change = [](LidarMeasurement& m) {
    m.roll_rad = 0.05;
    m.pitch_rad = -0.08;
    m.yaw_rad = kPi + 0.1;
    m.velocity_I_mps = {0.7, -0.4, 0.2};
    const double v = -dot(m.beam_dir_I(), Vec3{16.0, 0.0, 0.0} - m.velocity_I_mps);
    for (int g = 0; g < m.gate_count; ++g) m.gates[static_cast<std::size_t>(g)].speed_mps = v;
  };
  EXPECT_NEAR(flight.run_until(30.0).rews_mps, 16.0, 2e-6);
}

// Without compensation the same motion is an error: the test above can fail.
TEST(Ldp, MotionMattersWithoutCompensation) {
  LdpParams p = four_beams();
  p.motion_compensation = false;
  Flight flight(p);
  flight.change = [](LidarMeasurement& m) {
    m.velocity_I_mps = {0.7, 0.0, 0.0};
    const double v = -dot(m.beam_dir_I(), Vec3{16.0, 0.0, 0.0} - m.velocity_I_mps);
    for (int g = 0; g < m.gate_count; ++g) m.gates[static_cast<std::size_t>(g)].speed_mps = v;
  };
  EXPECT_NEAR(flight.run_until(30.0).rews_mps, 15.3, 1e-3);
}

// A saved state continues to the last bit.
TEST(Ldp, SavedStateContinuesExactly) {
  test::LidarScan scan;
  scan.wind_mps = [](double t) { return 16.0 + std::sin(0.3 * t) + 0.5 * std::sin(1.7 * t); };
  Flight a(four_beams(), scan);
  a.run_until(20.0);
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  a.state.visit(save);
  Flight b(four_beams(), scan);
  StateArchive load{std::span<const std::byte>(bytes)};
  b.state.visit(load);
  ASSERT_TRUE(load.complete());
  b.step = a.step;
  EXPECT_EQ(a.run_until(30.0).rews_mps, b.run_until(30.0).rews_mps);
}

}  // namespace
}  // namespace lac
