// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/wind_theory.hpp"

#include "core/error.hpp"
#include "sim_harness/wind_check/mann_theory.hpp"

namespace lac::sim {
namespace {

/// Of a wind that could be made: its source, scaled as the case says.
struct TheoryOfSource {
  const FlowShape& shape;
  const std::string& name;

  std::unique_ptr<TurbulenceTheory> operator()(const KaimalWind& wind) const {
    const KaimalFieldParams& p = wind.field;
    KaimalModel model = p.model;
    model.u.sigma_mps *= shape.fluctuation_scale[0];
    model.v.sigma_mps *= shape.fluctuation_scale[1];
    model.w.sigma_mps *= shape.fluctuation_scale[2];
    return std::make_unique<KaimalTheory>(model, p.mean_speed_mps, p.lateral_coherence);
  }
  std::unique_ptr<TurbulenceTheory> operator()(const MannWind& wind) const {
    const auto& scale = shape.fluctuation_scale;
    if (scale[0] != scale[1] || scale[0] != scale[2])
      throw Error(name + ": expected one fluctuation_scale for u, v and w of a Mann field");
    MannParams model = wind.field.model;
    model.alpha_epsilon *= scale[0] * scale[0];
    return std::make_unique<MannTheory>(model, wind.field.mean_speed_mps);
  }
  template <class Other>
  std::unique_ptr<TurbulenceTheory> operator()(const Other&) const {
    throw Error(name +
                ": expected a wind section of kind kaimal or mann: there is no theory of others");
  }
};

std::unique_ptr<TurbulenceTheory> theory_of_case(const WindCase& wind, const std::string& name) {
  if (wind.direction.turns() || wind.shape.veer_radpm != 0.0) {
    throw Error(name +
                ": expected a wind section without yaw_deg, upflow_deg and veer_deg_per_m: "
                "theory knows components along and across the mean wind");
  }
  return std::visit(TheoryOfSource{wind.shape, name}, wind.source);
}

void require_number(const WindCheckOptions& o, double value, const char* option) {
  if (!(value > 0.0)) throw Error("--theory " + o.theory + ": give " + option);
}

/// Of the numbers on the command line.
std::unique_ptr<TurbulenceTheory> theory_of_numbers(const WindCheckOptions& o,
                                                    const LoadedWind& wind) {
  const double speed_mps = wind.field->mean_speed_mps();
  require_number(o, o.sigma_u_mps, "--sigma-u");
  if (o.theory == "kaimal") {
    const auto lateral =
        o.lateral_as_u ? LateralCoherence::kSameAsU : LateralCoherence::kIndependent;
    return std::make_unique<KaimalTheory>(iec_kaimal(o.sigma_u_mps, wind.hub_height_m), speed_mps,
                                          lateral);
  }
  require_number(o, o.length_m, "--length");
  require_number(o, o.gamma, "--gamma");
  MannParams params;
  params.length_m = o.length_m;
  params.gamma = o.gamma;
  params.lifetime = o.mann_lifetime ? EddyLifetime::kMann : EddyLifetime::kGuo;
  return std::make_unique<MannTheory>(scaled_to_sigma_u(params, o.sigma_u_mps), speed_mps);
}

}  // namespace

std::unique_ptr<TurbulenceTheory> theory_of(const WindCheckOptions& o, const LoadedWind& wind) {
  if (!o.theory_case.empty()) {
    return theory_of_case(read_wind_case(o.theory_case, o.file.overrides).wind,
                          o.theory_case.string());
  }
  if (!o.theory.empty()) return theory_of_numbers(o, wind);
  if (wind.made_of) return theory_of_case(*wind.made_of, wind.name);
  throw Error(wind.name +
              ": a file does not say what theory it is of; give --theory-case CASE, or "
              "--theory with its numbers");
}

}  // namespace lac::sim
