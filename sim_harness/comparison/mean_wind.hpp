// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>

namespace lac::sim {

/// Means that stand for the wind of a run, the first that there is.
inline constexpr std::array<const char*, 5> kWindFigures{
    "RtVAvgxh_mean", "WindHubVelH_mean", "WindHubVelX_mean", "Wind1VelX_mean", "WindVelX_mean"};

/// The column `wanted`, or if that is empty the first that there is of mean_speed_mps, speed_mps
/// and kWindFigures. Throws lac::Error "where: ..." if there is none.
std::string wind_column_of(const std::string& where, const std::string& wanted,
                           const std::function<bool(const char*)>& has);

/// The middle of the bin, a whole multiple of its width.
double binned(double wind_mps, double bin_mps);

}  // namespace lac::sim
