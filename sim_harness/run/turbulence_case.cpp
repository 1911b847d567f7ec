// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/turbulence_case.hpp"

#include <cmath>

#include "sim_harness/run/uniform_wind_case.hpp"

namespace lac::sim {
namespace {

constexpr double kFewestSteps = 8.0, kMostSteps = 1e8;  // of a period
constexpr double kRounding = 1e-6;

}  // namespace

std::unique_ptr<WindField> shaped_field(GriddedWind wind, const FlowShape& shape) {
  VelocityGrid grid = std::move(wind).take_grid();
  apply(shape, grid);
  return std::make_unique<GriddedWind>(std::move(grid));
}

void check_grid(const YamlReader& in, double hub_height_m, double height_m, double time_step_s,
                double period_s) {
  const double steps = period_s / time_step_s;
  if (!(steps > kFewestSteps - 0.5 && steps < kMostSteps)) {
    in.fail("period_s", "found " + shortest(period_s) + ", expected " + shortest(kFewestSteps) +
                            " to " + shortest(kMostSteps) +
                            " times time_step_s = " + shortest(time_step_s));
  }
  if (std::abs(steps - std::round(steps)) >= kRounding * steps) {
    in.fail("period_s", "found " + shortest(period_s) +
                            ", expected a multiple of time_step_s = " + shortest(time_step_s));
  }
  if (height_m > 2.0 * hub_height_m) {
    in.fail("height_m", "found " + shortest(height_m) +
                            ", expected at most twice the hub height of " + shortest(hub_height_m) +
                            " m: the grid is centred there and must not reach into the ground");
  }
}

void check_covers_rotor(const YamlReader& in, const WindCase& wind) {
  const auto check = [&](const char* key, double length_m) {
    const double diameter_m = 2.0 * wind.rotor_radius_m;
    if (length_m >= diameter_m * (1.0 - kRounding)) return;
    in.fail(key, "found " + shortest(length_m) + ", expected at least the rotor's diameter of " +
                     shortest(diameter_m) + " m");
  };
  const auto check_both = [&](const auto& field) {
    check("width_m", field.width_m);
    check("height_m", field.height_m);
  };
  if (const auto* kaimal = std::get_if<KaimalWind>(&wind.source)) check_both(kaimal->field);
  if (const auto* mann = std::get_if<MannWind>(&wind.source)) check_both(mann->field);
}

double read_sigma_u(YamlReader& in, double mean_speed_mps) {
  const IecClass iec = read_iec_class(in);
  const bool extreme = in.choice("turbulence_model", 0, {"normal", "extreme"}) == 1;
  const double standard_mps =
      extreme ? etm_sigma_mps(iec, mean_speed_mps) : ntm_sigma_mps(iec.turbulence, mean_speed_mps);
  return in.number("sigma_u_mps", standard_mps, Range::positive());
}

}  // namespace lac::sim
