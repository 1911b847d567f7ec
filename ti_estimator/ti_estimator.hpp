// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/filters.hpp"
#include "ti_estimator/speed_statistics.hpp"
#include "ti_estimator/ti_estimator_params.hpp"

namespace lac {

/// Turbulence intensity from line-of-sight speeds (S20; methods section 6), and the power level
/// that goes with it.
///
/// Each valid sample becomes a longitudinal wind speed
///   u = (v_los - n_I . V_lidar) / (-n_x),   n_x: along the mean wind,
/// v_los positive towards the lidar. Per beam b and gate, over the last T seconds: mean and sample
/// standard deviation (SpeedStatistics). With the series that hold enough samples,
///   TI = mean(c_TI,b |n_x,b| std(u)) / U,   U = mean(mean(u)),
/// means by the weights of the gates.
/// For a beam at rest |n_x| std(u) is std(v_los), S20's quantity; formed from u it is blind to slow
/// turns of the beam. There is no estimate before T has passed, with no series filled, and for U
/// or yaw error outside the c_TI table or not known.
///
/// Beside it, if asked for, the competitors of IntensitySource. One of them all drives the power
/// level.
class TiEstimator {
 public:
  struct Inputs {
    const LidarMeasurement* measurement = nullptr;  // nullptr: nothing new in this step
    double time_s = 0.0;
    double yaw_error_rad = 0.0;  // used with UseYawError only
    double anemometer_mps = std::numeric_limits<double>::quiet_NaN();
    double turbine_rews_mps = std::numeric_limits<double>::quiet_NaN();
    double ldp_mean_speed_mps = std::numeric_limits<double>::quiet_NaN();  // MeanSpeedSource ldp
  };
  using Estimates = std::array<IntensityEstimate, kIntensitySources>;
  struct Outputs {
    double intensity = std::numeric_limits<double>::quiet_NaN();  // TI of the lidar [-]
    double mean_speed_mps = std::numeric_limits<double>::quiet_NaN();
    Estimates estimates;  // of each IntensitySource
    int filled_series = 0;
    double power_level = 1.0;
    bool power_level_valid = false;
    bool outside_table = false;
    bool ldp_missing = false;  // LDP has not given the mean speed or yaw error asked for
    // About this step's measurement:
    bool too_many_gates = false;   // more than NumberOfGates
    bool other_direction = false;  // beam more than 2 deg from BeamAzimuth, BeamElevation
    bool no_room = false;          // came much faster than ScanTime says, not used
    bool valid() const { return intensity == intensity; }
  };
  struct State {
    struct Beam {  // sums over the filled series, by the weights of their gates
      double sum_of_std_mps = 0.0;
      double sum_of_mean_mps = 0.0;
      double sum_of_weights = 0.0;
      int filled = 0;
      void visit(StateArchive& a) {
        a(sum_of_std_mps), a(sum_of_mean_mps), a(sum_of_weights), a(filled);
      }
    };
    SpeedStatistics window;
    std::vector<Beam> beams;
    SlowMean yaw_error_rad;
    double intensity = std::numeric_limits<double>::quiet_NaN();
    double mean_speed_mps = std::numeric_limits<double>::quiet_NaN();
    double uncorrected = std::numeric_limits<double>::quiet_NaN();
    int filled_series = 0;
    bool outside_table = false;
    bool ldp_missing = false;
    SignalIntensity::State anemometer;
    SignalIntensity::State turbine;
    PowerLevel power_level;
    void visit(StateArchive& a) {
      a(window), a(beams), a(yaw_error_rad), a(intensity), a(mean_speed_mps), a(uncorrected);
      a(filled_series), a(outside_table), a(ldp_missing), a(anemometer), a(turbine), a(power_level);
    }
  };

  TiEstimator(TiEstimatorParams params, double time_step_s);
  State initial_state() const;
  /// In a step without a measurement only the power level moves and one old row may leave.
  Outputs step(const Inputs& in, State& state) const noexcept;

 private:
  void take_in(const LidarMeasurement& m, double time_s, State& state, Outputs& out) const noexcept;
  bool is_other_direction(const LidarMeasurement& m) const noexcept;
  void update_beam(int beam, double time_s, State& state) const noexcept;
  void update_estimate(const Inputs& in, State& state) const noexcept;
  Estimates estimates(const Inputs& in, State& state) const noexcept;

  TiEstimatorParams params_;
  double time_step_s_;
  CorrectionTable table_;
  SignalIntensity anemometer_;
  SignalIntensity turbine_;
};

}  // namespace lac
