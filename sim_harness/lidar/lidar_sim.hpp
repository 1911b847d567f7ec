// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/lidar_block.hpp"
#include "sim_harness/lidar/lidar_params.hpp"
#include "sim_harness/wind/wind_field.hpp"

namespace lac::sim {

/// Tower top along x (down-wind), what the lidar rides on.
struct NacelleMotion {
  double displacement_m = 0.0;
  double velocity_mps = 0.0;
};

/// When and where a lidar measures; the surroundings it is set up in.
struct LidarSetting {
  double hub_height_m = 90.0;
  double control_step_s = 0.0125;
  double end_time_s = 660.0;
};

/// Pulsed lidar on a nacelle with sequential scan.
///
///   v_los = sum_j w_j n . (V_lidar - U(x_lidar + r_j n, t)),  w_j ~ exp(-(r_j - r)^2/(2 sigma^2))
///
/// positive for wind blowing towards the lidar; sigma = FWHM/(2 sqrt(2 ln 2)), sum w_j = 1
/// (methods section 4, GUO eq. 26). The points r_j within three sigma of a gate lie on one grid
/// per beam, so that neighbouring gates share them. The field carries itself with Taylor's
/// hypothesis.
///
/// Time: measurement k = 0, 1, ... of beam k modulo the number of beams is completed at
/// t_k = (k + 1) beam_time and is handed over in the first control step at or after t_k, in that
/// step alone. Its wind is that at t_k (no averaging over the beam time), its nacelle motion that
/// of the step. So beam times need not be multiples of the control step; they may not be shorter.
/// The roll, pitch and yaw it reports are the constant (0, tilt, pi): the tower does not rotate.
class LidarSim {
 public:
  /// The field must outlive this object. Throws lac::Error if the beam time is shorter than the
  /// control step, or if a beam leaves the extent of the field: which beam, gate, by how far.
  LidarSim(LidarParams params, const WindField& field, const LidarSetting& setting);

  /// To be called for steps 0, 1, 2, ... True if a measurement was completed.
  bool step(std::int64_t step, const NacelleMotion& motion, LidarMeasurement& measurement);

 private:
  /// One gate: which of the beam's points it sees, and how much of each.
  struct Gate {
    double range_m = 0.0;
    std::size_t first_point = 0;
    std::vector<double> weights;
  };
  struct Beam {
    Vec3 dir_L;
    Vec3 dir_I;
    std::vector<double> points_m;  // ranges at which the wind is taken
    std::vector<Gate> gates;
  };

  Beam make_beam(const LidarBeam& angles) const;
  void add_gate(double range_m, Beam& beam) const;
  void check_extent(const Beam& beam, std::size_t number) const;
  void measure(double time_s, const NacelleMotion& motion, LidarMeasurement& m);

  LidarParams params_;
  const WindField& field_;
  LidarSetting setting_;
  std::vector<Beam> beams_;
  std::vector<double> wind_along_mps_;  // n . U at the points of a beam
  std::int64_t done_ = 0;               // measurements handed over
};

}  // namespace lac::sim
