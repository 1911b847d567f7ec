// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "core/delay_line.hpp"
#include "core/filters.hpp"
#include "monitor/band_spectra.hpp"
#include "monitor/delay_estimator.hpp"
#include "monitor/monitor_params.hpp"

namespace lac {

/// Mean over one update interval; none if a value of it was none.
struct TickMean {
  double sum = 0.0;
  void add(double value) noexcept { sum += value; }  // not a number stays
  double take(int steps) noexcept {
    const double mean = sum / steps;
    sum = 0.0;
    return mean;
  }
  void visit(StateArchive& a) { a(sum); }
};

/// Live comparison of the lidar's wind with the rotor's own.
///
/// The rotor's wind y is TurbineRews. The lidar's, x, is LidarRews delayed by
/// lead - window/2 + delay of y, which brings the two together if the lead is right; both without
/// what is slower than the detrend time. The feedforward's own signal f is its buffered REWS
/// delayed by the actuator and the delay of y: it falls on y if the feedforward acts at the right
/// time.
///
///   delay       lag of y behind x: LaggedMoments, by correlation or after Moddemeijer
///   coherence   of x and y in bands up to the cut-off in use
///   gain        slope of y over f in the bands (over x as long as there is no f): the share of the
///               feedforward that leaves the least of the wind to the feedback. Wrong timing, wrong
///               size and lack of coherence all lower it; below 1/2 the feedforward does harm. What
///               is judged is the slope and one standard deviation: a doubt is for the lidar
///   late        how much later than the wind the feedforward acts, from its own buffer time:
///               T_buffer + atan(w/w_c)/w + T_actuator - (lead - window/2) - delay, at w of
///               DelayFrequency (GUO eq. 40, HM eq. 26); without a feedforward - delay. The peak
///               of a short record may be a wrong one: it counts once `memory` has been compared
///   mean ratio  of y and x, with their slow part
///
/// All sums forget alike: exact means until `memory` has been compared, exponential then. Behind a
/// gap nothing counts before the detrending has settled.
class Monitor {
 public:
  struct Inputs {
    TurbineRews::Inputs turbine;
    double lidar_mps = std::numeric_limits<double>::quiet_NaN();
    bool lidar_valid = false;
    double lead_s = 0.0;
    double window_s = 0.0;
    double buffered_mps = std::numeric_limits<double>::quiet_NaN();  // of the feedforward
    double cutoff_hz = std::numeric_limits<double>::quiet_NaN();     // of the feedforward
    double buffer_time_s = std::numeric_limits<double>::quiet_NaN();
  };
  struct Outputs {
    double turbine_mps = std::numeric_limits<double>::quiet_NaN();
    double authority = 1.0;
    double trim_s = 0.0;
    double delay_s = std::numeric_limits<double>::quiet_NaN();  // rotor wind behind its lidar value
    double coherence = std::numeric_limits<double>::quiet_NaN();
    double gain = std::numeric_limits<double>::quiet_NaN();
    double late_s = std::numeric_limits<double>::quiet_NaN();
    double mean_ratio = std::numeric_limits<double>::quiet_NaN();
    MonitorReason reason = MonitorReason::Learning;
  };
  struct State {
    TurbineRews::State turbine;
    TickMean lidar_mean, turbine_mean, buffered_mean;
    int steps_in_tick = 0;
    DelayLine lidar_line, buffered_line;
    SlowMean lidar_slow, turbine_slow, buffered_slow;  // over the detrend time
    SlowMean lidar_long, turbine_long;                 // over the memory
    LaggedMoments moments;
    Moddemeijer::State moddemeijer;
    BandSpectra lidar_bands;        // x and y
    BandSpectra feedforward_bands;  // f and y
    double compared_s = 0.0;        // x with y
    double acted_s = 0.0;           // f with y
    double lidar_whole_s = 0.0;     // x and y since the last gap
    double buffered_whole_s = 0.0;  // f since the last gap
    Authority::State authority;
    Outputs last;
    void visit(StateArchive& a) {
      a(turbine), a(lidar_mean), a(turbine_mean), a(buffered_mean), a(steps_in_tick);
      a(lidar_line), a(buffered_line), a(lidar_slow), a(turbine_slow), a(buffered_slow);
      a(lidar_long), a(turbine_long), a(moments), a(moddemeijer), a(lidar_bands);
      a(feedforward_bands), a(compared_s), a(acted_s), a(lidar_whole_s), a(buffered_whole_s);
      a(authority);
      a(last.authority), a(last.trim_s), a(last.delay_s), a(last.coherence), a(last.gain);
      a(last.late_s), a(last.mean_ratio), a(last.reason);
    }
  };

  Monitor(const MonitorParams& params, double time_step_s);
  State initial_state() const;
  Outputs step(const Inputs& in, State& state) const noexcept;

 private:
  struct Pair {
    double x_mps, y_mps;  // not a number: none
  };
  void tick(const Inputs& in, State& state) const noexcept;
  Pair compare(const Inputs& in, double lidar_mps, double turbine_mps, State& state) const noexcept;
  void compare_feedforward(double buffered_mps, const Pair& pair, State& state) const noexcept;
  double measured_delay_s(State& state) const noexcept;
  double off_time_s(const Inputs& in) const noexcept;
  void judge(const Inputs& in, double behind_s, Evidence& evidence, State& state) const noexcept;

  MonitorParams params_;
  int steps_per_tick_;
  double tick_s_;
  TurbineRews turbine_;
  Moddemeijer moddemeijer_;
  Authority authority_;
  std::size_t lag_range_;
  double buffered_delay_s_;
};

}  // namespace lac
