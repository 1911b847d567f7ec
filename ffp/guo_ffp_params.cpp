// SPDX-License-Identifier: Apache-2.0
#include "ffp/guo_ffp_params.hpp"

namespace lac {
namespace {

constexpr double kLongestBuffer_s = 600.0;
// Beyond that it must be in degrees.
const Range kPitch_rad = Range::between(-0.5, 0.5 * kPi);

/// A filter frequency, which counts only where its flag is up.
double read_frequency(InputFile& in, const char* key, bool in_use, double time_step_s) {
  if (!in_use) return in.number(key);
  const double frequency_radps = in.number(key, Range::positive());
  const double nyquist_radps = kPi / time_step_s;
  if (frequency_radps >= nyquist_radps) {
    in.fail(key, "found " + shortest(frequency_radps) + " rad/s, expected less than " +
                     shortest(nyquist_radps) + " rad/s, half the rate at which the host calls");
  }
  return frequency_radps;
}

void read_notch(InputFile& in, double time_step_s, GuoFfpParams& p) {
  p.notch = in.flag("FlagNotch");
  p.notch_radps = read_frequency(in, "f_cutoff_Notch", p.notch, time_step_s);
  p.notch_num = in.number("betaNum_Notch", Range::not_negative());
  p.notch_den = in.number("betaDen_Notch", p.notch ? Range::positive() : Range::not_negative());
  if (p.notch && p.notch_num >= p.notch_den) {
    in.fail("betaNum_Notch", "found " + shortest(p.notch_num) + ", expected less than " +
                                 shortest(p.notch_den) +
                                 " (betaDen_Notch): it would raise what it is to take out");
  }
}

}  // namespace

GuoForm GuoFfpParams::form_of(const GuoInputFile& file) {
  const bool v2 = file.line_of("FlagNotch") > 0 || file.line_of("f_cutoff_LP") > 0 ||
                  file.line_of("f_cutoff_Notch") > 0;
  GuoForm form{v2 ? "FFP_v2" : "FFP_v1", {"FlagLPF"}, {"LegacyTiming"}};
  const std::vector<std::string> v1_filter{"f_cutoff"};
  const std::vector<std::string> v2_filter{"f_cutoff_LP", "FlagNotch", "f_cutoff_Notch",
                                           "betaNum_Notch", "betaDen_Notch"};
  const std::vector<std::string> rest{"T_buffer",           "",           "",
                                      "n_StaticPitchCurve", "StaticWind", "StaticPitch"};
  for (const auto& part : {v2 ? v2_filter : v1_filter, rest}) {
    form.lines.insert(form.lines.end(), part.begin(), part.end());
  }
  return form;
}

GuoFfpParams GuoFfpParams::read(const GuoInputFile& file, double time_step_s) {
  const GuoForm form = form_of(file);
  InputFile in = file.read(form);
  GuoFfpParams p;
  p.version_2 = form.name == "FFP_v2";
  p.legacy_timing = in.flag("LegacyTiming", false);
  p.low_pass = in.flag("FlagLPF");
  p.cutoff_radps =
      read_frequency(in, p.version_2 ? "f_cutoff_LP" : "f_cutoff", p.low_pass, time_step_s);
  if (p.version_2) read_notch(in, time_step_s, p);
  p.buffer_s = in.number("T_buffer", Range::between(0.0, kLongestBuffer_s));
  const int points = in.integer("n_StaticPitchCurve", Range::between(1, 10000));
  static_cast<void>(
      in.numbers("StaticWind", static_cast<std::size_t>(points), "n_StaticPitchCurve"));
  p.static_pitch_rad = read_table(in, "StaticWind", "StaticPitch", 1.0, kPitch_rad);
  return p;
}

}  // namespace lac
