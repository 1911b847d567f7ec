// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/extrapolation_inverse.hpp"
#include "core/input_file.hpp"
#include "core/lidar_block.hpp"
#include "core/notice.hpp"
#include "core/order_watch.hpp"

namespace lac {

struct OpenFastLidarParams {
  // InterpOrder of the .fst file; 0: take the values as they come.
  int interpolation_order = 0;
  // Of the InflowWind file. 0: unknown, a measurement is new when a speed has changed.
  double measurement_interval_s = 0.0;
  // x of the rotor centre in OpenFAST's global frame, undeflected.
  double rotor_position_x_m = 0.0;
  // "<file>:<line>: <key>" of LidarLayout, MeasurementInterval, RotorPositionX, for messages.
  std::string layout_at, interval_at, rotor_at;

  /// Keys InterpolationOrder, MeasurementInterval [s], RotorPositionX [m]. Refuses keys that
  /// describe what this block says itself.
  static OpenFastLidarParams read(InputFile& in);
};

/// Measurements out of OpenFAST's own block (records 2001 on, 3.5 and later): one beam straight
/// up-wind, each measured point a gate at the distance from the rotor that the block gives.
///
/// The extrapolation in time is undone at each call (extrapolation_inverse.hpp); what comes out
/// belongs to the step before, which is the time of the measurement. The block carries no flag for
/// new data: with the interval a measurement is new when a multiple of it has been passed, without
/// it when a speed has moved. Sensor type 1 sends the length of the wind vector, taken as u; type 2
/// is refused.
class OpenFastLidar {
 public:
  /// Points nearer to the rotor than this, or behind it, are not used.
  static constexpr double kRotorClearance_m = 2.0;

  struct State {
    OpenFastHeader header;  // as in the first call
    std::array<ExtrapolationInverse, openfast_lidar::kMaxPoints> speed, x;
    std::array<double, openfast_lidar::kMaxPoints> taken_mps{};  // of the last measurement
    double last_call_s = 0.0;  // what the first call carries was measured in it
    std::int64_t last_interval = 0;
    OrderWatch watch;
    bool started = false, header_reported = false, behind_reported = false;
    void visit(StateArchive& a) {
      a(header.sensor_type), a(header.beams), a(header.gates), a(speed), a(x), a(taken_mps);
      a(last_call_s), a(last_interval), a(watch), a(started), a(header_reported);
      a(behind_reported);
    }
  };

  explicit OpenFastLidar(OpenFastLidarParams params);

  /// Checks the block at the first call. Throws lac::Error if there is no lidar, or none that can
  /// be used; warns if the interval is one of which OpenFAST skips measurements.
  void require(const SwapReader& swap, double time_step_s, Notice& notice) const;
  State initial_state() const { return {}; }
  /// To be called at every step. True if a measurement is new. Reports once: another lidar than at
  /// the start, points behind the rotor, an order or an interval that is not the host's.
  bool fetch(const SwapReader& swap, double time_s, State& state, LidarMeasurement& m,
             Notice& notice) const noexcept;

 private:
  struct Values {
    std::array<double, openfast_lidar::kMaxPoints> speed_mps, x_m;
  };

  bool is_same_lidar(const SwapReader& swap, State& state, Notice& notice) const noexcept;
  Values settled_values(const SwapReader& swap, State& state) const noexcept;
  bool is_new(const Values& now, State& state) const noexcept;
  void fill(const Values& now, State& state, LidarMeasurement& m, Notice& notice) const noexcept;
  void watch(const SwapReader& swap, bool scheduled, State& state, Notice& notice) const noexcept;

  OpenFastLidarParams params_;
};

/// Share of the measurements due in ten minutes that OpenFAST takes: only when t/interval has no
/// rest in double precision, with t = n time_step_s. 1 if none is due at a step.
double share_of_measurements_taken(double interval_s, double time_step_s);

}  // namespace lac
