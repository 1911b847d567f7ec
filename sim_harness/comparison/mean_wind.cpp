// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/comparison/mean_wind.hpp"

#include <cmath>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr std::array<const char*, 2> kWindParameters{"mean_speed_mps", "speed_mps"};

}  // namespace

std::string wind_column_of(const std::string& where, const std::string& wanted,
                           const std::function<bool(const char*)>& has) {
  if (!wanted.empty()) return wanted;
  for (const char* name : kWindParameters)
    if (has(name)) return name;
  for (const char* name : kWindFigures)
    if (has(name)) return name;
  throw Error(where +
              ": has no mean wind speed, expected mean_speed_mps or RtVAvgxh_mean; --wind names "
              "another column");
}

double binned(double wind_mps, double bin_mps) {
  return bin_mps * std::round(wind_mps / bin_mps);
}

}  // namespace lac::sim
