// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/bladed_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <vector>

#include "core/error.hpp"
#include "sim_harness/wind/binary_reader.hpp"
#include "sim_harness/wind/binary_writer.hpp"
#include "sim_harness/wind/bladed_summary.hpp"

namespace lac::sim {
namespace {

constexpr std::int16_t kId = -99;
constexpr std::int16_t kImprovedVonKarman = 4;  // the one header with turbulence intensities
constexpr std::int32_t kMostPoints = 10000;     // per direction; beyond it this is no header
constexpr double kLeastSigma_mps = 0.01;
constexpr double kHeightRounding_m = 1e-3;  // three numbers of the two files make the lowest height
constexpr double kMostSigmas = 32.7;        // what 1000 steps per sigma leave of an int16

struct Header {
  float centre_m = 0, dz_m = 0, dy_m = 0, dx_m = 0, mean_speed_mps = 0;
  float intensity_percent[3] = {};
  std::int32_t half_nt = 0, nz = 0, ny = 0;
};

Header read_header(BinaryReader& in) {
  Header h;
  in.number("id", kId, kId);
  in.number("kind of turbulence", kImprovedVonKarman, kImprovedVonKarman);
  in.number("number of components", std::int32_t{3}, std::int32_t{3});
  in.skip(2 * sizeof(float), "latitude and roughness length");
  h.centre_m = in.number("height of the centre [m]", 0.0F, 1e4F);
  for (float& ti : h.intensity_percent) ti = in.number("TI [%]", -1e6F, 1e6F);
  h.dz_m = in.number("dz [m]", 1e-3F, 1e4F);
  h.dy_m = in.number("dy [m]", 1e-3F, 1e4F);
  h.dx_m = in.number("dx [m]", 1e-6F, 1e5F);
  h.half_nt = in.number("half the number of time steps", 1, 50'000'000);
  h.mean_speed_mps = in.number("mean speed [m/s]", 1e-3F, 1e3F);
  in.skip(3 * sizeof(float) + 2 * sizeof(std::int32_t), "length scales and seed");
  h.nz = in.number("nz", 2, kMostPoints);
  h.ny = in.number("ny", 2, kMostPoints);
  in.skip(6 * sizeof(std::int32_t), "unused numbers");
  return h;
}

void require_pair(const std::filesystem::path& file, const Header& h, const BladedSummary& s) {
  if (std::abs(h.mean_speed_mps - s.mean_speed_mps) <= 0.1) return;
  std::ostringstream text;
  text << file.string() << ": mean speed: found " << h.mean_speed_mps << " m/s, expected "
       << s.mean_speed_mps << " m/s as in the .sum file beside it: they do not belong together";
  throw Error(text.str());
}

GridSpec spec_of(const Header& h, const BladedSummary& s, int nt) {
  GridSpec spec;
  spec.ny = h.ny;
  spec.nz = h.nz;
  spec.nt = nt;
  spec.dy_m = h.dy_m;
  spec.dz_m = h.dz_m;
  spec.dt_s = static_cast<double>(h.dx_m) / h.mean_speed_mps;
  const double bottom_m = s.hub_height_m - s.height_offset_m - 0.5 * (h.nz - 1) * h.dz_m;
  spec.z_bottom_m = std::abs(bottom_m) < kHeightRounding_m ? 0.0 : bottom_m;
  spec.hub_height_m = s.hub_height_m;
  spec.mean_speed_mps = h.mean_speed_mps;
  spec.periodic = s.periodic;
  return spec;
}

/// m/s per step of the integer, with the sign of v.
std::array<double, 3> scale_of(const Header& h, const BladedSummary& s) {
  std::array<double, 3> scale{};
  for (int c = 0; c < 3; ++c) {
    const double intensity =
        h.intensity_percent[c] > 0.0F ? 0.01 * h.intensity_percent[c] : s.intensity[c];
    scale[c] = 0.001 * h.mean_speed_mps * intensity;
  }
  if (s.left_handed) scale[1] = -scale[1];
  return scale;
}

/// Mean over the grid of the standard deviation in time, and no less than the values need.
double sigma_of(const VelocityGrid& grid, int component, double offset_mps) {
  const GridSpec& g = grid.spec();
  const std::size_t points = g.plane_points();
  std::vector<double> sum(points), squares(points);
  double greatest = 0.0;
  for (int it = 0; it < g.nt; ++it) {
    const std::span<const float> plane = grid.plane(it);
    for (std::size_t p = 0; p < points; ++p) {
      const double value = plane[3 * p + component] - offset_mps;
      sum[p] += value;
      squares[p] += value * value;
      greatest = std::max(greatest, std::abs(value));
    }
  }
  double sigma = 0.0;
  for (std::size_t p = 0; p < points; ++p) {
    const double mean = sum[p] / g.nt;
    sigma += std::sqrt(std::max(squares[p] / g.nt - mean * mean, 0.0)) / points;
  }
  return std::max({sigma, greatest / kMostSigmas, kLeastSigma_mps});
}

void write_header(BinaryWriter& out, const GridSpec& g, const BladedSummary& s) {
  out.number(kId);
  out.number(kImprovedVonKarman);
  out.number(std::int32_t{3});
  for (const double x : {0.0, 0.0, g.z_bottom_m + 0.5 * (g.nz - 1) * g.dz_m})
    out.number(static_cast<float>(x));
  for (const double intensity : s.intensity) out.number(static_cast<float>(100.0 * intensity));
  for (const double x : {g.dz_m, g.dy_m, g.dt_s * g.mean_speed_mps})
    out.number(static_cast<float>(x));
  out.number(static_cast<std::int32_t>(g.nt / 2));
  for (const double x : {g.mean_speed_mps, 0.0, 0.0, 0.0}) out.number(static_cast<float>(x));
  for (const int n : {0, 0, g.nz, g.ny, 0, 0, 0, 0, 0, 0}) out.number(static_cast<std::int32_t>(n));
}

std::filesystem::path summary_beside(std::filesystem::path wnd_file) {
  return wnd_file.replace_extension(".sum");
}

}  // namespace

GriddedWind read_bladed(const std::filesystem::path& wnd_file) {
  BinaryReader in(wnd_file, "a Bladed .wnd file with turbulence intensities in its header");
  const Header h = read_header(in);
  const BladedSummary summary = read_bladed_summary(summary_beside(wnd_file));
  require_pair(wnd_file, h, summary);
  std::vector<std::int16_t> step(3 * static_cast<std::size_t>(h.nz) * h.ny);
  const std::uint64_t step_bytes = step.size() * sizeof(std::int16_t);
  const int odd = in.rest() == (2ULL * h.half_nt + 1) * step_bytes ? 1 : 0;
  const int nt = 2 * h.half_nt + odd;
  in.expect_rest("velocities", nt * step_bytes);

  VelocityGrid grid(spec_of(h, summary, nt));
  const std::array<double, 3> scale = scale_of(h, summary);
  const double offset[3] = {h.mean_speed_mps, 0.0, 0.0};
  for (int it = 0; it < nt; ++it) {
    in.bytes(step.data(), step_bytes, "velocities");
    for (int iz = 0; iz < h.nz; ++iz) {
      for (int iy = 0; iy < h.ny; ++iy) {
        const int column = summary.clockwise ? h.ny - 1 - iy : iy;
        const std::int16_t* from = &step[3 * (static_cast<std::size_t>(iz) * h.ny + column)];
        for (int c = 0; c < 3; ++c)
          grid.at(it, iz, iy, c) = static_cast<float>(offset[c] + scale[c] * from[c]);
      }
    }
  }
  return GriddedWind(std::move(grid));
}

void write_bladed(const std::filesystem::path& wnd_file, const GriddedWind& wind) {
  const VelocityGrid& grid = wind.grid();
  const GridSpec& g = grid.spec();
  BladedSummary summary;
  summary.hub_height_m = g.hub_height_m;
  summary.mean_speed_mps = g.mean_speed_mps;
  summary.height_offset_m = g.hub_height_m - (g.z_bottom_m + 0.5 * (g.nz - 1) * g.dz_m);
  summary.periodic = g.periodic;
  summary.left_handed = true;
  const double offset[3] = {g.mean_speed_mps, 0.0, 0.0};
  double steps_per_mps[3];
  for (int c = 0; c < 3; ++c) {
    const double sigma_mps = sigma_of(grid, c, offset[c]);
    summary.intensity[c] = sigma_mps / g.mean_speed_mps;
    steps_per_mps[c] = (c == 1 ? -1000.0 : 1000.0) / sigma_mps;
  }

  BinaryWriter out(wnd_file);
  write_header(out, g, summary);
  std::vector<std::int16_t> step(grid.plane(0).size());
  for (int it = 0; it < g.nt; ++it) {
    const std::span<const float> plane = grid.plane(it);
    for (std::size_t i = 0; i < step.size(); ++i) {
      const std::size_t c = i % 3;
      step[i] = static_cast<std::int16_t>(std::lround((plane[i] - offset[c]) * steps_per_mps[c]));
    }
    out.bytes(step.data(), step.size() * sizeof(std::int16_t));
  }
  write_bladed_summary(summary_beside(wnd_file), summary);
  out.commit();
}

}  // namespace lac::sim
