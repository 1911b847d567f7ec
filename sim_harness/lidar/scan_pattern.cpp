// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/scan_pattern.hpp"

#include <cmath>
#include <numeric>
#include <string>

#include "core/units.hpp"
#include "sim_harness/lidar/beam_table.hpp"

namespace lac::sim {
namespace {

constexpr int kMostPointsPerTurn = 1000;
constexpr int kMostSamples = 1000;

void read_fixed(YamlReader& in, ScanPattern& scan) {
  const Range angle = beam_angle_deg();
  const std::vector<double> azimuth_deg = in.numbers("beam_azimuth_deg", angle);
  const std::vector<double> elevation_deg = in.numbers("beam_elevation_deg", angle);
  if (azimuth_deg.size() != elevation_deg.size()) {
    in.fail("beam_elevation_deg", "found " + std::to_string(elevation_deg.size()) +
                                      " values, expected " + std::to_string(azimuth_deg.size()) +
                                      ", one per value of beam_azimuth_deg");
  }
  for (std::size_t i = 0; i < azimuth_deg.size(); ++i) {
    scan.beams.push_back({rad_from_deg(azimuth_deg[i]), rad_from_deg(elevation_deg[i]), 0.0, {}});
  }
  scan.beam_time_s = in.number("beam_time_s", Range::positive());
}

void read_circle(YamlReader& in, ScanPattern& scan) {
  CircularScan circle;
  circle.half_angle_rad =
      rad_from_deg(in.number("cone_half_angle_deg", {0.0, beam_angle_deg().max, false}));
  circle.points = in.integer("points_per_turn", Range::between(2, kMostPointsPerTurn));
  circle.clockwise = in.choice("direction", 0, {"clockwise", "counter_clockwise"}) == 0;
  circle.start_rad = rad_from_deg(in.number("start_deg", 0.0, Range::between(-360.0, 360.0)));
  scan.beams = beams_on_circle(circle);
  scan.beam_time_s = in.number("turn_time_s", Range::positive()) / circle.points;
}

void read_table(YamlReader& in, ScanPattern& scan) {
  if (in.has("beam_file") == in.has("beams")) {
    in.fail("beams", "expected either a list of beams or beam_file");
  }
  scan.beams =
      in.has("beams") ? read_beam_list(in) : load_beam_table(in.existing_file("beam_file"));
  bool timed = true;
  for (const LidarBeam& beam : scan.beams) timed = timed && beam.time_s > 0.0;
  if (!timed || in.has("beam_time_s")) {
    scan.beam_time_s = in.number("beam_time_s", Range::positive());
  }
}

void check_simultaneous(const YamlReader& in, const ScanPattern& scan) {
  if (!scan.simultaneous) return;
  if (scan.beam_pause_s > 0.0) {
    in.fail("beam_pause_s", "there is no pause between beams that are taken at once");
  }
  for (const LidarBeam& beam : scan.beams) {
    if (beam.time_s > 0.0) {
      in.fail("beams_taken",
              "beams that are taken at once share beam_time_s, found one with a "
              "time of its own");
    }
  }
}

}  // namespace

double ScanPattern::scan_time_s() const {
  if (simultaneous) return beam_time_s + scan_pause_s;
  double beams_s = 0.0;
  for (const LidarBeam& beam : beams) beams_s += time_of_s(beam);
  return beams_s + beam_pause_s * static_cast<double>(beams.size() - 1) + scan_pause_s;
}

std::vector<LidarBeam> beams_on_circle(const CircularScan& scan) {
  std::vector<LidarBeam> beams;
  for (int i = 0; i < scan.points; ++i) {
    const double turned_rad = scan.start_rad + 2.0 * kPi * i / scan.points;
    const double to_the_left = std::sin(turned_rad) * (scan.clockwise ? -1.0 : 1.0);
    const double y = std::sin(scan.half_angle_rad) * to_the_left;
    const double z = std::sin(scan.half_angle_rad) * std::cos(turned_rad);
    beams.push_back({std::atan2(y, std::cos(scan.half_angle_rad)), std::asin(z), 0.0, {}});
  }
  return beams;
}

ScanPattern read_scan_pattern(YamlReader& in) {
  ScanPattern scan;
  switch (in.choice("scan", 0, {"fixed", "circle", "table"})) {
    case 0:
      read_fixed(in, scan);
      break;
    case 1:
      read_circle(in, scan);
      break;
    default:
      read_table(in, scan);
  }
  scan.simultaneous = in.choice("beams_taken", 0, {"in_turn", "at_once"}) == 1;
  scan.beam_pause_s = in.number("beam_pause_s", 0.0, Range::not_negative());
  scan.scan_pause_s = in.number("scan_pause_s", 0.0, Range::not_negative());
  scan.samples_per_beam = in.integer("samples_per_beam", 1, Range::between(1, kMostSamples));
  check_simultaneous(in, scan);
  return scan;
}

}  // namespace lac::sim
