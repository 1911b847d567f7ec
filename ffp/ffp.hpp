// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "core/delay_line.hpp"
#include "core/filters.hpp"
#include "ffp/ffp_params.hpp"

namespace lac {

/// Why the feedforward is off, or not fully what was computed. Record FeedforwardReason.
enum class FfpReason {
  None = 0,              // on
  NoWind = 1,            // lidar REWS invalid or stale
  Filling = 2,           // the buffer does not reach back far enough yet
  LeadTooShort = 3,      // the wind arrives before filter, window and actuator have acted
  BufferTooLong = 4,     // LongestBuffer is exceeded
  BelowThreshold = 5,    // wind speed below ThresholdSpeed
  RateLimited = 6,       // on, but the rate is cut to MaximumRate
  OutsideCurve = 7,      // wind speed outside the static pitch curve
  AuthorityReduced = 8,  // on, but the monitor allows a part of it only
  MonitorInvalid = 9,    // the monitor's records are no share of 0 to 1 and no time: none allowed
};

const char* text_of(FfpReason reason);

/// Delay [s] of the first-order low-pass at one frequency: atan(w/w_c)/w (HM eq. 26); 1/w_c for
/// frequency 0.
double filter_delay_s(double cutoff_hz, double frequency_hz);
/// Delay [s] of a second-order actuator: atan2(2 z w w0, w0^2 - w^2)/w; 2 z/w0 for frequency 0;
/// 0 for an ideal one (w0 = 0).
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
/// second from 0 to 1 at most.
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
  };
  struct Outputs {
    double rate_radps = 0.0;
    double pitch_rad = 0.0;  // theta_ss of the buffered wind; 0 while there is none
    double active = 0.0;     // fade, 0 to 1
    double allowed = 1.0;    // share of the faded rate that is given, 0 to 1
    FfpReason reason = FfpReason::NoWind;
    double filtered_mps = std::numeric_limits<double>::quiet_NaN();
    double buffered_mps = std::numeric_limits<double>::quiet_NaN();
    double buffer_time_s = std::numeric_limits<double>::quiet_NaN();
    double cutoff_hz = 0.0;
    double lead_needed_s = 0.0;  // by filter, actuator and window; 0 while unknown
  };
  struct State {
    LowPass1 low_pass;
    DelayLine line;
    double scheduled_at_mps = -1.0;  // mean wind speed the coefficients belong to
    double cutoff_hz = 0.0;
    double filter_factor = 0.0;
    double filter_and_actuator_s = 0.0;
    double buffer_time_s = 0.0;
    bool buffer_started = false;
    double previous_pitch_rad = 0.0;
    bool has_previous = false;
    bool above_threshold = false;
    double active = 0.0;
    double allowed = 0.0;          // by the monitor
    double last_rate_radps = 0.0;  // faded out from when the wind is lost
    double last_lead_s = 0.0;
    double running_s = 0.0;  // since the low-pass started
    bool lead_short = false;
    void visit(StateArchive& a) {
      a(low_pass), a(line), a(scheduled_at_mps), a(cutoff_hz), a(filter_factor);
      a(filter_and_actuator_s), a(buffer_time_s), a(buffer_started), a(previous_pitch_rad);
      a(has_previous), a(above_threshold), a(active), a(last_rate_radps), a(last_lead_s);
      a(running_s), a(lead_short), a(allowed);
    }
  };

  Ffp(FfpParams params, double time_step_s);
  State initial_state() const;
  Outputs step(const Inputs& in, State& state) const noexcept;

 private:
  void schedule(double mean_speed_mps, State& s) const noexcept;
  FfpReason update_wind(const Inputs& in, State& s, Outputs& out) const noexcept;
  FfpReason update_buffer(const Inputs& in, State& s, Outputs& out) const noexcept;
  FfpReason update_pitch(State& s, Outputs& out) const noexcept;
  void forget_wind(State& s) const noexcept;
  void fade(FfpReason reason, State& s) const noexcept;
  FfpReason follow_monitor(const Inputs& in, State& s) const noexcept;

  FfpParams params_;
  double time_step_s_;
};

}  // namespace lac
