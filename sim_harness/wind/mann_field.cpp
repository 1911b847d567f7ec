// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/mann_field.hpp"

#include <cmath>
#include <limits>

#include "sim_harness/wind/complex_normal.hpp"
#include "sim_harness/wind/mann_row.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

using Complex = std::complex<float>;

constexpr auto kWhere = "Mann field";

/// Amplitudes of the noise at harmonic m into a grid of either kind.
template <class Grid>
void put_turbulence(const MannSource& source, int m, std::span<const Complex> noise, MannRow& row,
                    Grid& grid) {
  row.colour(noise);
  for (int c = 0; c < 3; ++c) {
    const GridSpec& g = source.grid();
    put_amplitudes(row.transform(c, g.ny, g.nz, source.scale(c, m)), c, m, grid);
  }
}

/// One k1, all planes.
class EvolvingRowWorker {
 public:
  EvolvingRowWorker(const MannSource& source, EvolvingGrids& grids)
      : source_(source),
        grids_(grids),
        row_(source.box()),
        noise_(row_.noise_size()),
        planes_(planes_to_draw(grids)) {}

  void operator()(int job) {
    const int m = job + 1;
    const std::uint64_t seed = source_.params().seed;
    row_.select(source_.k1_radpm(m));
    ComplexNormal first(seed, 0, m);
    MannRow::draw(first, noise_);
    put_turbulence(source_, m, noise_, row_, grids_.rotor);
    for (std::size_t plane = 1; plane < planes_; ++plane) {
      ComplexNormal normal(seed, plane, m);
      row_.evolve(lead_s(plane), normal, noise_);
      ThinnedGrid& grid = grids_.upwind[plane - 1];
      if (grid.columns().count() > 0) put_turbulence(source_, m, noise_, row_, grid);
    }
  }

 private:
  double lead_s(std::size_t plane) const {
    const PlaneLayout& layout = grids_.layout;
    return (layout.distance_m(plane) - layout.distance_m(plane - 1)) /
           source_.params().mean_speed_mps;
  }

  const MannSource& source_;
  EvolvingGrids& grids_;
  MannRow row_;
  std::vector<Complex> noise_;
  std::size_t planes_;
};

}  // namespace

/// One k1 of one plane.
class MannPlanes::RowWorker {
 public:
  RowWorker(MannPlanes& planes, VelocityGrid& grid)
      : planes_(planes),
        grid_(grid),
        row_(planes.source_.box()),
        own_noise_(planes.noise_.empty() ? row_.noise_size() : 0) {}

  void operator()(int job) {
    const int m = job + 1;
    const bool frozen = planes_.noise_.empty();
    const std::span<Complex> noise =
        frozen ? own_noise_
               : std::span(planes_.noise_).subspan(job * row_.noise_size(), row_.noise_size());
    const int plane = frozen ? 0 : planes_.planes_.count();
    ComplexNormal normal(planes_.seed_, plane, m);
    row_.select(planes_.source_.k1_radpm(m));
    if (plane == 0) {
      MannRow::draw(normal, noise);
    } else {
      row_.evolve(planes_.planes_.lead_m() / planes_.source_.params().mean_speed_mps, normal,
                  noise);
    }
    put_turbulence(planes_.source_, m, noise, row_, grid_);
  }

 private:
  MannPlanes& planes_;
  VelocityGrid& grid_;
  MannRow row_;
  std::vector<Complex> own_noise_;  // where it need not be kept
};

MannPlanes::MannPlanes(const MannFieldParams& params) : source_(params), seed_(params.seed) {
  if (!std::isfinite(params.model.evolution_s)) return;
  const MannBoxSpec& box = source_.box().spec();
  noise_.resize(static_cast<std::size_t>(source_.harmonics()) * 3 * box.ny * box.nz);
}

GriddedWind MannPlanes::next(double distance_m) {
  planes_.begin(kWhere, distance_m);
  GriddedWind plane =
      draw_plane(source_, [&](VelocityGrid& grid) { return RowWorker(*this, grid); });
  planes_.end();
  return plane;
}

void MannPlanes::restart(std::uint64_t seed) {
  seed_ = seed;
  planes_ = {};
}

GriddedWind make_mann_field(const MannFieldParams& params) {
  MannFieldParams frozen = params;
  frozen.model.evolution_s = std::numeric_limits<double>::infinity();
  return MannPlanes(frozen).next(0.0);
}

EvolvingGrids draw_evolving_mann(const MannFieldParams& params, const PlaneLayout& layout,
                                 const WindDemand* demand) {
  require(std::isfinite(params.model.evolution_s), kWhere, "evolution_s", params.model.evolution_s,
          "a finite time for planes that evolve");
  const MannSource source(params);
  return draw_planes(source, layout, demand,
                     [&](EvolvingGrids& grids) { return EvolvingRowWorker(source, grids); });
}

}  // namespace lac::sim
