// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "core/state_archive.hpp"

namespace lac {

/// Where a turbulence intensity comes from.
enum class IntensitySource {
  Lidar,        // standard deviations of line-of-sight speeds, corrected by c_TI (S20)
  Uncorrected,  // the same without: mean(std(u)) / U
  Anemometer,   // the one on the nacelle
  Turbine,      // rotor-effective wind speed from turbine data
};
inline constexpr int kIntensitySources = 4;

struct IntensityEstimate {
  double intensity = std::numeric_limits<double>::quiet_NaN();  // [-]
  double mean_speed_mps = std::numeric_limits<double>::quiet_NaN();

  bool valid() const { return std::isfinite(intensity); }
  void visit(StateArchive& a) { a(intensity), a(mean_speed_mps); }
};

}  // namespace lac
