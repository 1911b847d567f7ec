// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_params.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "sim_harness/lidar/beam_table.hpp"

namespace lac::sim {
namespace {

const char* name_of(const RangeWeighting& w) {
  if (w.is_point()) return ", points";
  if (w.kind == ProbeKind::kLorentzian) return ", continuous wave";
  return "";
}

}  // namespace

LidarParams read_lidar(YamlReader& in) {
  LidarParams p;
  p.scan = read_scan_pattern(in);
  const auto& beams = p.scan.beams;
  const bool all_have_gates = std::all_of(
      beams.begin(), beams.end(), [](const LidarBeam& beam) { return !beam.gates_m.empty(); });
  if (all_have_gates && in.has("gates_m")) {
    in.fail("gates_m", "every beam has gates of its own, no beam is left for these");
  }
  if (!all_have_gates) p.gates_m = read_gates(in);
  p.gates_along_beam = in.choice("gates_along", {"beam", "axis"}) == 0;
  p.weighting = read_range_weighting(in);
  p.mounting = read_mounting(in);
  return p;
}

LidarParams load_lidar(const std::filesystem::path& file) {
  YamlReader in = YamlReader::load(file);
  LidarParams p = read_lidar(in);
  in.finish();
  return p;
}

std::string describe(const LidarParams& lidar) {
  std::size_t most = 0;
  double nearest_m = std::numeric_limits<double>::infinity(), farthest_m = 0.0;
  for (const LidarBeam& beam : lidar.scan.beams) {
    const std::vector<double>& gates_m = beam.gates_m.empty() ? lidar.gates_m : beam.gates_m;
    most = std::max(most, gates_m.size());
    nearest_m = std::min(nearest_m, gates_m.front());
    farthest_m = std::max(farthest_m, gates_m.back());
  }
  std::ostringstream out;
  const auto counted = [&](std::size_t n, const char* what) {
    out << n << ' ' << what << (n == 1 ? "" : "s");
  };
  counted(lidar.scan.beams.size(), "beam");
  out << (lidar.scan.simultaneous ? " at once, " : ", ");
  counted(most, "gate");
  if (nearest_m < farthest_m) {
    out << " from " << nearest_m << " to " << farthest_m << " m";
  } else {
    out << " at " << farthest_m << " m";
  }
  out << name_of(lidar.weighting) << ", scan " << lidar.scan.scan_time_s() << " s";
  if (lidar.mounting.place == MountingPlace::kSpinner) out << ", on the spinner";
  if (!lidar.platform.is_still()) out << ", on a moving platform";
  return out.str();
}

}  // namespace lac::sim
