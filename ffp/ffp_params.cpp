// SPDX-License-Identifier: Apache-2.0
#include "ffp/ffp_params.hpp"

#include "core/units.hpp"

namespace lac {

FfpParams FfpParams::read(InputFile& in) {
  FfpParams p;
  const Range positive = Range::positive();
  const Range not_negative = Range::not_negative();
  p.cutoff_hz = read_table(in, "CutOffWindSpeed", "CutOffFrequency", 1.0, positive);
  p.delay_frequency_hz = in.number("DelayFrequency", p.delay_frequency_hz, not_negative);
  p.actuator_frequency_hz = in.number("ActuatorFrequency", p.actuator_frequency_hz, not_negative);
  p.actuator_damping = in.number("ActuatorDamping", p.actuator_damping, positive);
  p.buffer_trim_s = in.number("BufferTrim", p.buffer_trim_s, Range::between(-60.0, 60.0));
  p.buffer_time_constant_s =
      in.number("BufferTimeConstant", p.buffer_time_constant_s, not_negative);
  p.longest_buffer_s = in.number("LongestBuffer", p.longest_buffer_s, Range::between(0.0, 600.0));
  p.static_pitch_rad =
      read_table(in, "StaticWind", "StaticPitch", rad_from_deg(1.0), Range::between(-10.0, 90.0));
  const auto& pitch = p.static_pitch_rad.y();
  for (std::size_t i = 1; i < pitch.size(); ++i) {
    if (pitch[i] < pitch[i - 1]) {
      in.fail("StaticPitch", "value " + std::to_string(i + 1) + " (" +
                                 std::to_string(deg_from_rad(pitch[i])) +
                                 " deg) falls, expected a curve that never falls");
    }
  }
  p.threshold_mps = in.number("ThresholdSpeed", p.threshold_mps, not_negative);
  p.hysteresis_mps = in.number("Hysteresis", p.hysteresis_mps, not_negative);
  p.fade_time_s = in.number("FadeTime", p.fade_time_s, positive);
  p.max_rate_radps =
      rad_from_deg(in.number("MaximumRate", deg_from_rad(p.max_rate_radps), positive));
  in.finish();
  return p;
}

}  // namespace lac
