// SPDX-License-Identifier: Apache-2.0
// Case files: keys that generated turbulence of every kind has.
#pragma once

#include "sim_harness/run/wind_case.hpp"

namespace lac::sim {

/// Standard deviation of u [m/s]: of the model, and what a field of its period and step has of it.
struct SigmaU {
  double asked_mps = 0.0;
  double held_mps = 0.0;
};

/// The field with the shape.
std::unique_ptr<WindField> shaped_field(GriddedWind wind, const FlowShape& shape);

/// Keys wind_class, turbulence_category, turbulence_model (normal; extreme) and sigma_u_mps (of the
/// standard) [m/s].
double read_sigma_u(YamlReader& in, double mean_speed_mps);

/// Between the keys of read_grid(): a period of 8 to 1e8 whole steps, a grid above the ground.
void check_grid(const YamlReader& in, double hub_height_m, double height_m, double time_step_s,
                double period_s);

/// Throws lac::Error if wind that is generated on a grid does not cover the rotor of the case. in:
/// the map `wind`.
void check_covers_rotor(const YamlReader& in, const WindCase& wind);

/// Keys shear_exponent, width_m, height_m, points_across, points_up, time_step_s, period_s and
/// threads, with the parameters as defaults; hub height and seed from the case.
template <class FieldParams>
void read_grid(YamlReader& in, const WindSurroundings& around, FieldParams& p) {
  p.hub_height_m = around.hub_height_m;
  p.seed = around.seed;
  p.shear_exponent = in.number("shear_exponent", p.shear_exponent, Range::between(0.0, 1.0));
  p.width_m = in.number("width_m", p.width_m, Range::positive());
  p.height_m = in.number("height_m", p.height_m, Range::positive());
  p.ny = in.integer("points_across", p.ny, Range::between(2, 1000));
  p.nz = in.integer("points_up", p.nz, Range::between(2, 1000));
  p.dt_s = in.number("time_step_s", p.dt_s, Range::positive());
  p.duration_s = in.number("period_s", p.duration_s, Range::positive());
  p.threads = in.integer("threads", p.threads, Range::between(1, 64));
  check_grid(in, p.hub_height_m, p.height_m, p.dt_s, p.duration_s);
}

}  // namespace lac::sim
