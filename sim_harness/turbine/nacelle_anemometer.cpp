// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/turbine/nacelle_anemometer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "nacelle anemometer";
constexpr double kMostThrust = 0.96;
constexpr std::uint64_t kStream = 0x616e656d6f;  // away from those of wind and lidar

void require_share(const char* name, double value) {
  require(value >= 0.0 && value <= 1.0, kWhere, name, value, "0 to 1");
}

}  // namespace

NacelleAnemometer::NacelleAnemometer(const NacelleAnemometerParams& params, std::uint64_t seed,
                                     double time_step_s)
    : params_(params),
      lag_factor_(-std::expm1(-time_step_s / params.induction_lag_s)),
      kept_(std::exp(-time_step_s / params.time_scale_s)),
      draw_(seed, kStream, 0) {
  require_share("induction_share", params.induction_share);
  require_share("added_intensity", params.added_intensity);
  require_positive(kWhere, "induction_lag_s", params.induction_lag_s);
  require_positive(kWhere, "time_scale_s", params.time_scale_s);
}

double NacelleAnemometer::measure(double hub_wind_mps, double thrust_coefficient) {
  if (!params_.disturbed()) return hub_wind_mps;
  const double thrust = std::clamp(thrust_coefficient, 0.0, kMostThrust);
  const double induction = 0.5 * (1.0 - std::sqrt(1.0 - thrust));
  const double normal = std::numbers::sqrt2 * draw_().real();
  induction_ = started_ ? induction_ + lag_factor_ * (induction - induction_) : induction;
  added_ = started_ ? kept_ * added_ + std::sqrt(1.0 - kept_ * kept_) * normal : normal;
  started_ = true;
  return (1.0 - params_.induction_share * induction_) * (1.0 + params_.added_intensity * added_) *
         hub_wind_mps;
}

}  // namespace lac::sim
