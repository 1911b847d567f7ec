// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/evolving_wind.hpp"

#include <utility>

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "evolving wind";

}  // namespace

EvolvingWind::EvolvingWind(std::vector<WindPlane> planes) : planes_(std::move(planes)) {
  require(!planes_.empty(), kWhere, "number of planes", 0, "at least one");
  require(planes_.front().distance_m == 0.0, kWhere, "distance of the first plane [m]",
          planes_.front().distance_m, "0 (the rotor plane)");
  for (std::size_t i = 1; i < planes_.size(); ++i) {
    const double last_m = planes_[i - 1].distance_m, distance_m = planes_[i].distance_m;
    require(std::isfinite(distance_m) && distance_m > last_m, kWhere, "distance of a plane [m]",
            distance_m, "more than that of the plane before it");
    require(planes_[i].wind.grid().spec() == planes_.front().wind.grid().spec(), kWhere,
            "number of the plane with another grid", static_cast<double>(i),
            "all planes on the grid of the first");
    borders_m_.push_back(0.5 * (last_m + distance_m));
  }
}

}  // namespace lac::sim
