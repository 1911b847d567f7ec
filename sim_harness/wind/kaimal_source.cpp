// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/kaimal_source.hpp"

#include <cmath>
#include <string>

#include "sim_harness/wind/field_grid.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "Kaimal field";

void require_not_negative(const std::string& name, double found) {
  require(std::isfinite(found) && found >= 0.0, kWhere, name, found, "0 or a finite number above");
}

void check_component(const std::string& name, const KaimalComponent& component) {
  require_not_negative("sigma_" + name, component.sigma_mps);
  require_positive(kWhere, "length scale of " + name, component.length_scale_m);
}

const KaimalFieldParams& checked(const KaimalFieldParams& p) {
  check_field_grid(kWhere, p);
  check_component("u", p.model.u);
  check_component("v", p.model.v);
  check_component("w", p.model.w);
  require_positive(kWhere, "coherence_decay", p.model.coherence_decay);
  require_positive(kWhere, "coherence_length_m", p.model.coherence_length_m);
  require_not_negative("evolution.decay", p.evolution.decay);
  require_not_negative("evolution.offset_per_m", p.evolution.offset_per_m);
  return p;
}

}  // namespace

KaimalSource::KaimalSource(const KaimalFieldParams& params)
    : params_(checked(params)),
      grid_(field_grid(params_)),
      df_hz_(1.0 / (grid_.nt * grid_.dt_s)),
      mean_mps_(mean_profile(grid_, params_.shear_exponent)) {}

double KaimalSource::coherence_rate(int m) const {
  return params_.model.coherence_rate(frequency_hz(m), params_.mean_speed_mps);
}

double KaimalSource::root_coherence(double dx_m, int m) const {
  return params_.evolution.root_coherence(dx_m, frequency_hz(m), params_.mean_speed_mps);
}

bool KaimalSource::coherent(int component) const {
  return component == 0 || params_.lateral_coherence == LateralCoherence::kSameAsU;
}

double KaimalSource::scale_mps(int component, int m) const {
  const KaimalModel& model = params_.model;
  const KaimalComponent& spectrum = component == 0 ? model.u : component == 1 ? model.v : model.w;
  const double variance =
      spectrum.variance((m - 0.5) * df_hz_, (m + 0.5) * df_hz_, params_.mean_speed_mps);
  return (2 * m == grid_.nt ? 1.0 : 0.5) * std::sqrt(2.0 * variance);
}

}  // namespace lac::sim
