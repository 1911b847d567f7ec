// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_weaknesses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <sstream>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kFaintestEcho_db = -20.0;  // without a model of the carrier-to-noise ratio
constexpr double kNoEcho_db = -60.0;        // a beam that ends at a blade
constexpr double kTipTolerance = 0.05;      // of the rotor radius

std::span<LidarGate> gates_of(LidarMeasurement& m) noexcept {
  return {m.gates.data(), static_cast<std::size_t>(m.gate_count)};
}

template <class Params>
void read_map(YamlReader& in, const char* key, Params (*read)(YamlReader&), Params& params) {
  if (!in.has(key)) return;
  YamlReader map = in.map(key);
  params = read(map);
  map.finish();
}

void check_blades(const BladeShape& blade, const LidarWeaknessSetting& setting) {
  std::ostringstream text;
  text << "lidar: weaknesses: blade_blockage: ";
  if (setting.turns_with_rotor) {
    text << "no blade passes a lidar on the spinner, expected mounted_on: nacelle";
  } else if (setting.position_N_m.x <= 0.0) {
    text << "the lidar lies in the rotor plane or ahead of it (offset_m: x = "
         << setting.position_N_m.x << " m), expected it behind, x above 0";
  } else if (std::abs(blade.tip_m() - setting.rotor_radius_m) >
             kTipTolerance * setting.rotor_radius_m) {
    text << "blade: its tip is at radius_m = " << blade.tip_m() << ", the rotor's radius is "
         << setting.rotor_radius_m << " m; expected the blade of this rotor, within "
         << 100.0 * kTipTolerance << " %";
  } else {
    return;
  }
  throw Error(text.str());
}

void check(const LidarWeaknessParams& params, const LidarWeaknessSetting& setting) {
  if (params.blade_blockage.enabled) check_blades(params.blade_blockage.blade, setting);
  std::ostringstream text;
  for (const HardTarget& target : params.hard_targets) {
    if (target.beam < setting.beams) continue;
    text << "lidar: weaknesses: hard_targets: beam = " << target.beam + 1
         << ", expected at most the lidar's " << setting.beams;
    throw Error(text.str());
  }
}

}  // namespace

bool LidarWeaknessParams::spoils_measurements() const {
  return carrier_to_noise.enabled || !hard_targets.empty() || speed_noise.sigma_mps > 0.0 ||
         blade_blockage.enabled || outages.enabled() || clock.enabled();
}

LidarWeaknessParams read_lidar_weaknesses(YamlReader& in) {
  LidarWeaknessParams p;
  read_map(in, "induction", read_induction, p.induction);
  read_map(in, "carrier_to_noise", read_carrier_to_noise, p.carrier_to_noise);
  if (in.has("hard_targets")) p.hard_targets = read_hard_targets(in, "hard_targets");
  read_map(in, "speed_noise", read_speed_noise, p.speed_noise);
  if (std::isfinite(p.speed_noise.doubling_cnr_db) && !p.carrier_to_noise.enabled) {
    in.map("speed_noise")
        .fail("doubling_cnr_db", "without the map carrier_to_noise there is no CNR to depend on");
  }
  read_map(in, "blade_blockage", read_blade_blockage, p.blade_blockage);
  read_map(in, "outages", read_outages, p.outages);
  read_map(in, "clock", read_lidar_clock, p.clock);
  return p;
}

LidarWeaknesses::LidarWeaknesses(const LidarWeaknessParams& params,
                                 const LidarWeaknessSetting& setting)
    : active_(params.spoils_measurements()),
      weighting_(setting.weighting),
      position_N_m_(setting.position_N_m),
      R_NL_(setting.R_NL),
      hard_targets_(params.hard_targets),
      carrier_to_noise_(params.carrier_to_noise, setting.seed),
      noise_(params.speed_noise, setting.seed),
      blades_(params.blade_blockage, setting.number_of_blades),
      outages_(params.outages, setting.interval_s, setting.seed),
      clock_(params.clock) {
  check(params, setting);
  std::sort(
      hard_targets_.begin(), hard_targets_.end(), [](const HardTarget& a, const HardTarget& b) {
        return a.distance_m != b.distance_m ? a.distance_m > b.distance_m : a.cnr_db < b.cnr_db;
      });
}

bool LidarWeaknesses::pass(double now_s, const TurbineState& turbine, LidarMeasurement& m,
                           bool is_new) noexcept {
  if (!active_) return is_new;
  if (is_new) spoil(now_s, turbine, m);
  return clock_.pass(m, is_new);
}

void LidarWeaknesses::spoil(double now_s, const TurbineState& turbine,
                            LidarMeasurement& m) noexcept {
  set_air_echo(m);
  mix_in_targets(m);
  if (noise_.enabled()) {
    for (LidarGate& gate : gates_of(m)) gate.speed_mps += noise_.draw_mps(gate.cnr_db);
  }
  judge_echoes(blocked(now_s, turbine, m), m);
  outages_.strike(m);
  for (LidarGate& gate : gates_of(m)) {
    if (!gate.valid) gate.speed_mps = std::numeric_limits<double>::quiet_NaN();
  }
}

bool LidarWeaknesses::blocked(double now_s, const TurbineState& turbine,
                              const LidarMeasurement& m) const noexcept {
  const double azimuth_rad = turbine.azimuth_rad - turbine.rotor_speed_radps * (now_s - m.time_s);
  return blades_.blocked({position_N_m_, R_NL_ * m.beam_dir_L}, azimuth_rad, turbine.pitch_rad);
}

void LidarWeaknesses::set_air_echo(LidarMeasurement& m) noexcept {
  if (!carrier_to_noise_.enabled()) return;
  carrier_to_noise_.move_on(m.time_s);
  for (LidarGate& gate : gates_of(m)) gate.cnr_db = carrier_to_noise_.draw_db(gate.range_m);
}

void LidarWeaknesses::mix_in_targets(LidarMeasurement& m) const noexcept {
  const double own_speed_mps = dot(m.beam_dir_I(), m.velocity_I_mps);
  auto first = hard_targets_.begin();
  for (auto t = first; t != hard_targets_.end(); ++t) {
    if (t->opaque && t->met_by(m)) first = t;
  }
  for (auto t = first; t != hard_targets_.end(); ++t) {
    if (!t->met_by(m)) continue;
    for (LidarGate& gate : gates_of(m)) {
      mix_in(*t, gate_view(weighting_, gate.range_m, t->distance_m), own_speed_mps, gate);
    }
  }
}

void LidarWeaknesses::judge_echoes(bool blocked, LidarMeasurement& m) const noexcept {
  for (LidarGate& gate : gates_of(m)) {
    if (blocked) gate.cnr_db = kNoEcho_db;
    const bool seen = carrier_to_noise_.enabled() ? carrier_to_noise_.detects(gate.cnr_db)
                                                  : gate.cnr_db >= kFaintestEcho_db;
    gate.valid = gate.valid && !blocked && seen;
  }
}

}  // namespace lac::sim
