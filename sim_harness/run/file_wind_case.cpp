// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/file_wind_case.hpp"

#include <cmath>
#include <ostream>

#include "sim_harness/wind/uniform_file.hpp"

namespace lac::sim {
namespace {

std::vector<double> three_numbers(YamlReader& in, const char* key, Range range) {
  std::vector<double> values = in.numbers(key, range);
  if (values.size() != 3) in.fail(key, "expected three numbers, along x, y and z");
  return values;
}

}  // namespace

FieldFile read_bts_kind(YamlReader& in) {
  return {FieldFormat::kBts, in.existing_file("file")};
}

FieldFile read_bladed_kind(YamlReader& in) {
  return {FieldFormat::kBladed, in.existing_file("file")};
}

FieldFile read_box_kind(YamlReader& in, const WindSurroundings& around) {
  FieldFile box{FieldFormat::kBox, in.path("file")};
  const std::vector<double> points = three_numbers(in, "points", Range::between(2.0, 1e8));
  for (const double n : points) {
    if (n != std::floor(n)) in.fail("points", "expected whole numbers");
  }
  const std::vector<double> spacing_m = three_numbers(in, "spacing_m", Range::positive());
  GridSpec& g = box.box_spec;
  g.nt = static_cast<int>(points[0]);
  g.ny = static_cast<int>(points[1]);
  g.nz = static_cast<int>(points[2]);
  g.dy_m = spacing_m[1];
  g.dz_m = spacing_m[2];
  g.mean_speed_mps = in.number("mean_speed_mps", Range::positive());
  g.dt_s = spacing_m[0] / g.mean_speed_mps;
  g.hub_height_m = around.hub_height_m;
  g.z_bottom_m = in.number("centre_height_m", around.hub_height_m, Range::positive()) -
                 0.5 * (g.nz - 1) * g.dz_m;
  g.periodic = true;
  box.box_order.first_plane_first =
      in.choice("first_plane", 0, {"arrives_first", "arrives_last"}) == 0;
  box.box_order.rows_from_left = in.choice("rows", 0, {"from_left", "from_right"}) == 0;
  return box;
}

UniformWindParams read_uniform_file_kind(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p;
  p.hub_height_m = around.hub_height_m;
  p.reference_length_m = 2.0 * around.rotor_radius_m;
  p.history = read_uniform_file(in.existing_file("file"));
  if (in.has("advection_speed_mps")) {
    p.advection_speed_mps = in.number("advection_speed_mps", Range::positive());
  }
  return p;
}

void describe(const FieldFile& file, std::ostream& out) {
  out << "file " << file.file.filename().string();
}

}  // namespace lac::sim
