// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/bts_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sim_harness/wind/binary_reader.hpp"
#include "sim_harness/wind/binary_writer.hpp"

namespace lac::sim {
namespace {

constexpr std::int16_t kIdFinite = 7;
constexpr std::int16_t kIdPeriodic = 8;
constexpr std::int32_t kMaxPoints = 10000;  // per direction; beyond it the header is not a header
constexpr std::int32_t kMaxDescription = 100000;

struct Scaling {
  float scale = 1.0F;
  float offset = 0.0F;
};

struct Header {
  std::int16_t id = 0;
  std::int32_t nz = 0, ny = 0, n_tower = 0, nt = 0;
  float dz_m = 0, dy_m = 0, dt_s = 0, u_hub_mps = 0, z_hub_m = 0, z_bottom_m = 0;
  std::array<Scaling, 3> scaling;
};

Header read_header(BinaryReader& in) {
  Header h;
  h.id = in.number("id", kIdFinite, kIdPeriodic);
  h.nz = in.number("nz", 2, kMaxPoints);
  h.ny = in.number("ny", 2, kMaxPoints);
  h.n_tower = in.number("number of tower points", 0, kMaxPoints);
  h.nt = in.number("number of time steps", 2, 100'000'000);
  h.dz_m = in.number("dz [m]", 1e-3F, 1e4F);
  h.dy_m = in.number("dy [m]", 1e-3F, 1e4F);
  h.dt_s = in.number("dt [s]", 1e-6F, 1e4F);
  h.u_hub_mps = in.number("mean speed [m/s]", 1e-3F, 1e3F);
  h.z_hub_m = in.number("hub height [m]", 1e-3F, 1e4F);
  h.z_bottom_m = in.number("lowest height [m]", 0.0F, 1e4F);
  for (Scaling& s : h.scaling) {
    s.scale = in.number("scale", 1e-30F, 1e30F);
    s.offset = in.number("offset", -1e30F, 1e30F);
  }
  in.skip(in.number("length of the description", 0, kMaxDescription), "description");
  return h;
}

GridSpec spec_of(const Header& h) {
  GridSpec spec;
  spec.ny = h.ny;
  spec.nz = h.nz;
  spec.nt = h.nt;
  spec.dy_m = h.dy_m;
  spec.dz_m = h.dz_m;
  spec.dt_s = h.dt_s;
  spec.z_bottom_m = h.z_bottom_m;
  spec.hub_height_m = h.z_hub_m;
  spec.mean_speed_mps = h.u_hub_mps;
  spec.periodic = h.id == kIdPeriodic;
  return spec;
}

Scaling scaling_of(const VelocityGrid& grid, int component) {
  float low = grid.at(0, 0, 0, component), high = low;
  for (int it = 0; it < grid.spec().nt; ++it) {
    const std::span<const float> plane = grid.plane(it);
    for (std::size_t i = component; i < plane.size(); i += 3) {
      low = std::min(low, plane[i]);
      high = std::max(high, plane[i]);
    }
  }
  const float scale = 65535.0F / std::max(high - low, 1e-3F);
  return {scale, -32768.0F - scale * low};
}

Header header_of(const VelocityGrid& grid) {
  const GridSpec& g = grid.spec();
  Header h;
  h.id = g.periodic ? kIdPeriodic : kIdFinite;
  h.nz = g.nz;
  h.ny = g.ny;
  h.nt = g.nt;
  h.dz_m = static_cast<float>(g.dz_m);
  h.dy_m = static_cast<float>(g.dy_m);
  h.dt_s = static_cast<float>(g.dt_s);
  h.u_hub_mps = static_cast<float>(g.mean_speed_mps);
  h.z_hub_m = static_cast<float>(g.hub_height_m);
  h.z_bottom_m = static_cast<float>(g.z_bottom_m);
  for (int c = 0; c < 3; ++c) h.scaling[c] = scaling_of(grid, c);
  return h;
}

void write_header(BinaryWriter& out, const Header& h, std::string_view description) {
  out.number(h.id);
  for (const std::int32_t n : {h.nz, h.ny, h.n_tower, h.nt}) out.number(n);
  for (const float x : {h.dz_m, h.dy_m, h.dt_s, h.u_hub_mps, h.z_hub_m, h.z_bottom_m})
    out.number(x);
  for (const Scaling& s : h.scaling) {
    out.number(s.scale);
    out.number(s.offset);
  }
  out.number(static_cast<std::int32_t>(description.size()));
  out.bytes(description.data(), description.size());
}

std::int16_t compressed(float value, const Scaling& s) {
  const double steps = std::round(static_cast<double>(value) * s.scale + s.offset);
  return static_cast<std::int16_t>(std::clamp(steps, -32768.0, 32767.0));
}

}  // namespace

GriddedWind read_bts(const std::filesystem::path& file) {
  BinaryReader in(file, "a TurbSim .bts file");
  const Header h = read_header(in);
  const std::size_t row_bytes = sizeof(std::int16_t) * 3;
  const std::size_t tower_bytes = h.n_tower * row_bytes;
  std::vector<std::int16_t> step(3 * static_cast<std::size_t>(h.nz) * h.ny);
  const std::size_t step_bytes = step.size() * sizeof(std::int16_t);
  in.expect_rest("velocities", static_cast<std::uint64_t>(h.nt) * (step_bytes + tower_bytes));

  VelocityGrid grid(spec_of(h));
  for (int it = 0; it < h.nt; ++it) {
    in.bytes(step.data(), step_bytes, "velocities");
    in.skip(tower_bytes, "tower points");
    const std::span<float> plane = grid.plane(it);
    for (std::size_t i = 0; i < step.size(); ++i) {
      const Scaling& s = h.scaling[i % 3];
      plane[i] = (step[i] - s.offset) / s.scale;
    }
  }
  return GriddedWind(std::move(grid));
}

void write_bts(const std::filesystem::path& file, const GriddedWind& wind,
               std::string_view description) {
  BinaryWriter out(file);
  const VelocityGrid& grid = wind.grid();
  const Header h = header_of(grid);
  write_header(out, h, description);
  std::vector<std::int16_t> step(grid.plane(0).size());
  for (int it = 0; it < h.nt; ++it) {
    const std::span<const float> plane = grid.plane(it);
    for (std::size_t i = 0; i < step.size(); ++i) step[i] = compressed(plane[i], h.scaling[i % 3]);
    out.bytes(step.data(), step.size() * sizeof(std::int16_t));
  }
  out.commit();
}

}  // namespace lac::sim
