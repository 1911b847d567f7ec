// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/input_file.hpp"
#include "core/state_archive.hpp"
#include "core/vec3.hpp"

namespace lac {

/// Which quantities of the wind are estimated beside u.
enum class WindModel { U, UShear, UV, UVW, All };

/// Value of the record LidarReconstruction.
enum class WindReason {
  Off = 0,       // WindModel u
  Complete = 1,  // all quantities of the model are there
  Settling = 2,  // the first ReconstructionWindow has not passed
  Partly = 3,    // the geometry cannot tell some of them
  Refused = 4,   // ... any of them
  Stale = 5,     // the lidar has been silent
};

struct WindModelParams {
  WindModel model = WindModel::U;
  double window_s = 300.0;  // weights: mean over it, exponential forgetting after
  double largest_condition = 30.0;
  double hub_height_m = 0.0;         // height at which u and the shears are taken
  double rotor_radius_m = 0.0;       // length that makes the shears comparable with u
  std::vector<double> gate_weights;  // by gate; empty: 1
  bool average_if_refused = false;

  /// Keys WindModel and, only with other models than u, ReconstructionWindow, LargestCondition,
  /// HubHeight, RotorRadius, GateWeights, WhenRefused. Throws lac::Error.
  static WindModelParams read(InputFile& in, bool sees_across);
};

/// Wind as a linear field, by least squares over many scans (methods section 8).
///
///   U(x, y, z) = (c (u + u_y y + u_z (z - h) + u_x (x - x_mean)), v, w)        frame I
///
/// One sample is one row,  v_los - n . V_lidar = -n . U,  with c the induction at its gate (1
/// without a correction). WindModel says which of v, w, u_y, u_z are asked for; others count as 0.
/// u_x is not reported: it is eliminated, so that what only a change along the beam could tell
/// (the shear, from one oblique beam with several gates) counts as unknown, and a wind that slows
/// towards the rotor is not taken for one of the others.
///
/// Conditions: with w_i the eigenvalues of the normal matrix (columns u, v, w, u_y R, u_z R), a
/// combination of quantities with w_i < w_max / condition^2 cannot be told. A quantity with 1 % or
/// more of its square in such combinations is not a number, the others are the solution of least
/// norm. Two level beams tell v or u_y, not both, and no u_z; v and u_y (w and u_z) are one and
/// the same to beams that cross the axis and measure at one distance d only: v = -d u_y.
class WindReconstruction {
 public:
  struct Sample {
    Vec3 beam_dir_I;
    Vec3 from_hub_I_m;       // gate, from the point of frame I at hub height above its origin
    double los_mps = 0.0;    // v_los - n . V_lidar
    double induction = 1.0;  // c
    double weight = 1.0;
  };
  /// Slow; not a number: not known.
  struct Estimate {
    WindReason reason = WindReason::Off;
    double u_mps = std::numeric_limits<double>::quiet_NaN();
    double v_mps = std::numeric_limits<double>::quiet_NaN();
    double w_mps = std::numeric_limits<double>::quiet_NaN();
    double du_dy_per_s = std::numeric_limits<double>::quiet_NaN();
    double du_dz_per_s = std::numeric_limits<double>::quiet_NaN();
    /// Wind direction minus the direction of the viewing axis: positive if the wind blows to the
    /// left looking down-wind.
    double yaw_error_rad = std::numeric_limits<double>::quiet_NaN();
    double inflow_angle_rad = std::numeric_limits<double>::quiet_NaN();  // upwards positive
    double condition = std::numeric_limits<double>::quiet_NaN();         // infinite: singular
    /// The geometry cannot tell what the model asks for, or a part of it.
    bool is_refused() const {
      return reason == WindReason::Partly || reason == WindReason::Refused;
    }
    void visit(StateArchive& a) {
      a(reason), a(u_mps), a(v_mps), a(w_mps), a(du_dy_per_s), a(du_dz_per_s);
      a(yaw_error_rad), a(inflow_angle_rad), a(condition);
    }
  };

  static constexpr std::size_t kColumns = 6;  // u v w u_y u_z u_x
  using Matrix = std::array<std::array<double, kColumns>, kColumns>;
  using Column = std::array<double, kColumns>;
  struct State {
    Matrix normal{};  // upper triangle; means over the measurements, not sums
    Column right{};
    double elapsed_s = 0.0;  // of measurements with samples, up to the window
    double since_solved_s = 0.0;
    double last_s = -1.0e30;   // measurement
    double heading_rad = 0.0;  // mean of the viewing axis against up-wind
    Estimate estimate;
    void visit(StateArchive& a) {
      a(normal), a(right), a(elapsed_s), a(since_solved_s), a(last_s), a(heading_rad), a(estimate);
    }
  };
  /// Sums over the gates of one measurement, to be handed over by add().
  struct Sums {
    Matrix normal{};
    Column right{};
    double weight = 0.0;
  };

  WindReconstruction() = default;
  explicit WindReconstruction(WindModelParams params) : params_(std::move(params)) {}
  bool active() const { return params_.model != WindModel::U; }
  State initial_state() const;

  void add(const Sample& sample, Sums& sums) const noexcept;
  /// One measurement. Solves anew after a scan, or a hundredth of the window if that is longer.
  /// After a silence as long as the window it starts anew.
  struct Measurement {
    double time_s = 0.0;
    double share_s = 0.25;  // of the scan, that one measurement stands for
    double scan_time_s = 1.0;
    double heading_rad = 0.0;  // as in State
  };
  void add(const Sums& sums, const Measurement& m, State& state) const noexcept;
  /// At once, from what was added.
  void solve(State& state) const noexcept;
  /// Withdraws the estimate after a tenth of the window, at least two scans, without a sample.
  void watch(double time_s, double scan_time_s, State& state) const noexcept;

  /// u of the rotor axis from one sample, with the slow estimates of everything else; those that
  /// are not known count as 0.
  static double axial_mps(const Sample& s, const Estimate& e) noexcept;
  const WindModelParams& params() const { return params_; }

 private:
  WindModelParams params_;
};

}  // namespace lac
