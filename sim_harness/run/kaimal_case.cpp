// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/kaimal_case.hpp"

#include <cmath>
#include <ostream>

#include "sim_harness/run/evolution_case.hpp"
#include "sim_harness/wind/plane_sampler.hpp"
#include "sim_harness/wind/stability.hpp"

namespace lac::sim {
namespace {

/// Exactly so many numbers above zero, if the key is there.
std::vector<double> read_some(YamlReader& in, const char* key, std::size_t count,
                              const char* expected) {
  if (!in.has(key)) return {};
  std::vector<double> numbers = in.numbers(key, Range::positive());
  if (numbers.size() != count) in.fail(key, expected);
  return numbers;
}

/// Keys of the model; the class decides what is not given, evolution too (iec: neutral).
void read_model(YamlReader& in, double hub_height_m, KaimalFieldParams& p) {
  const double sigma_u_mps = read_sigma_u(in, p.mean_speed_mps);
  const int choice = in.choice("stability", 0, {"iec", "unstable", "neutral", "stable"});
  const Stability stability =
      choice == 0 ? Stability::kNeutral : static_cast<Stability>(choice - 1);
  KaimalModel& model = p.model;
  model = choice == 0 ? iec_kaimal(sigma_u_mps, hub_height_m)
                      : stability_kaimal(stability, sigma_u_mps);
  p.evolution = stability_evolution(stability);
  const auto lengths_m =
      read_some(in, "length_scales_m", 3, "expected three numbers, for u, v and w");
  if (!lengths_m.empty()) {
    model.u.length_scale_m = lengths_m[0];
    model.v.length_scale_m = lengths_m[1];
    model.w.length_scale_m = lengths_m[2];
  }
  const auto ratios = read_some(in, "sigma_ratios", 2, "expected two numbers, v and w over u");
  if (!ratios.empty()) {
    model.v.sigma_mps = ratios[0] * sigma_u_mps;
    model.w.sigma_mps = ratios[1] * sigma_u_mps;
  }
  model.coherence_decay = in.number("coherence_decay", model.coherence_decay, Range::positive());
  model.coherence_length_m =
      in.number("coherence_length_m", model.coherence_length_m, Range::positive());
}

/// Distances of the planes; decay and offset go to the evolution.
std::vector<double> read_evolution(YamlReader in, const WindSurroundings& around,
                                   ExponentialEvolution& evolution) {
  evolution.decay = in.number("decay", evolution.decay, Range::positive());
  evolution.offset_per_m = in.number("offset_per_m", evolution.offset_per_m, Range::not_negative());
  std::vector<double> planes_m = read_planes(in, around);
  in.finish();
  return planes_m;
}

}  // namespace

KaimalWind read_kaimal(YamlReader& in, const WindSurroundings& around) {
  KaimalWind wind;
  KaimalFieldParams& p = wind.field;
  p.mean_speed_mps = in.number("mean_speed_mps", Range::positive());
  read_model(in, around.hub_height_m, p);
  read_grid(in, around, p);
  p.lateral_coherence = static_cast<LateralCoherence>(
      in.choice("lateral_coherence", 0, {"independent", "same_as_u"}));
  if (in.has("evolution")) wind.planes_m = read_evolution(in.map("evolution"), around, p.evolution);
  return wind;
}

std::unique_ptr<WindField> make_kaimal_wind(const KaimalWind& wind, const FlowShape& shape,
                                            const WindDemand* demand) {
  if (wind.planes_m.empty()) return shaped_field(make_kaimal_field(wind.field), shape);
  return shaped(draw_evolving_kaimal(wind.field, PlaneLayout(wind.planes_m), demand), shape);
}

SigmaU sigma_u(const KaimalWind& wind) {
  const KaimalFieldParams& p = wind.field;
  const double df_hz = 1.0 / p.duration_s;
  const auto harmonics = static_cast<double>(std::lround(p.duration_s / p.dt_s) / 2);
  const KaimalComponent& u = p.model.u;
  return {u.sigma_mps,
          std::sqrt(u.variance(0.5 * df_hz, (harmonics + 0.5) * df_hz, p.mean_speed_mps))};
}

void describe(const KaimalWind& wind, std::ostream& out) {
  const KaimalFieldParams& p = wind.field;
  const auto& [u, v, w, decay, length_m] = p.model;
  out << "Kaimal turbulence, " << p.mean_speed_mps << " m/s, sigma " << u.sigma_mps << ", "
      << v.sigma_mps << ", " << w.sigma_mps << " m/s, L " << u.length_scale_m << ", "
      << v.length_scale_m << ", " << w.length_scale_m << " m, coherence " << decay << ", "
      << length_m << " m (right to " << kCoherenceTolerance << "), v and w "
      << (p.lateral_coherence == LateralCoherence::kSameAsU ? "coherent as u" : "independent")
      << ", " << p.ny << " x " << p.nz << " points, seed " << p.seed;
  if (p.shear_exponent != 0.0) out << ", shear exponent " << p.shear_exponent;
  if (wind.planes_m.empty()) return;
  out << ", evolving with " << p.evolution.decay << ", " << p.evolution.offset_per_m << " /m in "
      << wind.planes_m.size() << " planes up to " << wind.planes_m.back() << " m";
}

}  // namespace lac::sim
