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
      in.turbine_rews_mps = turbine_rews_mps;
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
  double turbine_rews_mps = std::nan("");
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

// The turbine's slow mean sets lead and arrival, the lidar's own mean is told as before; without
// the turbine's the lidar's is used.
TEST(Ldp, TurbineSetsTheSpeedOfTravel) {
  LdpParams p = four_beams();
  p.travel = TravelSpeed::Turbine;
  p.mean_speed_window_s = 60.0;
  Flight flight(p);
  EXPECT_NEAR(flight.run_until(30.0).lead_s, 60.0 / 16.0, 1e-9);
  flight.turbine_rews_mps = 15.0;
  const auto out = flight.run_until(60.0);
  EXPECT_TRUE(out.turbine_sets_travel);
  EXPECT_NEAR(out.lead_s, 60.0 / 15.0, 1e-9);
  EXPECT_NEAR(out.mean_speed_mps, 16.0, 1e-9);
  flight.turbine_rews_mps = std::nan("");
  EXPECT_NEAR(flight.run_until(110.0).lead_s, 60.0 / 15.0, 1e-9);
  EXPECT_NEAR(flight.run_until(125.0).lead_s, 60.0 / 16.0, 1e-9);
  flight.turbine_rews_mps = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(flight.run_until(150.0).lead_s, 60.0 / 16.0, 1e-9);
}

// A gap is left by default; with BridgeGaps the last estimate stands for as long as that.
TEST(Ldp, ShortGapsAreBridgedOnDemand) {
  LdpParams p = four_beams();
  p.bridged_gap_s = 3.0;
  Flight flight(p);
  EXPECT_FALSE(flight.run_until(30.0).bridged);
  flight.silent = true;
  const auto held = flight.run_until(34.9);  // MaximumAge of 2 s, then the gap
  EXPECT_TRUE(held.valid && held.bridged);
  EXPECT_NEAR(held.rews_mps, 16.0, 2e-6);
  EXPECT_FALSE(flight.run_until(35.3).valid);
  flight.silent = false;
  EXPECT_FALSE(flight.run_until(37.0).bridged);
  Flight fresh(p);
  EXPECT_FALSE(fresh.run_until(5.0).valid);  // nothing to hold before the first estimate
}

// One sample of a hard target in the average of twelve is a metre per second; the test takes it
// out.
TEST(Ldp, SpikesAreTakenOutOnDemand) {
  for (const double limit : {0.0, 4.0}) {
    LdpParams p = four_beams();
    p.spikes.limit = limit;
    Flight flight(p);
    flight.run_until(30.0);
    flight.change = [](LidarMeasurement& m) { m.gates[1].speed_mps = m.beam_id == 2 ? 0.0 : 15.0; };
    const auto out = flight.run_until(40.0);
    EXPECT_NEAR(out.availability, limit > 0.0 ? 0.98 : 1.0, 0.01);
    EXPECT_EQ(out.rews_mps > 15.0, limit > 0.0);
  }
}

LdpParams four_beams(WindModel model, double window_s) {
  LdpParams p = four_beams();
  p.wind.model = model;
  p.wind.window_s = window_s;
  p.wind.hub_height_m = 90.0;
  p.wind.rotor_radius_m = 63.0;
  return p;
}

/// Makes the measurements those of a wind with shear and a lateral component.
void shear_the_wind(LidarMeasurement& m) {
  const Vec3 n = m.beam_dir_I();
  for (int g = 0; g < m.gate_count; ++g) {
    LidarGate& gate = m.gates[static_cast<std::size_t>(g)];
    const Vec3 at_m = m.position_I_m + gate.range_m * n;
    gate.speed_mps = -dot(n, Vec3{16.0 + 0.01 * at_m.y + 0.03 * (at_m.z - 90.0), 1.2, 0.0});
  }
}

// A beam is lost (behind a blade root, say): the average is that of three beams, too high by shear
// and lateral wind; the wind model knows what the fourth would say.
TEST(Ldp, WindModelStandsInForALostBeam) {
  for (const WindModel model : {WindModel::U, WindModel::All}) {
    Flight flight(four_beams(model, 30.0));
    flight.change = shear_the_wind;
    EXPECT_NEAR(flight.run_until(60.0).rews_mps, 16.0, 2e-6);
    flight.change = [](LidarMeasurement& m) {
      shear_the_wind(m);
      if (m.beam_id != 2) return;
      for (int g = 0; g < m.gate_count; ++g) m.gates[static_cast<std::size_t>(g)].valid = false;
    };
    const auto out = flight.run_until(80.0);
    EXPECT_TRUE(out.valid);
    EXPECT_EQ(out.samples, 9);
    if (model == WindModel::All) {
      EXPECT_NEAR(out.rews_mps, 16.0, 1e-5);
      EXPECT_NEAR(out.wind.yaw_error_rad, std::atan2(1.2, 16.0), 1e-6);
    } else {
      EXPECT_GT(std::abs(out.rews_mps - 16.0), 0.2);
      EXPECT_TRUE(std::isnan(out.wind.yaw_error_rad));
    }
  }
}

