// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/lidar_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/error.hpp"
#include "core/input_file.hpp"
#include "core/lidar_block.hpp"
#include "core/units.hpp"
#include "sim_harness/lidar/beam_samples.hpp"
#include "sim_harness/lidar/mounting.hpp"

namespace lac::sim {
namespace {

std::vector<LidarBeam> beams_of(const LidarLayout& l) {
  const double a = l.azimuth_rad, e = l.elevation_rad;
  const LidarBeam axis{};
  if (l.beams == 1) return {axis};
  if (l.beams == 2) return {{a, 0.0, 0.0, {}}, {-a, 0.0, 0.0, {}}};
  std::vector<LidarBeam> beams{
      {a, e, 0.0, {}}, {a, -e, 0.0, {}}, {-a, -e, 0.0, {}}, {-a, e, 0.0, {}}};
  if (l.beams == 5) beams.push_back(axis);
  if (l.beams == 4 || l.beams == 5) return beams;
  beams.clear();
  for (int i = 0; i < l.beams; ++i) {
    const double turn_rad = 2.0 * kPi * (i + 0.5) / l.beams;
    beams.push_back({a * std::sin(turn_rad), e * std::cos(turn_rad), 0.0, {}});
  }
  return beams;
}

template <class Value>
std::string list_of(const std::vector<LidarBeam>& beams, const Value& value) {
  std::string text = "[";
  for (const LidarBeam& b : beams) text += (text == "[" ? "" : ", ") + shortest(value(b));
  return text + "]";
}

/// New beams cannot have the times of the old ones, unless these are all the same.
double common_beam_time_s(const ScanPattern& scan) {
  if (scan.beams.empty()) return scan.beam_time_s;
  const double first_s = scan.time_of_s(scan.beams.front());
  for (const LidarBeam& beam : scan.beams) {
    if (scan.time_of_s(beam) == first_s) continue;
    throw Error("found beams that take " + shortest(first_s) + " s and " +
                shortest(scan.time_of_s(beam)) +
                " s, expected one time for all, as a layout replaces them (beam_time_s, and no "
                "time_s of a beam)");
  }
  return first_s;
}

double rounded(double value) {
  return std::round(1e3 * value) / 1e3;
}

std::string probe_keys(const RangeWeighting& w) {
  const std::string points = "\nweighting_points: " + std::to_string(w.points) + "\n";
  switch (w.kind) {
    case ProbeKind::kGaussian:
      return w.is_point() ? "probe: point\n" : "fwhm_m: " + shortest(w.fwhm_m) + points;
    case ProbeKind::kPulse:
      return "probe: pulse\npulse_length_m: " + shortest(w.pulse_length_m) +
             "\ngate_length_m: " + shortest(w.gate_length_m) + points;
    default:
      return "probe: continuous_wave\nrayleigh_length_m: " + shortest(w.rayleigh_length_m) +
             "\nrayleigh_at_m: " + shortest(w.rayleigh_at_m) +
             "\nreach_rayleigh_lengths: " + shortest(w.reach_rayleigh) + points;
  }
}

std::string timing_keys(const ScanPattern& s) {
  std::string text = "beam_time_s: " + shortest(s.beam_time_s) + "\n";
  if (s.simultaneous) text += "beams_taken: at_once\n";
  if (s.beam_pause_s > 0.0) text += "beam_pause_s: " + shortest(s.beam_pause_s) + "\n";
  if (s.scan_pause_s > 0.0) text += "scan_pause_s: " + shortest(s.scan_pause_s) + "\n";
  if (s.samples_per_beam > 1)
    text += "samples_per_beam: " + std::to_string(s.samples_per_beam) + "\n";
  return text;
}

std::string mounting_keys(const MountingParams& m) {
  const auto deg = [](double angle_rad) { return shortest(rounded(deg_from_rad(angle_rad))); };
  return "offset_m: [" + shortest(m.offset_m.x) + ", " + shortest(m.offset_m.y) + ", " +
         shortest(m.offset_m.z) + "]\ntilt_deg: " + deg(m.tilt_rad) +
         "\nroll_deg: " + deg(m.roll_rad) + "\nyaw_deg: " + deg(m.yaw_rad) +
         "\ntower_slope: " + shortest(m.tower_slope) +
         "\ntower_travel_m: " + shortest(m.tower_travel_m) + "\n" +
         (m.place == MountingPlace::kSpinner ? "mounted_on: spinner\n" : "");
}

}  // namespace

LidarParams with_layout(LidarParams lidar, const LidarLayout& l) {
  lidar.scan.beam_time_s = common_beam_time_s(lidar.scan);
  lidar.scan.beams = beams_of(l);
  lidar.gates_m.clear();
  for (int i = 0; i < l.gates; ++i) {
    const double share = l.gates == 1 ? 0.0 : static_cast<double>(i) / (l.gates - 1);
    lidar.gates_m.push_back(std::lerp(l.first_gate_m, l.last_gate_m, share));
  }
  return lidar;
}

double largest_half_angle_rad(const LidarParams& lidar) {
  double largest_rad = 0.0;
  for (const LidarBeam& b : lidar.scan.beams)
    largest_rad =
        std::max(largest_rad, std::acos(std::cos(b.azimuth_rad) * std::cos(b.elevation_rad)));
  return largest_rad;
}

double lowest_gate_m(const LidarParams& lidar, double hub_height_m) {
  const LidarPose pose = Mounting(lidar.mounting, PlatformMotion{}, hub_height_m).rest_pose();
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const BeamSamples& beam : make_beam_samples(lidar)) {
    for (const GateSamples& gate : beam.gates) {
      const Vec3 centre_I_m = pose.position_I_m + gate.range_m * (pose.R_IL * beam.dir_L);
      lowest_m = std::min(lowest_m, centre_I_m.z);
    }
  }
  return lowest_m;
}

std::string lidar_file(const LidarParams& lidar, const std::string& comment) {
  std::string text;
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) text += "# " + line + "\n";
  const auto& beams = lidar.scan.beams;
  text +=
      "beam_azimuth_deg: " +
      list_of(beams, [](const LidarBeam& b) { return rounded(deg_from_rad(b.azimuth_rad)); }) +
      "\nbeam_elevation_deg: " +
      list_of(beams, [](const LidarBeam& b) { return rounded(deg_from_rad(b.elevation_rad)); }) +
      "\n" + timing_keys(lidar.scan) + "gates_m: [";
  for (std::size_t i = 0; i < lidar.gates_m.size(); ++i)
    text += (i == 0 ? "" : ", ") + shortest(rounded(lidar.gates_m[i]));
  return text + "]\ngates_along: " + (lidar.gates_along_beam ? "beam" : "axis") + "\n" +
         probe_keys(lidar.weighting) + mounting_keys(lidar.mounting);
}

}  // namespace lac::sim
