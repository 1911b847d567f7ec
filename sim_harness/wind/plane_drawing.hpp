// SPDX-License-Identifier: Apache-2.0
// What generators of planes have in common: their order, and the way from harmonics to velocities.
#pragma once

#include <cmath>
#include <string_view>

#include "sim_harness/wind/evolving_wind.hpp"
#include "sim_harness/wind/parallel_jobs.hpp"
#include "sim_harness/wind/parameter_check.hpp"
#include "sim_harness/wind/time_transform.hpp"

namespace lac::sim {

/// How far a generator is that hands out planes one by one: the first at the rotor, then rising.
class PlaneSequence {
 public:
  /// Planes handed out, which is the number of the one in work.
  int count() const { return count_; }
  bool at_rotor() const { return count_ == 0; }
  /// From the last plane to the one in work [m]; 0 at the rotor.
  double lead_m() const { return in_work_m_ - last_m_; }

  /// Takes the next plane into work. Throws lac::Error on a distance out of order; where: who asks.
  void begin(std::string_view where, double distance_m) {
    require(at_rotor() ? distance_m == 0.0 : std::isfinite(distance_m) && distance_m > last_m_,
            where, "distance of a plane [m]", distance_m,
            at_rotor() ? "0 for the first" : "more than that of the plane before it");
    in_work_m_ = distance_m;
  }
  void end() {
    last_m_ = in_work_m_;
    ++count_;
  }

 private:
  int count_ = 0;
  double last_m_ = 0.0;
  double in_work_m_ = 0.0;
};

/// The plane that one job per harmonic fills; make_worker(grid) makes the worker of a thread, as
/// for_each_job() wants it. Source: KaimalSource, MannSource.
template <class Source, class MakeWorker>
GriddedWind draw_plane(const Source& source, const MakeWorker& make_worker) {
  VelocityGrid grid(source.grid());
  const int threads = source.params().threads;
  for_each_job(source.harmonics(), threads, [&] { return make_worker(grid); });
  amplitudes_to_series(grid, source.mean_profile_mps(), threads);
  return GriddedWind(std::move(grid));
}

/// The same for all planes of a layout, thinned to what is demanded (nullptr: whole).
template <class Source, class MakeWorker>
EvolvingGrids draw_planes(const Source& source, const PlaneLayout& layout, const WindDemand* demand,
                          const MakeWorker& make_worker) {
  EvolvingGrids grids = empty_grids(layout, source.grid(), demand);
  const int threads = source.params().threads;
  for_each_job(source.harmonics(), threads, [&] { return make_worker(grids); });
  amplitudes_to_series(grids, source.mean_profile_mps(), threads);
  return grids;
}

}  // namespace lac::sim
