// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/migrate_forms.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "core/units.hpp"
#include "ffp/guo_ffp_params.hpp"
#include "ldp/guo_ldp_params.hpp"
#include "wrapper/guo_wrapper_file.hpp"

namespace lac::sim {
namespace {

// Only the checks against the rate of calls need one; the true one is not known here.
constexpr double kAnyTimeStep_s = 1.0e-3;

/// Lines of an input file of our own form.
class Text {
 public:
  Text(const GuoInputFile& file, const std::string& what, const std::string& form) {
    comment(what + ", from " + file.path().filename().string() + " (" + form +
            " of Guo's chain) by lac migrate.");
    comment("Lines that begin with '! ...' are yours: put a value in its place.");
    comment("value                 ! Key - description [unit]");
  }
  void comment(const std::string& text) { out_ << "! " << text << '\n'; }
  void line(const std::string& value, const std::string& key, const std::string& text) {
    out_ << std::left << std::setw(23) << value << " ! " << std::setw(18) << key << " - " << text
         << '\n';
  }
  void fill_in(const std::string& key, const std::string& text) { line("! ...", key, text); }
  void optional(const std::string& value, const std::string& key, const std::string& text) {
    line("! " + value, key, "default: " + text);
  }
  void whole_line(const std::string& text) { out_ << text << '\n'; }
  std::string text() const { return out_.str(); }

 private:
  std::ostringstream out_;
};

template <class Numbers, class F>
std::string row(const Numbers& numbers, F f) {
  std::ostringstream text;
  for (const auto& x : numbers) text << (text.tellp() > 0 ? " " : "") << shortest(f(x));
  return text.str();
}

double same(double x) {
  return x;
}
/// In degrees, without the last digits that the way through radians adds.
double degrees(double rad) {
  return std::round(deg_from_rad(rad) * 1e9) / 1e9;
}

void write_ranges(const GuoInputFile& file, GuoForm form, Text& text) {
  const std::string key = "Lidar_RangeGates";  // stands in some of their files, unread
  form.extras.push_back(key);
  InputFile in = file.read(form);
  if (in.has(key)) {
    text.line(row(in.numbers(key, Range::positive()), same), "GateRanges",
              "along the beam, one per gate; was Lidar_RangeGates [m]");
  } else {
    text.fill_in("GateRanges", "distances along the beam, one per gate of the block [m]");
  }
}

std::string kept(bool flag) {
  return flag ? "true" : "false";
}

/// Wind speed from which the curve rises.
double kink_mps(const LookupTable& curve) {
  const auto& pitch = curve.y();
  std::size_t i = 0;
  while (i + 1 < pitch.size() && pitch[i + 1] <= pitch[i]) ++i;
  return curve.x()[i];
}

void write_filter(const GuoFfpParams& p, Text& text) {
  text.line("16", "CutOffWindSpeed", "one point: the cut-off holds for all mean wind speeds [m/s]");
  if (p.low_pass) {
    text.line(shortest(p.cutoff_hz()), "CutOffFrequency",
              "was " + shortest(p.cutoff_radps) + " rad/s [Hz]");
  } else {
    text.fill_in("CutOffFrequency", "the low-pass was off; 4 filters next to nothing [Hz]");
  }
  if (p.notch) {
    text.comment("The notch at " + shortest(p.notch_radps) + " rad/s (" + shortest(p.notch_num) +
                 ", " + shortest(p.notch_den) + ") has no counterpart in this form.");
  }
}

}  // namespace

std::string migrated_ldp(const GuoInputFile& file) {
  const GuoForm form = GuoLdpParams::form_of(file);
  const GuoLdpParams p = GuoLdpParams::read(file);
  Text text(file, "Lidar data processing", form.name);
  std::vector<Vec3> beams = p.beam_dir_L;
  if (p.form == GuoLdpParams::Form::Task52) {
    beams.assign(static_cast<std::size_t>(p.samples), p.beam_dir_L.front());
  }
  text.line("guo", "LidarLayout", "lidar records of the host: block at record 63");
  text.line(std::to_string(beams.size()), "NumberOfBeams", "beams of one full scan [-]");
  text.fill_in("ScanTime", "time of " + std::to_string(p.samples) + " measurements [s]");
  if (p.form == GuoLdpParams::Form::V3 || p.form == GuoLdpParams::Form::Task52) {
    text.comment("Only the angle to the centre line is known. As an elevation it gives the same");
    text.comment("wind speed and distance, as long as MotionCompensation is false.");
  }
  text.line(row(beams, [](const Vec3& b) { return degrees(std::atan2(b.y, b.x)); }), "BeamAzimuth",
            "seen from the lidar, positive to the left [deg]");
  text.line(row(beams, [](const Vec3& b) { return degrees(std::asin(b.z)); }), "BeamElevation",
            "[deg]");
  if (p.gate > 1) {
    text.comment("IndexGate was " + std::to_string(p.gate) +
                 ": this form takes all gates that are far enough ahead (RequiredLead).");
  }
  write_ranges(file, form, text);
  text.fill_in("LidarPosition", "x y z; x down-wind of the rotor, z above the ground [m]");
  text.line(std::to_string(p.samples), "MinimumSamples", "fewer in the scan are no estimate [-]");
  text.line(kept(p.motion_compensation), "MotionCompensation", "take attitude and velocity out");
  return text.text();
}

std::string migrated_ffp(const GuoInputFile& file) {
  const GuoFfpParams p = GuoFfpParams::read(file, kAnyTimeStep_s);
  Text text(file, "Collective feedforward pitch", GuoFfpParams::form_of(file).name);
  write_filter(p, text);
  text.comment("T_buffer was " + shortest(p.buffer_s) +
               " s. Here the buffer time follows from the");
  text.comment(
      "lead that LDP reports: lead - filter - actuator - half a scan + BufferTrim. LDP has");
  text.comment("to be of our own form too: theirs knows no distances, and so no lead.");
  text.optional("0.08", "DelayFrequency", "where the delays are made up for [Hz]");
  text.optional("1", "ActuatorFrequency", "pitch actuator of the NREL 5 MW [Hz]");
  text.optional("0.7", "ActuatorDamping", "its damping ratio [-]");
  text.optional("0", "BufferTrim", "added to the buffer time [s]");
  const LookupTable& curve = p.static_pitch_rad;
  text.line(row(curve.x(), same), "StaticWind", "wind speed [m/s]");
  text.line(row(curve.y(), degrees), "StaticPitch", "pitch there, never falling [deg]");
  text.line(shortest(std::max(0.5, kink_mps(curve))), "ThresholdSpeed",
            "where the curve begins to rise, as theirs; some m/s more is calmer [m/s]");
  text.optional("4", "MaximumRate", "a demanded rate beyond this is cut [deg/s]");
  return text.text();
}

std::string migrated_wrapper(const GuoInputFile& file) {
  const std::vector<GuoSubDll> all = read_guo_sub_dlls(file);
  Text text(file, "LAC Chain master", "WRAPPER.IN");
  text.comment(
      "Rows: \"name\" \"library\" \"input file\"; files count from this file's folder, which was");
  text.comment(std::filesystem::absolute(file.path()).parent_path().string());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool ours = all[i].replaced;
    text.whole_line(secondary_row(all[i], static_cast<int>(i) + 1) + " - was " + all[i].written +
                    (ours ? ", which is not there" : ""));
  }
  text.comment("LDP and FFP files of their form are read as they are, or can be migrated too.");
  text.line("guo", "LidarLayout", "lidar records of the host: block at record 63");
  return text.text();
}

}  // namespace lac::sim
