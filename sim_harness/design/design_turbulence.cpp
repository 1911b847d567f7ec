// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/design_turbulence.hpp"

#include <cmath>
#include <limits>
#include <sstream>

#include "sim_harness/wind/stability.hpp"

namespace lac::sim {
namespace {

Stability stability_of(int choice) {
  return choice == 0 ? Stability::kNeutral : static_cast<Stability>(choice - 1);
}

MannParams read_mann_turbulence(YamlReader& in, double hub_height_m, int stability) {
  MannParams p = stability_mann(stability_of(stability));
  if (stability == 0) {  // IEC 61400-1; the evolution is that of the neutral class
    p.lifetime = EddyLifetime::kMann;
    p.gamma = 3.9;
    p.length_m = 0.8 * turbulence_scale_m(hub_height_m);
  }
  const int lifetime = p.lifetime == EddyLifetime::kMann ? 0 : 1;
  p.lifetime = static_cast<EddyLifetime>(in.choice("eddy_lifetime", lifetime, {"mann", "guo"}));
  p.length_m = in.number("length_scale_m", p.length_m, Range::positive());
  p.gamma = in.number("anisotropy", p.gamma, Range::not_negative());
  p.evolution_s = in.number("evolution_time_s", p.evolution_s, Range::positive());
  if (!in.flag("evolution", true)) p.evolution_s = std::numeric_limits<double>::infinity();
  return p;
}

KaimalTurbulence read_kaimal_turbulence(YamlReader& in, double hub_height_m, int stability) {
  KaimalTurbulence t;
  t.model = stability == 0 ? iec_kaimal(kStabilitySigmaU_mps, hub_height_m)
                           : stability_kaimal(stability_of(stability), kStabilitySigmaU_mps);
  t.evolution = stability_evolution(stability_of(stability));
  t.evolution.decay = in.number("evolution_decay", t.evolution.decay, Range::not_negative());
  t.evolution.offset_per_m =
      in.number("evolution_offset_per_m", t.evolution.offset_per_m, Range::not_negative());
  if (!in.flag("evolution", true)) t.evolution = {};
  t.lateral = static_cast<LateralCoherence>(
      in.choice("lateral_coherence", 1, {"independent", "same_as_u"}));
  return t;
}

struct TurbulenceText {
  std::ostream& out;

  void operator()(const MannParams& p) const {
    out << "Mann tensor, L " << p.length_m << " m, Gamma " << p.gamma
        << (p.lifetime == EddyLifetime::kMann ? "" : " (lifetime of Guo)");
    if (std::isfinite(p.evolution_s)) {
      out << ", evolving with " << p.evolution_s << " s";
    } else {
      out << ", frozen";
    }
  }
  void operator()(const KaimalTurbulence& t) const {
    const KaimalModel& m = t.model;
    out << "Kaimal spectra, L_u " << m.u.length_scale_m << " m, coherence decay "
        << m.coherence_decay << ", L_c " << m.coherence_length_m << " m, v and w "
        << (t.lateral == LateralCoherence::kSameAsU ? "as coherent as u" : "independent");
    if (t.evolution.decay == 0.0) {
      out << ", frozen";
    } else {
      out << ", evolving with a_x " << t.evolution.decay << ", b_x " << t.evolution.offset_per_m
          << " 1/m";
    }
  }
};

}  // namespace

DesignTurbulence read_turbulence(YamlReader in, double hub_height_m, TurbulenceCategory& category) {
  DesignTurbulence turbulence;
  const int kind = in.choice("kind", {"mann", "kaimal"});
  const int stability = in.choice("stability", 0, {"iec", "unstable", "neutral", "stable"});
  if (kind == 0) {
    turbulence = read_mann_turbulence(in, hub_height_m, stability);
  } else {
    turbulence = read_kaimal_turbulence(in, hub_height_m, stability);
  }
  category = static_cast<TurbulenceCategory>(in.choice("category", 0, {"A", "B", "C", "A+"}));
  in.finish();
  return turbulence;
}

std::string describe_turbulence(const DesignTurbulence& turbulence) {
  std::ostringstream out;
  std::visit(TurbulenceText{out}, turbulence);
  return out.str();
}

double sigma_u_mps(const DesignTurbulence& turbulence) {
  if (const auto* mann = std::get_if<MannParams>(&turbulence))
    return std::sqrt(MannTensor(*mann).covariance()[kUu]);
  return std::get<KaimalTurbulence>(turbulence).model.u.sigma_mps;
}

}  // namespace lac::sim
