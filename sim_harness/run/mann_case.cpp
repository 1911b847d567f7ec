// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/mann_case.hpp"

#include <cmath>
#include <ostream>
#include <string>

#include "sim_harness/run/evolution_case.hpp"
#include "sim_harness/wind/iec_wind.hpp"
#include "sim_harness/wind/mann_source.hpp"
#include "sim_harness/wind/stability.hpp"

namespace lac::sim {
namespace {

constexpr double kLongestLife_s = 1e9;  // frozen, and its powers fit into single precision

/// IEC 61400-1: Mann's lifetime, Gamma 3.9, L = 0.8 Lambda_1; evolution of the neutral class.
MannParams iec_mann(double hub_height_m) {
  MannParams p;
  p.lifetime = EddyLifetime::kMann;
  p.gamma = 3.9;
  p.length_m = 0.8 * turbulence_scale_m(hub_height_m);
  p.evolution_s = stability_mann(Stability::kNeutral).evolution_s;
  return p;
}

MannParams read_model(YamlReader& in, double hub_height_m) {
  const int choice = in.choice("stability", 0, {"iec", "unstable", "neutral", "stable"});
  MannParams p =
      choice == 0 ? iec_mann(hub_height_m) : stability_mann(static_cast<Stability>(choice - 1));
  const int lifetime = p.lifetime == EddyLifetime::kMann ? 0 : 1;
  p.lifetime = static_cast<EddyLifetime>(in.choice("eddy_lifetime", lifetime, {"mann", "guo"}));
  p.length_m = in.number("length_scale_m", p.length_m, Range::positive());
  p.gamma = in.number("anisotropy", p.gamma, Range::not_negative());
  return p;
}

void check_box(const YamlReader& in, const char* key, int box, const char* grid_key, int points) {
  if (box == 0 || (box % 2 == 0 && box >= points)) return;
  in.fail(key, "found " + std::to_string(box) + ", expected an even number, at least " + grid_key +
                   " = " + std::to_string(points));
}

/// Distances of the planes; time_scale_s goes to the model.
std::vector<double> read_evolution(YamlReader in, const WindSurroundings& around,
                                   MannParams& model) {
  model.evolution_s = in.number("time_scale_s", model.evolution_s, {0.0, kLongestLife_s, false});
  std::vector<double> planes_m = read_planes(in, around);
  in.finish();
  return planes_m;
}

}  // namespace

MannWind read_mann(YamlReader& in, const WindSurroundings& around) {
  MannWind wind;
  MannFieldParams& p = wind.field;
  p.mean_speed_mps = in.number("mean_speed_mps", Range::positive());
  const double sigma_u_mps = read_sigma_u(in, p.mean_speed_mps);
  p.model = scaled_to_sigma_u(read_model(in, around.hub_height_m), sigma_u_mps);
  read_grid(in, around, p);
  p.box_ny = in.integer("box_points_across", p.box_ny, Range::between(2, 4096));
  p.box_nz = in.integer("box_points_up", p.box_nz, Range::between(2, 4096));
  check_box(in, "box_points_across", p.box_ny, "points_across", p.ny);
  check_box(in, "box_points_up", p.box_nz, "points_up", p.nz);
  p.small_eddies = static_cast<SmallEddies>(in.choice("small_eddies", 0, {"folded", "cut"}));
  p.rescale = in.flag("rescale", p.rescale);
  if (in.has("evolution")) wind.planes_m = read_evolution(in.map("evolution"), around, p.model);
  return wind;
}

std::unique_ptr<WindField> make_mann_wind(const MannWind& wind, const FlowShape& shape,
                                          const WindDemand* demand) {
  if (wind.planes_m.empty()) return shaped_field(make_mann_field(wind.field), shape);
  return shaped(draw_evolving_mann(wind.field, PlaneLayout(wind.planes_m), demand), shape);
}

SigmaU sigma_u(const MannWind& wind) {
  const MannVariance variance = MannSource(wind.field).variance();
  const double asked_mps = std::sqrt(variance.tensor[kUu]);
  return {asked_mps, wind.field.rescale ? asked_mps : std::sqrt(variance.box[kUu])};
}

void describe(const MannWind& wind, std::ostream& out) {
  const MannFieldParams& p = wind.field;
  out << "Mann turbulence, " << p.mean_speed_mps << " m/s, alpha eps^(2/3) "
      << p.model.alpha_epsilon << ", L " << p.model.length_m << " m, Gamma " << p.model.gamma
      << (p.model.lifetime == EddyLifetime::kMann ? "" : " (lifetime of Guo)") << ", " << p.ny
      << " x " << p.nz << " points, seed " << p.seed;
  if (p.shear_exponent != 0.0) out << ", shear exponent " << p.shear_exponent;
  if (wind.planes_m.empty()) return;
  out << ", evolving with " << p.model.evolution_s << " s in " << wind.planes_m.size()
      << " planes up to " << wind.planes_m.back() << " m";
}

}  // namespace lac::sim
