// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/plane_layout.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "evolving wind";
constexpr double kSamePlane_m = 1e-3;
constexpr double kOneGate_m = 10.0;  // a larger gap between beams: the gate is two

/// Means of the runs of sorted numbers between which there is no larger gap.
std::vector<double> means_of_runs(std::vector<double> numbers, double gap) {
  std::ranges::sort(numbers);
  std::vector<double> means;
  for (auto first = numbers.begin(); first != numbers.end();) {
    const auto last =
        std::adjacent_find(first, numbers.end(), [&](double a, double b) { return b - a > gap; });
    const auto end = last == numbers.end() ? last : last + 1;
    means.push_back(std::accumulate(first, end, 0.0) / static_cast<double>(end - first));
    first = end;
  }
  return means;
}

}  // namespace

PlaneLayout::PlaneLayout(std::vector<double> upwind_m) : distances_m_(std::move(upwind_m)) {
  require(!distances_m_.empty(), kWhere, "number of planes up-wind", 0, "at least one");
  distances_m_.insert(distances_m_.begin(), 0.0);
  for (std::size_t i = 1; i < distances_m_.size(); ++i) {
    const double last_m = distances_m_[i - 1], distance_m = distances_m_[i];
    require(std::isfinite(distance_m) && distance_m > last_m, kWhere, "distance of a plane [m]",
            distance_m, "more than that of the plane before it, the rotor's at 0");
    borders_m_.push_back(0.5 * (last_m + distance_m));
  }
}

std::vector<double> planes_at_gates(const WindDemand& demand) {
  std::map<int, std::vector<double>> gates;
  for (const GateCentre& centre : demand.gates)
    gates[centre.gate].push_back(-centre.position_I_m.x);
  std::vector<double> distances_m;
  for (const auto& [gate, of_beams_m] : gates)
    std::ranges::copy(means_of_runs(of_beams_m, kOneGate_m), std::back_inserter(distances_m));
  distances_m = means_of_runs(std::move(distances_m), kSamePlane_m);
  require(!distances_m.empty(), kWhere, "number of gates", 0, "at least one");
  require(distances_m.front() > 0.0, kWhere, "mean distance of a gate up-wind [m]",
          distances_m.front(), "above 0");
  return distances_m;
}

}  // namespace lac::sim
