// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/feedforward_design.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

/// |G_RL| is that of a first-order low-pass in k1, a little lower for every gate left out.
class FirstOrderModel : public CorrelationModel {
 public:
  explicit FirstOrderModel(double cutoff_radpm) : cutoff_radpm_(cutoff_radpm) {}

  std::vector<RotorLidarSpectra> at(double k1_radpm,
                                    const std::vector<double>& speeds_mps) const override {
    RotorLidarSpectra s{1.0, {}, {}};
    for (const double share : {1.0, 0.9, 0.8}) {
      s.s_ll.push_back(1.0);
      s.s_rl.push_back(1.0 / std::hypot(1.0, k1_radpm / (share * cutoff_radpm_)));
    }
    return std::vector<RotorLidarSpectra>(speeds_mps.size(), s);
  }

 private:
  double cutoff_radpm_;
};

LidarVolumes three_gates() {
  LidarParams lidar;
  lidar.scan.beams = {{}};
  lidar.gates_m = {50.0, 65.0, 100.0};
  return lidar_volumes(lidar, {});
}

std::vector<FeedforwardPoint> design(std::vector<double> speeds_mps, CutoffRule rule,
                                     const FeedforwardTiming& timing, double cutoff_radpm = 0.02) {
  return design_feedforward(
      CorrelationCurves(FirstOrderModel(cutoff_radpm), std::move(speeds_mps), {}), three_gates(),
      rule, timing);
}

// k_c = 0.05 rad/m at 10 m/s is f_c = 0.5/(2 pi) Hz (an exercise of the lecture on lidar-assisted
// control), which delays low frequencies by 2 s.
TEST(FeedforwardDesign, TakesTheCutoffOfTheLowPass) {
  FeedforwardTiming timing;
  timing.delay_frequency_hz = 0.0;
  const auto p = design({10.0}, CutoffRule::kClosestFit, timing, 0.05);
  ASSERT_THAT(p, SizeIs(1));
  EXPECT_NEAR(p[0].cutoff_hz, 0.5 / (2.0 * kPi), 1e-6);
  EXPECT_NEAR(p[0].filter_s, 2.0, 1e-4);
}

/// The same, and late by half a second at every frequency.
class LateModel : public FirstOrderModel {
 public:
  using FirstOrderModel::FirstOrderModel;
  std::vector<RotorLidarSpectra> at(double k1_radpm,
                                    const std::vector<double>& speeds_mps) const override {
    std::vector<RotorLidarSpectra> s = FirstOrderModel::at(k1_radpm, speeds_mps);
    for (std::size_t i = 0; i < s.size(); ++i)
      for (auto& s_rl : s[i].s_rl) s_rl *= std::polar(1.0, 0.5 * k1_radpm * speeds_mps[i]);
    return s;
  }
};

// An estimate that is late by half a second is made up for when asked: the buffer is that much
// shorter, and with nothing left of it the next gate is taken.
TEST(FeedforwardDesign, TrimsTheLatenessOfTheEstimate) {
  FeedforwardTiming timing;
  const auto design_late = [&](double speed_mps) {
    return design_feedforward(CorrelationCurves(LateModel(0.02), {speed_mps}, {}), three_gates(),
                              CutoffRule::kAtMinus3dB, timing)[0];
  };
  const FeedforwardPoint plain = design_late(10.0);
  EXPECT_NEAR(plain.late_s, 0.5, 1e-9);
  EXPECT_EQ(plain.trim_s, 0.0);
  timing.trim_lateness = true;
  const FeedforwardPoint trimmed = design_late(10.0);
  EXPECT_NEAR(trimmed.trim_s, -0.5, 1e-9);
  EXPECT_NEAR(trimmed.buffer_s(), plain.buffer_s() - 0.5, 1e-9);
  timing.buffer_trim_s = LookupTable({8.0, 12.0}, {0.1, 0.3});
  EXPECT_NEAR(design_late(10.0).trim_s, -0.3, 1e-9);
  timing.buffer_trim_s = LookupTable({0.0}, {-plain.buffer_s() - 0.1 + 0.55});
  EXPECT_EQ(design_late(10.0).first_plane, 1u);
}

// What leaves least leaves no more than the -3 dB cut-off, keeps its delay within the lead, and
// says which gates it is for.
TEST(FeedforwardDesign, LeastLeftWithinTheLead) {
  for (const double speed_mps : {10.0, 16.0, 20.0, 24.0}) {
    FeedforwardTiming timing;
    const double at_3_db = design({speed_mps}, CutoffRule::kAtMinus3dB, timing)[0].share_left;
    for (const int order : {1, 2}) {
      timing.filter_order = order;
      const FeedforwardPoint p = design({speed_mps}, CutoffRule::kLeastLeft, timing)[0];
      EXPECT_TRUE(p.is_usable);
      EXPECT_LE(p.share_left, at_3_db);
      EXPECT_GE(p.buffer_s(), timing.lead_margin_s);
      EXPECT_EQ(p.low_pass.order, order);
    }
  }
}

