// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_params.hpp"

#include <sstream>
#include <string>

#include "core/swap_layout.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr double kSteepest_deg = 80.0;

std::vector<LidarBeam> read_beams(YamlReader& in) {
  const Range angle = Range::between(-kSteepest_deg, kSteepest_deg);
  const std::vector<double> azimuth_deg = in.numbers("beam_azimuth_deg", angle);
  const std::vector<double> elevation_deg = in.numbers("beam_elevation_deg", angle);
  if (azimuth_deg.size() != elevation_deg.size()) {
    in.fail("beam_elevation_deg", "found " + std::to_string(elevation_deg.size()) +
                                      " values, expected " + std::to_string(azimuth_deg.size()) +
                                      ", one per value of beam_azimuth_deg");
  }
  std::vector<LidarBeam> beams;
  for (std::size_t i = 0; i < azimuth_deg.size(); ++i) {
    beams.push_back({rad_from_deg(azimuth_deg[i]), rad_from_deg(elevation_deg[i])});
  }
  return beams;
}

std::vector<double> read_gates(YamlReader& in) {
  std::vector<double> gates_m = in.numbers("gates_m", Range::positive());
  for (std::size_t i = 1; i < gates_m.size(); ++i) {
    if (gates_m[i] <= gates_m[i - 1]) in.fail("gates_m", "expected distances that rise");
  }
  if (gates_m.size() > native_lidar::kMaxGates) {
    in.fail("gates_m", "found " + std::to_string(gates_m.size()) + " gates, expected at most " +
                           std::to_string(native_lidar::kMaxGates));
  }
  return gates_m;
}

RangeWeighting read_weighting(YamlReader& in) {
  RangeWeighting w;
  w.fwhm_m = in.number("fwhm_m", Range::not_negative());
  w.points = in.integer("weighting_points", w.points, Range::between(5, 101));
  if (w.points % 2 == 0) in.fail("weighting_points", "expected an odd number");
  return w;
}

Vec3 read_offset(YamlReader& in) {
  if (!in.has("offset_m")) return {};
  const std::vector<double> xyz = in.numbers("offset_m");
  if (xyz.size() != 3) in.fail("offset_m", "expected three numbers: x, y, z");
  return {xyz[0], xyz[1], xyz[2]};
}

}  // namespace

LidarParams read_lidar(YamlReader& in) {
  LidarParams p;
  p.beams = read_beams(in);
  p.gates_m = read_gates(in);
  p.gates_along_beam = in.choice("gates_along", {"beam", "axis"}) == 0;
  p.beam_time_s = in.number("beam_time_s", Range::positive());
  p.weighting = read_weighting(in);
  p.offset_m = read_offset(in);
  p.tilt_rad = rad_from_deg(in.number("tilt_deg", 0.0, Range::between(-45.0, 45.0)));
  return p;
}

LidarParams load_lidar(const std::filesystem::path& file) {
  YamlReader in = YamlReader::load(file);
  LidarParams p = read_lidar(in);
  in.finish();
  return p;
}

std::string describe(const LidarParams& lidar) {
  std::ostringstream out;
  out << lidar.beams.size() << " beams, " << lidar.gates_m.size() << " gates from "
      << lidar.gates_m.front() << " to " << lidar.gates_m.back() << " m, scan "
      << lidar.scan_time_s() << " s";
  return out.str();
}

}  // namespace lac::sim
