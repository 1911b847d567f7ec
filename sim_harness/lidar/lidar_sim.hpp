// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/lidar_block.hpp"
#include "sim_harness/lidar/beam_extent.hpp"
#include "sim_harness/lidar/beam_samples.hpp"
#include "sim_harness/lidar/lidar_params.hpp"
#include "sim_harness/lidar/scan_clock.hpp"
#include "sim_harness/wind/wind_field.hpp"

namespace lac::sim {

/// When and where a lidar measures; the surroundings it is set up in.
struct LidarSetting {
  double hub_height_m = 90.0;
  double control_step_s = 0.0125;
  double end_time_s = 660.0;
};

/// Doppler lidar on a turbine.
///
///   v_los = sum_j w_j n . (V_lidar - U(x_lidar + r_j n, t)),  sum w_j = 1
///
/// positive for wind blowing towards the lidar; points r_j and weights w_j as in
/// beam_samples.hpp, V_lidar, x_lidar and n as in mounting.hpp. Position, velocity and attitude of
/// a measurement are what a perfect inertial unit says. The field carries itself with Taylor's
/// hypothesis.
///
/// Time: a slot of the scan (one beam, or all at once) is completed at t_k (scan_clock.hpp). It is
/// handed over in the first control step at or after t_k, beams of one slot in consecutive steps
/// in their order, each with its true time t_k. Its wind is that at t_k, or with samples_per_beam
/// the mean over the beam time, and so are position, velocity and attitude; what they depend on
/// of the turbine is taken from the step that first reaches the time of the sample. So beam times
/// need not be multiples of the control step; they may not be shorter.
class LidarSim {
 public:
  /// The field must outlive this object. Throws lac::Error for a beam without gates or with more
  /// than the lidar block carries, if the beam time is shorter than the control step or the first
  /// one longer than the run, if beams taken at once cannot be handed over within a scan, or for a
  /// beam that BeamExtent refuses.
  LidarSim(LidarParams params, const WindField& field, const LidarSetting& setting);
  LidarSim(const LidarSim&) = delete;
  LidarSim& operator=(const LidarSim&) = delete;

  /// To be called for steps 0, 1, 2, ... True if it hands over a measurement. Allocates nothing;
  /// throws lac::Error if motion takes a beam out of the field.
  bool step(std::int64_t step, const TurbineState& turbine, LidarMeasurement& measurement);

  const Mounting& mounting() const { return mounting_; }

 private:
  void check_timing() const;
  void check_extent() const;
  void check_samples(const ScanClock& plan, int count) const;
  void advance_scan(double now_s, const TurbineState& turbine);
  void sample_slot(double time_s, const TurbineState& turbine);
  void sample_beam(std::size_t beam, const LidarPose& pose, double time_s, double tower_x_m);
  void add_pose(const LidarPose& pose, LidarMeasurement& sum) const;
  void complete_slot();

  LidarParams params_;
  const WindField& field_;
  LidarSetting setting_;
  Mounting mounting_;
  std::vector<BeamSamples> beams_;
  BeamExtent extent_;
  ScanClock clock_;
  int samples_taken_ = 0;                // in the present slot
  std::vector<LidarMeasurement> sums_;   // of the present slot, a place per beam of the lidar
  std::vector<LidarMeasurement> ready_;  // completed
  std::size_t first_ready_ = 0;          // not handed over yet: first_ready_ ... count_ready_ - 1
  std::size_t count_ready_ = 0;
  std::vector<double> wind_along_mps_;  // n . U at the points of a beam
};

}  // namespace lac::sim
