// SPDX-License-Identifier: Apache-2.0
#include "ffp/ffp_params.hpp"

#include <algorithm>

#include "core/units.hpp"

namespace lac {

FfpParams FfpParams::read(InputFile& in) {
  FfpParams p;
  const Range positive = Range::positive();
  const Range fade_s{0.0, 600.0, false};
  const Range not_negative = Range::not_negative();
  p.cutoff_hz = read_table(in, "CutOffWindSpeed", "CutOffFrequency", 1.0, positive);
  p.delay_frequency_hz = in.number("DelayFrequency", p.delay_frequency_hz, not_negative);
  p.actuator_frequency_hz =
      in.number("ActuatorFrequency", p.actuator_frequency_hz, Range::between(0.0, 100.0));
  p.actuator_damping = in.number("ActuatorDamping", p.actuator_damping, {0.0, 10.0, false});
  p.buffer_trim_s = in.number("BufferTrim", p.buffer_trim_s, Range::between(-60.0, 60.0));
  p.buffer_time_constant_s =
      in.number("BufferTimeConstant", p.buffer_time_constant_s, Range::between(0.0, 3600.0));
  p.longest_buffer_s = in.number("LongestBuffer", p.longest_buffer_s, Range::between(0.0, 600.0));
  p.static_pitch_rad =
      read_table(in, "StaticWind", "StaticPitch", rad_from_deg(1.0), Range::between(-10.0, 90.0));
  const auto& pitch = p.static_pitch_rad.y();
  for (std::size_t i = 1; i < pitch.size(); ++i) {
    if (pitch[i] < pitch[i - 1]) {
      in.fail("StaticPitch", "value " + std::to_string(i + 1) + " (" +
                                 shortest(deg_from_rad(pitch[i])) +
                                 " deg) falls, expected a curve that never falls");
    }
  }
  p.threshold_mps = in.number("ThresholdSpeed", p.threshold_mps, Range::between(0.0, 100.0));
  p.hysteresis_mps = in.number("Hysteresis", p.hysteresis_mps, not_negative);
  if (p.hysteresis_mps > p.threshold_mps) {
    in.fail("Hysteresis", "found " + shortest(p.hysteresis_mps) +
                              " m/s, expected no more than ThresholdSpeed, " +
                              shortest(p.threshold_mps) + ": it would never go off");
  }
  p.fade_time_s = in.number("FadeTime", p.fade_time_s, fade_s);
  p.max_rate_radps =
      rad_from_deg(in.number("MaximumRate", deg_from_rad(p.max_rate_radps), positive));
  p.use_monitor = in.flag("UseMonitor", p.use_monitor);
  in.finish();
  return p;
}

void FfpParams::check_time_step(const InputFile& in, double time_step_s) const {
  const double nyquist_hz = 0.5 / time_step_s;
  const auto require_below_nyquist = [&](const char* key, double frequency_hz) {
    if (frequency_hz < nyquist_hz) return;
    in.fail(key, "found " + shortest(frequency_hz) + " Hz, expected less than " +
                     shortest(nyquist_hz) + " Hz, half the rate at which the host calls");
  };
  const std::vector<double>& cutoff = cutoff_hz.y();
  require_below_nyquist("CutOffFrequency", *std::max_element(cutoff.begin(), cutoff.end()));
  require_below_nyquist("DelayFrequency", delay_frequency_hz);
  if (fade_time_s < time_step_s) {
    in.fail("FadeTime", "found " + shortest(fade_time_s) + " s, expected at least one step of " +
                            shortest(time_step_s) + " s: it would be a jump");
  }
}

}  // namespace lac
