// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "core/delay_line.hpp"
#include "ffp/ffp_params.hpp"
#include "ffp/ffp_reason.hpp"
#include "ffp/low_pass.hpp"

namespace lac {

/// Delay [s] of the second-order actuator (second_order_delay_s); 0 for an ideal one (0 Hz).
double actuator_delay_s(double actuator_hz, double damping, double frequency_hz);

/// Collective feedforward pitch: lidar REWS -> low-pass -> buffer -> static pitch curve -> rate.
///
///   T_buffer = T_lead - T_filter - T_actuator - T_window/2 + trim        (GUO eq. 40)
///   theta_FF = theta_ss(u_LL filtered, T_buffer ago),  rate = d theta_FF/dt by differences (37,
///   38)
///
/// The rate is faded in and out linearly; whatever makes it go off is in `reason`. After wind was
/// lost the low-pass starts anew and has to settle before its output is used. A monitor may trim
/// the buffer and allow a share of the rate; the share in use follows what it allows, within half a
/// second from 0 to 1 at most. With LargestPitch the pitch it has added, forgotten with
/// LargestPitchTime T as the feedback takes it over, e' = rate - e/T, is kept within a limit.
class Ffp {
 public:
  struct Inputs {
    double rews_mps = std::numeric_limits<double>::quiet_NaN();
    bool valid = false;
    double lead_s = 0.0;
    double window_s = 0.0;
    double mean_speed_mps = std::numeric_limits<double>::quiet_NaN();
    double monitor_authority = 1.0;  // with UseMonitor only
    double monitor_trim_s = 0.0;
    // Not a number: not known, no correction of the cut-off and rated power.
    double turbulence_intensity = std::numeric_limits<double>::quiet_NaN();
    double power_level = std::numeric_limits<double>::quiet_NaN();
    bool monitor_is_usable() const noexcept {
      return monitor_authority >= 0.0 && monitor_authority <= 1.0 && std::isfinite(monitor_trim_s);
    }
  };
  struct Outputs {
    double rate_radps = 0.0;
    double pitch_rad = 0.0;  // theta_ss of the buffered wind; 0 while there is none
    double active = 0.0;     // fade times the weight of the entry, 0 to 1
    double allowed = 1.0;    // share of the faded rate that is given, 0 to 1
    FfpReason reason = FfpReason::NoWind;
    double filtered_mps = std::numeric_limits<double>::quiet_NaN();
    double buffered_mps = std::numeric_limits<double>::quiet_NaN();
    double buffer_time_s = std::numeric_limits<double>::quiet_NaN();
    double cutoff_hz = 0.0;
    double lead_needed_s = 0.0;  // by filter, actuator and window; 0 while unknown
  };
  struct State {
    FeedforwardLowPass low_pass;
    DelayLine line;
    double scheduled_at_mps = -1.0;  // mean wind speed the coefficients belong to
    double cutoff_hz = 0.0;
    FeedforwardLowPass::Coefficients filter;
    double turbulence_factor = 1.0;
    double scheduled_factor = 1.0;
    double filter_and_actuator_s = 0.0;
    double buffer_time_s = 0.0;
    bool buffer_started = false;
    double previous_wind_mps = 0.0;  // behind the buffer
    bool has_previous = false;
    bool above_threshold = false;
    double entry_weight = 1.0;
    double active = 0.0;
    double allowed = 0.0;          // by the monitor
    double added_pitch_rad = 0.0;  // by the feedforward, as far as not forgotten
    double last_rate_radps = 0.0;  // faded out from when the wind is lost
    double last_lead_s = 0.0;
    double running_s = 0.0;  // since the low-pass started
    bool lead_short = false;
    void visit(StateArchive& a) {
      a(low_pass), a(line), a(scheduled_at_mps), a(cutoff_hz), a(filter), a(turbulence_factor);
      a(scheduled_factor), a(added_pitch_rad), a(entry_weight);
      a(filter_and_actuator_s), a(buffer_time_s), a(buffer_started), a(previous_wind_mps);
      a(has_previous), a(above_threshold), a(active), a(last_rate_radps), a(last_lead_s);
      a(running_s), a(lead_short), a(allowed);
    }
  };

  Ffp(FfpParams params, double time_step_s);
  State initial_state() const;
  Outputs step(const Inputs& in, State& state) const noexcept;

 private:
  double damping_at(double mean_speed_mps) const noexcept;
  void schedule(const Inputs& in, State& s) const noexcept;
  FfpReason update_wind(const Inputs& in, State& s, Outputs& out) const noexcept;
  FfpReason update_buffer(const Inputs& in, State& s, Outputs& out) const noexcept;
  FfpReason update_pitch(const Inputs& in, State& s, Outputs& out) const noexcept;
  FfpReason enter(double power_level, State& s, const Outputs& out) const noexcept;
  double reduced_part(double power_level) const noexcept;
  double pitch_at_rad(double wind_mps, double power_level) const noexcept;
  double slope_at_radpmps(double wind_mps, double power_level) const noexcept;
  void forget_wind(State& s) const noexcept;
  void fade(FfpReason reason, State& s) const noexcept;
  FfpReason follow_monitor(const Inputs& in, State& s) const noexcept;
  FfpReason limit_pitch(State& s, Outputs& out) const noexcept;

  FfpParams params_;
  double time_step_s_;
};

}  // namespace lac
