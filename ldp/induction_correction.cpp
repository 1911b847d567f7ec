// SPDX-License-Identifier: Apache-2.0
#include "ldp/induction_correction.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace lac {
namespace {

constexpr double kLargestThrust = 1.2;  // a = 0.57: beyond it no model of this kind holds
constexpr double kNowhere_m = 1.0e30;

// Gauss and Legendre, five points on 0..1.
constexpr std::array<std::pair<double, double>, 5> kNodes{
    {{0.046910077030668004, 0.11846344252809454},
     {0.23076534494715845, 0.23931433524968324},
     {0.5, 0.28444444444444444},
     {0.76923465505284155, 0.23931433524968324},
     {0.953089922969332, 0.11846344252809454}}};

}  // namespace

InductionCorrectionParams InductionCorrectionParams::read(InputFile& in) {
  InductionCorrectionParams p;
  p.model = static_cast<InductionModel>(
      in.choice("InductionModel", 0, {"none", "one_dimensional", "vortex_cylinder"}));
  if (p.model == InductionModel::kNone) return p;
  p.thrust = read_table(in, "InductionWindSpeed", "InductionThrust", 1.0,
                        Range::between(0.0, kLargestThrust));
  p.window_s = in.number("InductionWindow", p.window_s, Range::between(1.0, 3600.0));
  p.slows_travel = in.flag("InductionDelay", p.slows_travel);
  p.hub_height_m = in.number("HubHeight", Range::positive());
  p.rotor_radius_m = in.number("RotorRadius", Range::positive());
  return p;
}

InductionCorrection::State InductionCorrection::initial_state(std::size_t places) const {
  State s;
  if (active()) s.places.assign(places, {{kNowhere_m, 0.0, 0.0}, 0.0});
  return s;
}

void InductionCorrection::start(double seen_mps, State& state) const noexcept {
  if (!state.free_speed.started()) {
    state.factor = induction_factor(params_.thrust.at(seen_mps));
  }
}

void InductionCorrection::add(double free_mps, double share_s, State& state) const noexcept {
  state.free_speed.add(free_mps, share_s, params_.window_s);
  state.factor = induction_factor(params_.thrust.at(state.free_speed.mean()));
}

double InductionCorrection::unit(const Vec3& n, const Vec3& p) const noexcept {
  if (params_.model == InductionModel::kOneDimensional) {
    return one_dimensional_induction(p.x, params_.rotor_radius_m).axial;
  }
  const double r_m = std::sqrt(p.y * p.y + p.z * p.z);
  const UnitInduction u = vortex_cylinder_induction(p.x, r_m, params_.rotor_radius_m);
  const double outwards = r_m > 0.0 ? (n.y * p.y + n.z * p.z) / (r_m * n.x) : 0.0;
  return u.axial - u.radial * outwards;
}

double InductionCorrection::remaining(std::size_t place, const Vec3& beam_dir_I,
                                      const Vec3& from_hub_I_m, State& state) const noexcept {
  Place& kept = state.places[place];
  const Vec3 moved_m = from_hub_I_m - kept.from_hub_I_m;
  const double limit_m = kMove * params_.rotor_radius_m;
  if (!(dot(moved_m, moved_m) <= limit_m * limit_m)) {
    kept = {from_hub_I_m, unit(beam_dir_I, from_hub_I_m)};
  }
  return 1.0 - state.factor * kept.unit;
}

double InductionCorrection::travel_m(double ahead_m, const State& state) const noexcept {
  if (!params_.slows_travel || !(ahead_m > 0.0)) return ahead_m;
  const double radius_squared = params_.rotor_radius_m * params_.rotor_radius_m;
  double sum = 0.0;
  for (const auto& [node, weight] : kNodes) {
    const double s_m = node * ahead_m;
    const double axial = 1.0 - s_m / std::sqrt(s_m * s_m + radius_squared);
    sum += weight / (1.0 - state.factor * axial);
  }
  return sum * ahead_m;
}

}  // namespace lac