// The buffer is the lead less all delays (GUO eq. 40), each by its own equation.
TEST(FeedforwardDesign, MakesUpForEveryDelay) {
  FeedforwardTiming timing;
  timing.scan_time_s = 1.2;
  timing.buffer_trim_s = LookupTable({0.0}, {0.3});
  const FeedforwardPoint p = design({10.0}, CutoffRule::kClosestFit, timing)[0];
  const double cutoff_hz = 0.02 * 10.0 / (2.0 * kPi), w = radps_from_hz(0.08);
  EXPECT_NEAR(p.cutoff_hz, cutoff_hz, 1e-6);
  EXPECT_NEAR(p.lead_s, 5.0, 1e-12);
  EXPECT_NEAR(p.filter_s, std::atan(0.08 / cutoff_hz) / w, 1e-4);
  EXPECT_NEAR(p.actuator_s, 0.2233, 1e-4);  // 0.22 s in GUO
  EXPECT_DOUBLE_EQ(p.half_window_s, 0.6);
  EXPECT_NEAR(p.buffer_s(), 5.0 - p.filter_s - p.actuator_s - 0.6 + 0.3, 1e-12);
}

// GUO Fig. 8: at high wind the nearest gates arrive too soon. Each set of gates is judged with its
// own cut-off.
TEST(FeedforwardDesign, LeavesOutGatesThatArriveTooSoon) {
  const auto p = design({10.0, 20.0, 30.0}, CutoffRule::kAtMinus3dB, {});
  EXPECT_EQ(p[0].first_plane, 0u);
  EXPECT_EQ(p[0].nearest_gate_m, 50.0);
  EXPECT_EQ(p[1].first_plane, 1u);
  EXPECT_EQ(p[2].first_plane, 2u);
  for (const FeedforwardPoint& at : p) {
    EXPECT_TRUE(at.is_usable);
    EXPECT_GE(at.buffer_s(), 0.1);
  }
  const double minus_3_db = std::sqrt(std::pow(10.0, 0.3) - 1.0);
  EXPECT_NEAR(p[2].cutoff_hz, 0.8 * 0.02 * 30.0 / (2.0 * kPi) * minus_3_db, 1e-6);
}

// Nothing is clipped: the wind speed is marked, with what all gates would give.
TEST(FeedforwardDesign, SaysWhereNoGateLeadsEnough) {
  FeedforwardTiming timing;
  timing.scan_time_s = 8.0;
  const auto p = design({10.0, 30.0}, CutoffRule::kAtMinus3dB, timing);
  EXPECT_TRUE(p[0].is_usable);
  EXPECT_FALSE(p[1].is_usable);
  EXPECT_EQ(p[1].first_plane, 0u);
  EXPECT_LT(p[1].buffer_s(), 0.0);
}

// A gain that never falls has no cut-off.
TEST(FeedforwardDesign, RefusesAGainWithoutACutoff) {
  for (const CutoffRule rule : {CutoffRule::kAtMinus3dB, CutoffRule::kClosestFit}) {
    EXPECT_THAT([&] { design({10.0}, rule, {}, 1e9); },
                ThrowsMessage<Error>(
                    AllOf(HasSubstr("at 10 m/s with gates from 50 m"), HasSubstr("|G_RL|"))));
  }
}

/// The same, without a cut-off for some sets of gates.
class PartlyFlatModel : public FirstOrderModel {
 public:
  explicit PartlyFlatModel(std::vector<std::size_t> flat)
      : FirstOrderModel(0.02), flat_(std::move(flat)) {}
  std::vector<RotorLidarSpectra> at(double k1_radpm,
                                    const std::vector<double>& speeds_mps) const override {
    std::vector<RotorLidarSpectra> s = FirstOrderModel::at(k1_radpm, speeds_mps);
    for (RotorLidarSpectra& of_speed : s)
      for (const std::size_t plane : flat_) of_speed.s_rl[plane] = 0.9;
    return s;
  }

 private:
  std::vector<std::size_t> flat_;
};

// A fit takes another set of gates where one has no cut-off; without any it is an error, as for the
// rules that take the first set that leads enough.
TEST(FeedforwardDesign, FitsTheGatesThatHaveACutoff) {
  FeedforwardTiming timing;
  const auto design_with = [&](std::vector<std::size_t> flat, CutoffRule rule,
                               double speed_mps = 10.0) {
    return design_feedforward(CorrelationCurves(PartlyFlatModel(std::move(flat)), {speed_mps}, {}),
                              three_gates(), rule, timing)[0];
  };
  EXPECT_EQ(design_with({0, 2}, CutoffRule::kLeastLeft).first_plane, 1u);
  const FeedforwardPoint without_lead = design_with({0}, CutoffRule::kLeastLeft, 500.0);
  EXPECT_FALSE(without_lead.is_usable);
  EXPECT_EQ(without_lead.first_plane, 1u);
  const auto no_cutoff = ThrowsMessage<Error>(HasSubstr("with gates from 50 m: |G_RL|"));
  EXPECT_THAT([&] { design_with({0, 1, 2}, CutoffRule::kLeastLeft); }, no_cutoff);
  EXPECT_THAT([&] { design_with({0}, CutoffRule::kAtMinus3dB); }, no_cutoff);
  timing.filter_order = 2;
  EXPECT_EQ(design_with({0}, CutoffRule::kAtMinus3dB).first_plane, 1u);
}

}  // namespace
}  // namespace lac::sim
