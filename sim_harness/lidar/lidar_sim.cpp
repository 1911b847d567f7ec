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

constexpr double kReach = 3.0;            // standard deviations that the range weighting covers
constexpr double kTowerTravel_m = 3.0;    // allowance for the moving tower top
constexpr double kTimeRounding_s = 1e-9;  // t_n and t_k are rounded multiples
constexpr double kEdgeRounding_m = 1e-6;
constexpr double kGridRounding = 1e-9;  // of a step

/// How far a value is outside [low, high]; 0 inside.
double outside(double value, double low, double high) {
  return std::max({low - value, value - high, 0.0});
}

}  // namespace

LidarSim::LidarSim(LidarParams params, const WindField& field, const LidarSetting& setting)
    : params_(std::move(params)), field_(field), setting_(setting) {
  if (params_.beam_time_s < setting_.control_step_s) {
    std::ostringstream text;
    text << "lidar: beam_time_s = " << params_.beam_time_s
         << " is shorter than the control step of " << setting_.control_step_s
         << " s; a controller takes one beam per step at most";
    throw Error(text.str());
  }
  for (const LidarBeam& angles : params_.beams) {
    beams_.push_back(make_beam(angles));
    check_extent(beams_.back(), beams_.size());
    wind_along_mps_.resize(std::max(wind_along_mps_.size(), beams_.back().points_m.size()));
  }
}

LidarSim::Beam LidarSim::make_beam(const LidarBeam& angles) const {
  Beam beam;
  beam.dir_L = beam_direction(angles.azimuth_rad, angles.elevation_rad);
  beam.dir_I = rotation_from_roll_pitch_yaw(0.0, params_.tilt_rad, kPi) * beam.dir_L;
  for (const double distance_m : params_.gates_m) {
    add_gate(params_.gates_along_beam ? distance_m : distance_m / beam.dir_L.x, beam);
  }
  return beam;
}

void LidarSim::add_gate(double range_m, Beam& beam) const {
  Gate gate{range_m, beam.points_m.size(), {1.0}};
  const double sigma_m = params_.weighting.fwhm_m / (2.0 * std::sqrt(2.0 * std::log(2.0)));
  if (sigma_m == 0.0) {
    beam.points_m.push_back(range_m);
    beam.gates.push_back(gate);
    return;
  }
  const double reach_m = kReach * sigma_m;
  const double step_m = 2.0 * reach_m / (params_.weighting.points - 1);
  if (beam.points_m.empty()) beam.points_m.push_back(range_m - reach_m);
  const double origin_m = beam.points_m.front();
  const auto grid_m = [&](int j) { return origin_m + j * step_m; };
  const auto steps_to = [&](double r_m) { return (r_m - origin_m) / step_m; };
  const int low = static_cast<int>(std::ceil(steps_to(range_m - reach_m) - kGridRounding));
  const int high = static_cast<int>(std::floor(steps_to(range_m + reach_m) + kGridRounding));
  const int last = static_cast<int>(std::lround(steps_to(beam.points_m.back())));
  for (int j = std::max(low, last + 1); j <= high; ++j) beam.points_m.push_back(grid_m(j));
  gate.first_point = beam.points_m.size() - static_cast<std::size_t>(high - low) - 1;
  gate.weights.clear();
  double sum = 0.0;
  for (int j = low; j <= high; ++j) {
    const double s = (grid_m(j) - range_m) / sigma_m;
    gate.weights.push_back(std::exp(-0.5 * s * s));
    sum += gate.weights.back();
  }
  for (double& w : gate.weights) w /= sum;
  beam.gates.push_back(std::move(gate));
}

void LidarSim::check_extent(const Beam& beam, std::size_t number) const {
  const WindExtent e = field_.extent();
  for (std::size_t g = 0; g < beam.gates.size(); ++g) {
    const Gate& gate = beam.gates[g];
    for (const std::size_t i : {gate.first_point, gate.first_point + gate.weights.size() - 1}) {
      const Vec3 p =
          Vec3{0.0, 0.0, setting_.hub_height_m} + params_.offset_m + beam.points_m[i] * beam.dir_I;
      const double arrival_s =
          setting_.end_time_s + (kTowerTravel_m - p.x) / field_.mean_speed_mps();
      const double y_m = outside(p.y, e.y_min_m, e.y_max_m);
      const double z_m = outside(p.z, e.z_min_m, e.z_max_m);
      const double t_s = outside(arrival_s, e.t_min_s, e.t_max_s);
      if (std::max(y_m, z_m) <= kEdgeRounding_m && t_s <= kTimeRounding_s) continue;
      std::ostringstream text;
      text << "lidar: beam " << number << ", gate " << g + 1
           << " (with its range weighting) leaves the wind field by ";
      if (y_m > kEdgeRounding_m) {
        text << y_m << " m sideways; the field must be wider";
      } else if (z_m > kEdgeRounding_m) {
        text << z_m << " m in height; the field must be higher";
      } else {
        text << t_s << " s at the end; the field must be longer";
      }
      throw Error(text.str());
    }
  }
}

bool LidarSim::step(std::int64_t step, const NacelleMotion& motion, LidarMeasurement& m) {
  const double now_s = static_cast<double>(step) * setting_.control_step_s;
  const double completed_s = static_cast<double>(done_ + 1) * params_.beam_time_s;
  if (completed_s > now_s + kTimeRounding_s) return false;
  m.beam_id = static_cast<int>(done_ % static_cast<std::int64_t>(beams_.size()));
  measure(completed_s, motion, m);
  ++done_;
  return true;
}

void LidarSim::measure(double time_s, const NacelleMotion& motion, LidarMeasurement& m) {
  const Beam& beam = beams_[static_cast<std::size_t>(m.beam_id)];
  m.time_s = time_s;
  m.beam_dir_L = beam.dir_L;
  m.position_I_m = Vec3{motion.displacement_m, 0.0, setting_.hub_height_m} + params_.offset_m;
  m.roll_rad = 0.0;
  m.pitch_rad = params_.tilt_rad;
  m.yaw_rad = kPi;
  m.velocity_I_mps = {motion.velocity_mps, 0.0, 0.0};
  m.gate_count = static_cast<int>(beam.gates.size());
  for (std::size_t i = 0; i < beam.points_m.size(); ++i) {
    const Vec3 point_I_m = m.position_I_m + beam.points_m[i] * beam.dir_I;
    wind_along_mps_[i] = dot(beam.dir_I, field_.velocity(point_I_m, time_s));
  }
  const double own_speed_mps = dot(beam.dir_I, m.velocity_I_mps);
  for (std::size_t g = 0; g < beam.gates.size(); ++g) {
    const Gate& gate = beam.gates[g];
    const double wind_mps = std::inner_product(
        gate.weights.begin(), gate.weights.end(),
        wind_along_mps_.begin() + static_cast<std::ptrdiff_t>(gate.first_point), 0.0);
    m.gates[g] = {gate.range_m, own_speed_mps - wind_mps, true, 0.0};
  }
}

}  // namespace lac::sim
