// SPDX-License-Identifier: Apache-2.0
#include "ffp/ffp_params.hpp"

#include <algorithm>

#include "core/units.hpp"

namespace lac {

namespace {

/// A key that another one makes meaningless is a misunderstanding.
void refuse(const InputFile& in, bool is_there, const char* key, const std::string& why) {
  if (is_there) in.fail(key, "has no meaning " + why);
}

void read_filter(InputFile& in, FfpParams& p) {
  p.cutoff_hz = read_table(in, "CutOffWindSpeed", "CutOffFrequency", 1.0, Range::positive());
  p.filter_order = in.integer("FilterOrder", p.filter_order, Range::between(1.0, 2.0));
  if (p.filter_order == 2) {
    p.damping = read_table(in, "CutOffWindSpeed", "FilterDamping", 1.0, Range::between(0.3, 2.0));
  } else {
    refuse(in, in.has("FilterDamping"), "FilterDamping", "with FilterOrder 1");
  }
  if (in.has("CutOffTurbulence")) {
    p.turbulence_factor = read_table(in, "CutOffTurbulence", "CutOffTurbulenceFactor", 1.0,
                                     Range::between(0.1, 10.0));
  } else {
    refuse(in, in.has("CutOffTurbulenceFactor"), "CutOffTurbulenceFactor",
           "without CutOffTurbulence");
  }
}

void read_buffer(InputFile& in, FfpParams& p) {
  const Range trim_s = Range::between(-60.0, 60.0);
  if (in.has("BufferTrimWindSpeed")) {
    p.buffer_trim_s = read_table(in, "BufferTrimWindSpeed", "BufferTrim", 1.0, trim_s);
  } else {
    p.buffer_trim_s = {{0.0}, {in.number("BufferTrim", 0.0, trim_s)}};
  }
  p.buffer_time_constant_s =
      in.number("BufferTimeConstant", p.buffer_time_constant_s, Range::between(0.0, 3600.0));
  p.longest_buffer_s = in.number("LongestBuffer", p.longest_buffer_s, Range::between(0.0, 600.0));
  if (!in.has("FixedBuffer")) return;
  p.fixed_buffer_s = in.number("FixedBuffer", Range::between(0.0, p.longest_buffer_s));
  refuse(in, in.has("BufferTrim"), "BufferTrim", "with FixedBuffer");
}

void read_curves(InputFile& in, FfpParams& p) {
  const Range pitch_deg = Range::between(-10.0, 90.0);
  const auto read_curve = [&](const char* key) {
    LookupTable curve = read_table(in, "StaticWind", key, rad_from_deg(1.0), pitch_deg);
    const auto& pitch = curve.y();
    for (std::size_t i = 1; i < pitch.size(); ++i) {
      if (pitch[i] < pitch[i - 1]) {
        in.fail(key, "value " + std::to_string(i + 1) + " (" + shortest(deg_from_rad(pitch[i])) +
                         " deg) falls, expected a curve that never falls");
      }
    }
    return curve;
  };
  p.static_pitch_rad = read_curve("StaticPitch");
  if (in.has("ReducedStaticPitch")) {
    p.reduced_pitch_rad = read_curve("ReducedStaticPitch");
    p.reduced_power_level = in.number("ReducedPowerLevel", Range::between(0.05, 0.99));
  } else {
    refuse(in, in.has("ReducedPowerLevel"), "ReducedPowerLevel", "without ReducedStaticPitch");
  }
}

void read_threshold(InputFile& in, FfpParams& p) {
  p.threshold_mps = in.number("ThresholdSpeed", p.threshold_mps, Range::between(0.0, 100.0));
  p.hysteresis_mps = in.number("Hysteresis", p.hysteresis_mps, Range::not_negative());
  if (p.hysteresis_mps > p.threshold_mps) {
    in.fail("Hysteresis", "found " + shortest(p.hysteresis_mps) +
                              " m/s, expected no more than ThresholdSpeed, " +
                              shortest(p.threshold_mps) + ": it would never go off");
  }
}

void read_entry(InputFile& in, FfpParams& p) {
  p.entry = static_cast<EntryRule>(in.choice("Entry", 0, {"threshold", "blend", "slope"}));
  if (p.entry == EntryRule::Threshold) {
    read_threshold(in, p);
  } else {
    for (const char* key : {"ThresholdSpeed", "Hysteresis"})
      refuse(in, in.has(key), key, "unless Entry is threshold");
  }
  if (p.entry == EntryRule::Blend) {
    const auto speeds =
        in.numbers("BlendSpeeds", 2, "from and to (2 speeds)", Range::between(0.0, 100.0));
    p.blend_from_mps = speeds[0], p.blend_to_mps = speeds[1];
    if (!(speeds[1] > speeds[0])) in.fail("BlendSpeeds", "expected a second speed above the first");
  } else {
    refuse(in, in.has("BlendSpeeds"), "BlendSpeeds", "unless Entry is blend");
  }
  if (p.entry == EntryRule::Slope) {
    p.largest_slope_radpmps = rad_from_deg(in.number("LargestSlope", Range::positive()));
  } else {
    refuse(in, in.has("LargestSlope"), "LargestSlope", "unless Entry is slope");
  }
}

}  // namespace

FfpParams FfpParams::read(InputFile& in) {
  FfpParams p;
  const Range positive = Range::positive();
  const Range fade_s{0.0, 600.0, false};
  const Range not_negative = Range::not_negative();
  read_filter(in, p);
  p.delay_frequency_hz = in.number("DelayFrequency", p.delay_frequency_hz, not_negative);
  p.actuator_frequency_hz =
      in.number("ActuatorFrequency", p.actuator_frequency_hz, Range::between(0.0, 100.0));
  p.actuator_damping = in.number("ActuatorDamping", p.actuator_damping, {0.0, 10.0, false});
  read_buffer(in, p);
  read_curves(in, p);
  read_entry(in, p);
  p.fade_time_s = in.number("FadeTime", p.fade_time_s, fade_s);
  p.max_rate_radps =
      rad_from_deg(in.number("MaximumRate", deg_from_rad(p.max_rate_radps), positive));
  if (in.has("LargestPitch"))
    p.largest_pitch_rad = rad_from_deg(in.number("LargestPitch", positive));
  p.largest_pitch_time_s =
      in.number("LargestPitchTime", p.largest_pitch_time_s, Range::between(1.0, 1e4));
  p.use_monitor = in.flag("UseMonitor", p.use_monitor);
  in.finish();
  return p;
}

double FfpParams::largest_cutoff_hz() const {
  const auto largest = [](const LookupTable& t) { return *std::ranges::max_element(t.y()); };
  return largest(cutoff_hz) * (turbulence_factor.empty() ? 1.0 : largest(turbulence_factor));
}

void FfpParams::check_time_step(const InputFile& in, double time_step_s) const {
  const double nyquist_hz = 0.5 / time_step_s;
  const auto require_below_nyquist = [&](const char* key, double frequency_hz) {
    if (frequency_hz < nyquist_hz) return;
    in.fail(key, "found " + shortest(frequency_hz) + " Hz, expected less than " +
                     shortest(nyquist_hz) + " Hz, half the rate at which the host calls");
  };
  require_below_nyquist("CutOffFrequency", largest_cutoff_hz());
  require_below_nyquist("DelayFrequency", delay_frequency_hz);
  if (fade_time_s < time_step_s) {
    in.fail("FadeTime", "found " + shortest(fade_time_s) + " s, expected at least one step of " +
                            shortest(time_step_s) + " s: it would be a jump");
  }
}

}  // namespace lac
