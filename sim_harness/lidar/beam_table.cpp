// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/beam_table.hpp"

#include <string>

#include "core/error.hpp"
#include "core/swap_layout.hpp"
#include "core/units.hpp"
#include "sim_harness/tables/number_table.hpp"

namespace lac::sim {
namespace {

constexpr std::size_t kTime = 2, kFocus = 3, kColumns = 4;

double checked(const std::filesystem::path& file, int line, double value, const char* name,
               Range range) {
  if (range.contains(value)) return value;
  throw Error(file.string() + ":" + std::to_string(line) + ": " + name + ": found " +
              shortest(value) + ", expected " + range.text());
}

}  // namespace

std::vector<double> read_gates(YamlReader& in) {
  std::vector<double> gates_m = in.numbers("gates_m", Range::positive());
  for (std::size_t i = 1; i < gates_m.size(); ++i) {
    if (gates_m[i] <= gates_m[i - 1]) in.fail("gates_m", "expected distances that rise");
  }
  if (gates_m.size() > native_lidar::kMaxGates) {
    in.fail("gates_m", "found " + std::to_string(gates_m.size()) + " gates, expected at most " +
                           std::to_string(native_lidar::kMaxGates) +
                           ", as the lidar block of the swap array carries");
  }
  return gates_m;
}

std::vector<LidarBeam> read_beam_list(YamlReader& in) {
  std::vector<LidarBeam> beams;
  for (YamlReader& item : in.maps("beams")) {
    LidarBeam beam;
    beam.azimuth_rad = rad_from_deg(item.number("azimuth_deg", beam_angle_deg()));
    beam.elevation_rad = rad_from_deg(item.number("elevation_deg", beam_angle_deg()));
    if (item.has("time_s")) beam.time_s = item.number("time_s", Range::positive());
    if (item.has("gates_m")) beam.gates_m = read_gates(item);
    item.finish();
    beams.push_back(std::move(beam));
  }
  return beams;
}

std::vector<LidarBeam> load_beam_table(const std::filesystem::path& file) {
  std::vector<LidarBeam> beams;
  for (const NumberRow& row :
       load_number_table(file, 2, kColumns, "azimuth_deg elevation_deg [time_s [focus_m]]")) {
    const auto value = [&](std::size_t column, const char* name, Range range) {
      return checked(file, row.line, row.values[column], name, range);
    };
    LidarBeam beam;
    beam.azimuth_rad = rad_from_deg(value(0, "azimuth_deg", beam_angle_deg()));
    beam.elevation_rad = rad_from_deg(value(1, "elevation_deg", beam_angle_deg()));
    if (row.values.size() > kTime) beam.time_s = value(kTime, "time_s", Range::positive());
    if (row.values.size() > kFocus) beam.gates_m = {value(kFocus, "focus_m", Range::positive())};
    beams.push_back(std::move(beam));
  }
  return beams;
}

}  // namespace lac::sim
