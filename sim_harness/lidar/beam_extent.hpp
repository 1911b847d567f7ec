// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sim_harness/lidar/beam_samples.hpp"
#include "sim_harness/lidar/mounting.hpp"
#include "sim_harness/wind/wind_demand.hpp"
#include "sim_harness/wind/wind_field.hpp"

namespace lac::sim {

/// Where a lidar will ask for the wind, and how far motion may take these places: gate centres
/// at rest and every point of every gate, the tower top at tower_positions_m() of the mounting, a
/// spinner in all its positions.
WindDemand wind_demand(const LidarParams& lidar, double hub_height_m);

/// Whether beams stay where there is wind. All functions throw lac::Error that names beam, gate,
/// place and by how far; with motion also the time. A spinner is looked at in 72 positions; what
/// a point r off its axis reaches between them, r (1 - cos(pi/72)) farther, is allowed for.
class BeamExtent {
 public:
  BeamExtent(const std::vector<BeamSamples>& beams, const Mounting& mounting,
             const WindField& field);

  /// At rest: a gate behind the rotor plane, a volume that reaches behind the lidar, into the
  /// ground or to a place that the field has not kept.
  void check_at_rest() const;
  /// Fields and ground, for some beams at this time, moved as far as can be known before the run:
  /// by the platform, by a spinner in all its positions; the tower top at rest, 3 m earlier or
  /// later in time.
  void check_planned(std::size_t first_beam, std::size_t count, double time_s) const;
  /// One beam as it is, and whether the field has kept every place it sees; names tower_x_m.
  void check_now(std::size_t beam, const LidarPose& pose, double time_s, double tower_x_m) const;

 private:
  /// How far a place must stay away from the edges of the field.
  struct Distance {
    double along_m = 0.0;   // the wind
    double across_m = 0.0;  // also from the ground
  };
  bool is_inside(const Vec3& point_I_m, double time_s, Distance keep) const;
  std::string fault_at(const Vec3& point_I_m, double time_s, Distance keep) const;
  double between_positions_m(std::size_t beam) const;
  void check_gate_at_rest(std::size_t beam, std::size_t gate, const LidarPose& pose) const;
  void check_beam(std::size_t beam, const LidarPose& pose, double time_s, Distance keep) const;
  void report(std::size_t beam, const LidarPose& pose, double time_s, Distance keep) const;
  void report_not_kept(std::size_t beam, const Vec3& point_I_m, double range_m, double time_s,
                       double tower_x_m) const;

  const std::vector<BeamSamples>& beams_;
  const Mounting& mounting_;
  const WindField& field_;
  WindExtent extent_;
  std::vector<double> nearest_m_;
  std::vector<double> farthest_m_;
};

}  // namespace lac::sim
