// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/kaimal_field.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "sim_harness/wind/kaimal_row.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

using Complex = std::complex<float>;

constexpr auto kWhere = "Kaimal field";

/// Amplitudes at harmonic m into a grid of either kind.
template <class Grid>
void put_turbulence(std::span<const Complex> amplitudes, int m, Grid& grid) {
  const std::size_t points = amplitudes.size() / 3;
  for (int c = 0; c < 3; ++c) put_amplitudes(amplitudes.subspan(c * points, points), c, m, grid);
}

/// One frequency, all planes.
class EvolvingRowWorker {
 public:
  EvolvingRowWorker(const KaimalSource& source, EvolvingGrids& grids)
      : source_(source),
        grids_(grids),
        row_(source),
        amplitudes_(row_.size()),
        planes_(planes_to_draw(grids)) {}

  void operator()(int job) {
    const int m = job + 1;
    const std::uint64_t seed = source_.params().seed;
    row_.select(m);
    row_.draw(seed, amplitudes_);
    put_turbulence(amplitudes_, m, grids_.rotor);
    const PlaneLayout& layout = grids_.layout;
    for (std::size_t plane = 1; plane < planes_; ++plane) {
      row_.evolve(layout.distance_m(plane) - layout.distance_m(plane - 1), seed, plane,
                  amplitudes_);
      put_turbulence(amplitudes_, m, grids_.upwind[plane - 1]);
    }
  }

 private:
  const KaimalSource& source_;
  EvolvingGrids& grids_;
  KaimalRow row_;
  std::vector<Complex> amplitudes_;
  std::size_t planes_;
};

}  // namespace

/// One frequency of one plane.
class KaimalPlanes::RowWorker {
 public:
  RowWorker(KaimalPlanes& planes, VelocityGrid& grid)
      : planes_(planes),
        grid_(grid),
        row_(planes.source_),
        own_(planes.amplitudes_.empty() ? row_.size() : 0) {}

  void operator()(int job) {
    const bool frozen = planes_.amplitudes_.empty();
    const std::span<Complex> amplitudes =
        frozen ? own_ : std::span(planes_.amplitudes_).subspan(job * row_.size(), row_.size());
    row_.select(job + 1);
    planes_.coherence_error_[job] = row_.coherence_error();
    if (frozen || planes_.planes_.at_rotor()) {
      row_.draw(planes_.seed_, amplitudes);
    } else {
      row_.evolve(planes_.planes_.lead_m(), planes_.seed_, planes_.planes_.count(), amplitudes);
    }
    put_turbulence(amplitudes, job + 1, grid_);
  }

 private:
  KaimalPlanes& planes_;
  VelocityGrid& grid_;
  KaimalRow row_;
  std::vector<Complex> own_;  // where they need not be kept
};

KaimalPlanes::KaimalPlanes(const KaimalFieldParams& params)
    : source_(params), seed_(params.seed), coherence_error_(source_.harmonics()) {
  if (params.evolution.decay > 0.0)
    amplitudes_.resize(coherence_error_.size() * 3 * source_.grid().plane_points());
}

GriddedWind KaimalPlanes::next(double distance_m) {
  planes_.begin(kWhere, distance_m);
  GriddedWind plane =
      draw_plane(source_, [&](VelocityGrid& grid) { return RowWorker(*this, grid); });
  planes_.end();
  return plane;
}

void KaimalPlanes::restart(std::uint64_t seed) {
  seed_ = seed;
  planes_ = {};
}

KaimalReport KaimalPlanes::report() const {
  const auto worst = std::ranges::max_element(coherence_error_);
  const auto m = static_cast<int>(worst - coherence_error_.begin()) + 1;
  return {*worst, source_.frequency_hz(m)};
}

GriddedWind make_kaimal_field(const KaimalFieldParams& params) {
  KaimalFieldParams frozen = params;
  frozen.evolution.decay = 0.0;
  return KaimalPlanes(frozen).next(0.0);
}

EvolvingGrids draw_evolving_kaimal(const KaimalFieldParams& params, const PlaneLayout& layout,
                                   const WindDemand* demand) {
  require(params.evolution.decay > 0.0, kWhere, "evolution.decay", params.evolution.decay,
          "a number above 0 for planes that evolve");
  const KaimalSource source(params);
  return draw_planes(source, layout, demand,
                     [&](EvolvingGrids& grids) { return EvolvingRowWorker(source, grids); });
}

}  // namespace lac::sim