// Beams in one plane cannot tell the vertical shear: without a word of the user the estimate is not
// valid then; with WhenRefused average it is the average.
TEST(Ldp, RefusedModelIsNotValidUnlessAsked) {
  for (const bool average : {false, true}) {
    LdpParams p = four_beams(WindModel::UShear, 20.0);
    p.wind.average_if_refused = average;
    test::LidarScan scan;
    scan.elevation_rad = 0.0;
    Flight flight(p, scan);
    EXPECT_TRUE(flight.run_until(19.0).valid);  // not yet asked
    const auto out = flight.run_until(40.0);
    EXPECT_EQ(out.wind.reason, WindReason::Partly);
    EXPECT_TRUE(std::isnan(out.wind.du_dz_per_s));
    EXPECT_EQ(out.valid, average);
    EXPECT_NEAR(out.rews_mps, 16.0, 2e-6);
  }
}

// A position that is no number costs its samples, not the estimate.
TEST(Ldp, WindModelSurvivesABadPosition) {
  LdpParams p = four_beams(WindModel::All, 20.0);
  p.induction = {
      InductionModel::kVortexCylinder, LookupTable({5.0}, {0.5}), 60.0, true, 90.0, 63.0};
  Flight flight(p);
  flight.run_until(30.0);
  flight.change = [](LidarMeasurement& m) {
    if (m.beam_id == 1) m.position_I_m.y = std::nan("");
  };
  flight.run_until(31.0);
  flight.change = nullptr;
  const auto out = flight.run_until(60.0);
  EXPECT_TRUE(out.valid);
  EXPECT_TRUE(std::isfinite(out.rews_mps) && std::isfinite(out.wind.v_mps));
}

// One measurement with an absurd position or velocity costs its own samples, not the estimate of
// the minutes after it.
TEST(Ldp, WindModelSurvivesAnAbsurdRecord) {
  for (const bool velocity : {false, true}) {
    Flight flight(four_beams(WindModel::UShear, 20.0));
    flight.run_until(30.0);
    bool once = true;
    flight.change = [&](LidarMeasurement& m) {
      if (once) (velocity ? m.velocity_I_mps.x : m.position_I_m.y) = 1.0e9;
      once = false;
    };
    const auto out = flight.run_until(35.0);
    EXPECT_FALSE(once);
    EXPECT_TRUE(out.valid) << velocity;
    EXPECT_NEAR(out.rews_mps, 16.0, 1e-3);
    EXPECT_NEAR(out.wind.du_dz_per_s, 0.0, 1e-4);
  }
}

// A gate outside the range limits is not the nearest one in use.
TEST(Ldp, RangeLimitsMoveTheLead) {
  LdpParams p = four_beams();
  p.reader.min_range_m = 80.0;
  Flight flight(p);
  flight.change = [](LidarMeasurement& m) { m.gates[0].valid = false; };  // as the reader does
  const auto out = flight.run_until(30.0);
  EXPECT_NEAR(out.lead_s, 120.0 / 16.0, 1e-9);
  EXPECT_EQ(out.samples, 8);
}

// A saved state continues to the last bit, with all there is.
TEST(Ldp, SavedStateContinuesExactly) {
  test::LidarScan scan;
  scan.wind_mps = [](double t) { return 16.0 + std::sin(0.3 * t) + 0.5 * std::sin(1.7 * t); };
  LdpParams p = four_beams(WindModel::All, 5.0);
  p.induction = {
      InductionModel::kVortexCylinder, LookupTable({5.0}, {0.5}), 60.0, true, 90.0, 63.0};
  p.spikes.limit = 3.0;
  p.bridged_gap_s = 2.0;
  Flight a(p, scan);
  a.run_until(20.0);
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  a.state.visit(save);
  Flight b(p, scan);
  StateArchive load{std::span<const std::byte>(bytes)};
  b.state.visit(load);
  ASSERT_TRUE(load.complete());
  b.step = a.step;
  EXPECT_EQ(a.run_until(30.0).rews_mps, b.run_until(30.0).rews_mps);
}

}  // namespace
}  // namespace lac
