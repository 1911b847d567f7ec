// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_sim.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kTimeRounding_s = 1e-9;  // t_n and t_k are rounded multiples
constexpr double kRounding = 1e-12;       // of a control step, beside one

/// The turn nearest to 0 that leads to the same attitude.
double shortest_turn(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * kPi);
}

}  // namespace

LidarSim::LidarSim(LidarParams params, const WindField& field, const LidarSetting& setting)
    : params_(std::move(params)),
      field_(field),
      setting_(setting),
      mounting_(params_.mounting, params_.platform, setting_.hub_height_m),
      beams_(make_beam_samples(params_)),
      extent_(beams_, mounting_, field_),
      clock_(params_.scan),
      sums_(beams_.size()),
      ready_(beams_.size()) {
  check_timing();
  check_extent();
  std::size_t most_points = 0;
  for (const BeamSamples& beam : beams_) most_points = std::max(most_points, beam.points_m.size());
  wind_along_mps_.resize(most_points);
}

void LidarSim::check_timing() const {
  std::ostringstream text;
  const ScanPattern& scan = params_.scan;
  const double step_s = setting_.control_step_s;
  for (std::size_t i = 0; i < scan.beams.size(); ++i) {
    const double beam_time_s = scan.time_of_s(scan.beams[i]);
    if (beam_time_s >= step_s * (1.0 - kRounding)) continue;
    text << "lidar: beam " << i + 1 << ": beam_time_s = " << beam_time_s
         << " is shorter than the control step of " << step_s
         << " s; a controller takes one beam per step at most";
    throw Error(text.str());
  }
  if (clock_.end_s() > setting_.end_time_s + kTimeRounding_s) {
    text << "lidar: the first measurement is complete after " << clock_.end_s()
         << " s, the run ends at " << setting_.end_time_s
         << " s; expected a shorter beam_time_s or a longer run";
    throw Error(text.str());
  }
  const double handing_over_s = static_cast<double>(beams_.size()) * step_s;
  if (!scan.simultaneous || handing_over_s * (1.0 - kRounding) <= scan.scan_time_s()) return;
  text << "lidar: " << beams_.size() << " beams taken at once need as many control steps, "
       << handing_over_s << " s, to be handed over, and the scan takes " << scan.scan_time_s()
       << " s; a controller takes one beam per step at most";
  throw Error(text.str());
}

void LidarSim::check_extent() const {
  mounting_.platform().require_until(setting_.end_time_s);
  extent_.check_at_rest();
  extent_.check_planned(0, beams_.size(), setting_.end_time_s);
  ScanClock plan = clock_;
  if (mounting_.platform().is_still()) {  // of what changes with time alone, the first is enough
    for (std::size_t i = 0; i < plan.slots_per_scan(); ++i, plan.next()) check_samples(plan, 1);
    return;
  }
  for (; plan.sample_time_s(0) <= setting_.end_time_s; plan.next()) {
    check_samples(plan, params_.scan.samples_per_beam);
  }
}

void LidarSim::check_samples(const ScanClock& plan, int count) const {
  const ScanSlot& slot = plan.slot();
  for (int i = 0; i < count && plan.sample_time_s(i) <= setting_.end_time_s; ++i) {
    extent_.check_planned(slot.first_beam, slot.beam_count, plan.sample_time_s(i));
  }
}

bool LidarSim::step(std::int64_t step, const TurbineState& turbine, LidarMeasurement& m) {
  advance_scan(static_cast<double>(step) * setting_.control_step_s, turbine);
  if (first_ready_ == count_ready_) return false;
  m = ready_[first_ready_++];
  return true;
}

void LidarSim::advance_scan(double now_s, const TurbineState& turbine) {
  const double until_s = now_s + kTimeRounding_s;
  for (;;) {
    while (samples_taken_ < params_.scan.samples_per_beam) {
      const double time_s = clock_.sample_time_s(samples_taken_);
      if (time_s > until_s) return;
      sample_slot(time_s, turbine);
      ++samples_taken_;
    }
    if (clock_.end_s() > until_s || first_ready_ != count_ready_) return;
    complete_slot();
  }
}

void LidarSim::sample_slot(double time_s, const TurbineState& turbine) {
  const LidarPose pose = mounting_.pose(turbine, time_s);
  const ScanSlot& slot = clock_.slot();
  for (std::size_t b = slot.first_beam; b < slot.first_beam + slot.beam_count; ++b) {
    sample_beam(b, pose, time_s, turbine.tower_x_m);
  }
}

void LidarSim::sample_beam(std::size_t b, const LidarPose& pose, double time_s, double tower_x_m) {
  extent_.check_now(b, pose, time_s, tower_x_m);
  const BeamSamples& beam = beams_[b];
  const Vec3 dir_I = pose.R_IL * beam.dir_L;
  for (std::size_t i = 0; i < beam.points_m.size(); ++i) {
    const Vec3 point_I_m = pose.position_I_m + beam.points_m[i] * dir_I;
    wind_along_mps_[i] = dot(dir_I, field_.velocity(point_I_m, time_s));
  }
  LidarMeasurement& sum = sums_[b];
  const double own_speed_mps = dot(dir_I, pose.velocity_I_mps);
  for (std::size_t g = 0; g < beam.gates.size(); ++g) {
    const GateSamples& gate = beam.gates[g];
    const double wind_mps = std::inner_product(
        gate.weights.begin(), gate.weights.end(),
        wind_along_mps_.begin() + static_cast<std::ptrdiff_t>(gate.first_point), 0.0);
    const double before_mps = samples_taken_ == 0 ? 0.0 : sum.gates[g].speed_mps;
    sum.gates[g] = {gate.range_m, before_mps + (own_speed_mps - wind_mps), true, 0.0};
  }
  add_pose(pose, sum);
}

void LidarSim::add_pose(const LidarPose& pose, LidarMeasurement& sum) const {
  if (samples_taken_ == 0) {
    sum.position_I_m = pose.position_I_m;
    sum.velocity_I_mps = pose.velocity_I_mps;
    sum.roll_rad = pose.roll_rad;
    sum.pitch_rad = pose.pitch_rad;
    sum.yaw_rad = pose.yaw_rad;
    return;
  }
  // Running means: angles have no sum, but a mean of turns from the first one.
  const double share = 1.0 / (samples_taken_ + 1);
  sum.position_I_m = sum.position_I_m + share * (pose.position_I_m - sum.position_I_m);
  sum.velocity_I_mps = sum.velocity_I_mps + share * (pose.velocity_I_mps - sum.velocity_I_mps);
  sum.roll_rad += share * shortest_turn(pose.roll_rad - sum.roll_rad);
  sum.pitch_rad += share * shortest_turn(pose.pitch_rad - sum.pitch_rad);
  sum.yaw_rad += share * shortest_turn(pose.yaw_rad - sum.yaw_rad);
}

void LidarSim::complete_slot() {
  const ScanSlot& slot = clock_.slot();
  first_ready_ = count_ready_ = 0;
  for (std::size_t b = slot.first_beam; b < slot.first_beam + slot.beam_count; ++b) {
    LidarMeasurement& m = ready_[count_ready_++];
    m = sums_[b];
    m.time_s = clock_.end_s();
    m.beam_id = static_cast<int>(b);
    m.beam_dir_L = beams_[b].dir_L;
    m.gate_count = static_cast<int>(beams_[b].gates.size());
    for (std::size_t g = 0; g < beams_[b].gates.size(); ++g) {
      m.gates[g].speed_mps /= params_.scan.samples_per_beam;
    }
  }
  clock_.next();
  samples_taken_ = 0;
}

}  // namespace lac::sim
