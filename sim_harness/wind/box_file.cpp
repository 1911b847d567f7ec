// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/box_file.hpp"

#include <cmath>
#include <vector>

#include "sim_harness/wind/binary_reader.hpp"
#include "sim_harness/wind/binary_writer.hpp"

namespace lac::sim {
namespace {

constexpr float kGreatestSpeed_mps = 300.0F;

/// Index of grid row iy at height iz in a plane of a file.
std::size_t place(const GridSpec& g, BoxOrder order, int iz, int iy) {
  const int row = order.rows_from_left ? g.ny - 1 - iy : iy;
  return static_cast<std::size_t>(row) * g.nz + iz;
}

int step_of(const GridSpec& g, BoxOrder order, int ix) {
  return order.first_plane_first ? ix : g.nt - 1 - ix;
}

void check(const BinaryReader& in, const std::vector<float>& plane) {
  for (std::size_t i = 0; i < plane.size(); ++i) {
    if (std::abs(plane[i]) <= kGreatestSpeed_mps) continue;
    in.refuse((plane.size() - 1 - i) * sizeof(float), "velocity [m/s]", plane[i], "-300 to 300");
  }
}

void read_component(const std::filesystem::path& file, BoxOrder order, int component,
                    VelocityGrid& grid) {
  const GridSpec& g = grid.spec();
  BinaryReader in(file, "a turbulence box of this many points");
  std::vector<float> plane(g.plane_points());
  const std::uint64_t plane_bytes = plane.size() * sizeof(float);
  in.expect_rest("velocities", g.nt * plane_bytes);
  const float mean_mps = component == 0 ? static_cast<float>(g.mean_speed_mps) : 0.0F;
  for (int ix = 0; ix < g.nt; ++ix) {
    in.bytes(plane.data(), plane_bytes, "velocities");
    check(in, plane);
    const int it = step_of(g, order, ix);
    for (int iz = 0; iz < g.nz; ++iz) {
      for (int iy = 0; iy < g.ny; ++iy)
        grid.at(it, iz, iy, component) = plane[place(g, order, iz, iy)] + mean_mps;
    }
  }
}

void write_component(BinaryWriter& out, BoxOrder order, int component, const VelocityGrid& grid) {
  const GridSpec& g = grid.spec();
  std::vector<float> plane(g.plane_points());
  const float mean_mps = component == 0 ? static_cast<float>(g.mean_speed_mps) : 0.0F;
  for (int ix = 0; ix < g.nt; ++ix) {
    const int it = step_of(g, order, ix);
    for (int iz = 0; iz < g.nz; ++iz) {
      for (int iy = 0; iy < g.ny; ++iy)
        plane[place(g, order, iz, iy)] = grid.at(it, iz, iy, component) - mean_mps;
    }
    out.bytes(plane.data(), plane.size() * sizeof(float));
  }
}

}  // namespace

BoxFiles box_files(const std::filesystem::path& name) {
  std::string stem = name.stem().string(), ending = name.extension().string();
  std::string* lettered = &stem;
  if (ending == ".u") {
    lettered = &ending;
  } else if (!stem.ends_with('u')) {
    stem += "-u";
  }
  BoxFiles files;
  for (int c = 0; c < 3; ++c) {
    lettered->back() = "uvw"[c];
    files[c] = name.parent_path() / (stem + ending);
  }
  return files;
}

GriddedWind read_box(const BoxFiles& files, const GridSpec& spec, BoxOrder order) {
  VelocityGrid grid(spec);
  for (int c = 0; c < 3; ++c) read_component(files[c], order, c, grid);
  return GriddedWind(std::move(grid));
}

void write_box(const BoxFiles& files, const GriddedWind& wind, BoxOrder order) {
  for (int c = 0; c < 3; ++c) {
    BinaryWriter out(files[c]);
    write_component(out, order, c, wind.grid());
    out.commit();
  }
}

}  // namespace lac::sim
