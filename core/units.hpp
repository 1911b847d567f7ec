// SPDX-License-Identifier: Apache-2.0
// Units of the outside world (input files, reports) against SI inside; nothing else.
#pragma once

#include <numbers>

namespace lac {

inline constexpr double kPi = std::numbers::pi;

constexpr double rad_from_deg(double deg) {
  return deg * (kPi / 180.0);
}
constexpr double deg_from_rad(double rad) {
  return rad * (180.0 / kPi);
}
constexpr double radps_from_rpm(double rpm) {
  return rpm * (kPi / 30.0);
}
constexpr double rpm_from_radps(double radps) {
  return radps * (30.0 / kPi);
}
constexpr double radps_from_hz(double hz) {
  return hz * (2.0 * kPi);
}

}  // namespace lac
