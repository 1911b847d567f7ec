// SPDX-License-Identifier: Apache-2.0
#include "monitor/monitor_params.hpp"

namespace lac {
namespace {

const Range kTime_s = Range::between(0.1, 36000.0);
const Range kShare = Range::between(0.0, 1.0);

/// A value that a second key must exceed.
void read_ramp(InputFile& in, const char* off_key, const char* on_key, double& off, double& on) {
  off = in.number(off_key, off, kShare);
  on = in.number(on_key, on, kShare);
  if (on > off) return;
  in.fail(in.has(on_key) ? on_key : off_key,
          "found " + shortest(in.has(on_key) ? on : off) + ", expected " + on_key +
              " to be more than " + off_key + " (" + shortest(on) + " and " + shortest(off) + ")");
}

void read_bands(InputFile& in, MonitorParams& p) {
  const Range band_hz{0.001, 0.5};
  if (in.has("BandFrequencies")) p.band_hz = in.numbers("BandFrequencies", band_hz);
  for (std::size_t i = 1; i < p.band_hz.size(); ++i) {
    if (p.band_hz[i] <= p.band_hz[i - 1]) {
      in.fail("BandFrequencies", "values do not rise, expected rising");
    }
  }
  p.band_width_hz = in.number("BandWidth", p.band_width_hz, Range::between(0.001, 0.1));
}

void read_delay(InputFile& in, MonitorParams& p) {
  p.delay_method =
      static_cast<DelayMethod>(in.choice("DelayMethod", 0, {"correlation", "moddemeijer"}));
  p.lag_range_s = in.number("LagRange", p.lag_range_s, Range::between(0.5, 60.0));
  p.sample_spacing_s = in.number("SampleSpacing", p.sample_spacing_s, Range::between(0.05, 10.0));
  p.minimum_correlation = in.number("MinimumCorrelation", p.minimum_correlation, kShare);
  p.longest_lead_s = in.number("LongestLead", p.longest_lead_s, Range::between(1.0, 600.0));
  p.actuator_delay_s = in.number("ActuatorDelay", p.actuator_delay_s, Range::between(0.0, 10.0));
  p.delay_frequency_hz =
      in.number("DelayFrequency", p.delay_frequency_hz, Range::between(0.001, 1.0));
  p.filter_order = in.integer("FilterOrder", p.filter_order, Range::between(1, 2));
  p.filter_damping = in.number("FilterDamping", p.filter_damping, Range::between(0.05, 5.0));
  p.maximum_trim_s = in.number("MaximumTrim", p.maximum_trim_s, Range::between(0.0, 10.0));
  p.trim_time_s = in.number("TrimTime", p.trim_time_s, Range::between(50.0, 36000.0));
}

void read_authority(InputFile& in, AuthorityParams& p) {
  p.unknown = in.number("UnknownAuthority", p.unknown, kShare);
  read_ramp(in, "CoherenceOff", "CoherenceOn", p.coherence_off, p.coherence_on);
  read_ramp(in, "GainOff", "GainOn", p.gain_off, p.gain_on);
  p.delay_tolerance_s = in.number("DelayTolerance", p.delay_tolerance_s, Range::between(0.1, 60.0));
  p.mean_tolerance = in.number("MeanTolerance", p.mean_tolerance, Range::between(0.01, 1.0));
  p.hysteresis = in.number("Hysteresis", p.hysteresis, Range::between(0.0, 0.9));
  p.fall_time_s = in.number("FallTime", p.fall_time_s, kTime_s);
  p.rise_time_s = in.number("RiseTime", p.rise_time_s, kTime_s);
}

}  // namespace

MonitorParams MonitorParams::read(InputFile& in) {
  MonitorParams p{TurbineRewsParams::read(in)};
  p.update_interval_s = in.number("UpdateInterval", p.update_interval_s, Range::between(0.01, 2.0));
  p.memory_s = in.number("Memory", p.memory_s, Range::between(30.0, 36000.0));
  p.learning_s = in.number("LearningTime", p.learning_s, Range::between(10.0, 36000.0));
  p.detrend_s = in.number("DetrendTime", p.detrend_s, Range::between(2.0, 3600.0));
  read_bands(in, p);
  read_delay(in, p);
  read_authority(in, p.authority);
  in.finish();
  return p;
}

void MonitorParams::check_time_step(const InputFile& in, double time_step_s) const {
  turbine.check_time_step(in, time_step_s);
  if (update_interval_s < time_step_s * (1.0 - 1e-9)) {
    in.fail("UpdateInterval", "found " + shortest(update_interval_s) +
                                  " s, expected at least one step of " + shortest(time_step_s) +
                                  " s");
  }
  if (band_hz.back() + band_width_hz >= 0.5 / update_interval_s) {
    in.fail("BandFrequencies", "found " + shortest(band_hz.back()) + " Hz, expected less than " +
                                   shortest(0.5 / update_interval_s - band_width_hz) +
                                   " Hz with this UpdateInterval and BandWidth");
  }
}

}  // namespace lac
