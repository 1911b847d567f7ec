// SPDX-License-Identifier: Apache-2.0
#include "core/lidar_reader.hpp"

#include <cmath>

namespace lac {
namespace {

constexpr double kErrorValueBelow = -90.0;  // simulators send -99, some plus the lidar's motion
constexpr double kErrorValue = 999.0;       // Guo's chain
constexpr double kAcrossLimit = 0.05;       // smallest n_x of a beam that can give a wind speed

constexpr auto kGates = static_cast<std::size_t>(native_lidar::kMaxGates);

/// To the last bit; a gate without a speed repeats itself like any other.
bool repeats(float now, float last) {
  return now == last || (std::isnan(now) && std::isnan(last));
}

void drop_all(LidarMeasurement& m) {
  for (int g = 0; g < m.gate_count; ++g) m.gates[static_cast<std::size_t>(g)].valid = false;
}

void read_cnr_limits(InputFile& in, LidarReaderParams& p) {
  for (const char* key : {"MinimumCnr", "MaximumCnr"}) {
    if (in.has(key) && p.layout != LidarLayout::Native) {
      in.fail(key, "only with LidarLayout native: the others carry no carrier-to-noise ratio");
    }
  }
  if (in.has("MinimumCnr")) p.min_cnr_db = in.number("MinimumCnr", Range::between(-60.0, 60.0));
  if (in.has("MaximumCnr")) p.max_cnr_db = in.number("MaximumCnr", Range::between(-60.0, 60.0));
  if (p.min_cnr_db >= p.max_cnr_db) in.fail("MaximumCnr", "expected more than MinimumCnr");
}

void read_range_limits(InputFile& in, LidarReaderParams& p) {
  if (in.has("MinimumRange")) p.min_range_m = in.number("MinimumRange", Range::not_negative());
  if (in.has("MaximumRange")) p.max_range_m = in.number("MaximumRange", Range::positive());
  if (p.min_range_m >= p.max_range_m) in.fail("MaximumRange", "expected more than MinimumRange");
}

}  // namespace

LidarReaderParams LidarReaderParams::read(InputFile& in) {
  LidarReaderParams p;
  p.layout = static_cast<LidarLayout>(in.choice("LidarLayout", 0, {"native", "guo", "openfast"}));
  const bool openfast = p.layout == LidarLayout::OpenFast;
  p.number_of_beams = openfast ? 1 : in.integer("NumberOfBeams", Range::between(1, 256));
  p.min_speed_mps = in.number("MinimumSpeed", p.min_speed_mps, Range::between(-90.0, 0.0));
  p.max_speed_mps = in.number("MaximumSpeed", p.max_speed_mps, Range::between(1.0, 120.0));
  read_cnr_limits(in, p);
  read_range_limits(in, p);
  p.stuck_scans = in.integer("StuckScans", p.stuck_scans, Range::not_negative());
  if (openfast) p.openfast = OpenFastLidarParams::read(in);
  if (p.layout == LidarLayout::Guo) p.guo = GuoLidarParams::read(in, p.number_of_beams);
  return p;
}

double LidarReaderParams::read_scan_time(InputFile& in, Range range) const {
  const double interval_s = openfast.measurement_interval_s;
  return interval_s > 0.0 ? in.number("ScanTime", interval_s, range) : in.number("ScanTime", range);
}

LidarReader::LidarReader(LidarReaderParams params) : params_(std::move(params)) {
  if (params_.layout == LidarLayout::Guo) source_ = GuoLidar(params_.guo);
  if (params_.layout == LidarLayout::OpenFast) source_ = OpenFastLidar(params_.openfast);
}

void LidarReader::require(const SwapReader& swap, double time_step_s, Notice& notice) const {
  std::visit([&](const auto& source) { source.require(swap, time_step_s, notice); }, source_);
}

LidarReader::State LidarReader::initial_state() const {
  const auto beams = static_cast<std::size_t>(params_.number_of_beams);
  State s;
  std::visit([&s](const auto& source) { s.source = source.initial_state(); }, source_);
  s.last_speed.assign(beams * kGates, 0.0f);
  s.repeats.assign(beams, 0);
  s.wind_at_change_mps.assign(beams, 0.0);
  s.stuck.assign(beams, 0);
  return s;
}

bool LidarReader::read(SwapView swap, double time_s, State& state, LidarMeasurement& m,
                       Notice& notice) const noexcept {
  const auto fetch = [&](const auto& source) {
    using OwnState = typename std::decay_t<decltype(source)>::State;
    auto* own = std::get_if<OwnState>(&state.source);
    return own != nullptr && source.fetch(swap, time_s, *own, m, notice);
  };
  if (!std::visit(fetch, source_)) return false;
  if (m.beam_id < 0 || m.beam_id >= params_.number_of_beams) {
    if (!state.beam_reported) {
      notice.warn("lidar: beam id %d, expected 0 to %d (NumberOfBeams); such beams are not used",
                  m.beam_id, params_.number_of_beams - 1);
    }
    state.beam_reported = true;
    return false;
  }
  judge_samples(m);
  judge_time(time_s, state, m, notice);
  judge_repeats(swap, state, m, notice);
  return true;
}

void LidarReader::judge_samples(LidarMeasurement& m) const noexcept {
  const Vec3 n = m.beam_dir_I();
  const bool geometry_good = std::isfinite(dot(n, n)) && std::isfinite(m.position_I_m.x) &&
                             std::isfinite(dot(m.velocity_I_mps, m.velocity_I_mps)) &&
                             -n.x > kAcrossLimit;
  for (int g = 0; g < m.gate_count; ++g) {
    LidarGate& gate = m.gates[static_cast<std::size_t>(g)];
    const double v = gate.speed_mps;
    gate.valid = gate.valid && geometry_good && std::isfinite(v) && v > kErrorValueBelow &&
                 v != kErrorValue && v >= params_.min_speed_mps && v <= params_.max_speed_mps &&
                 std::isfinite(gate.range_m) && gate.range_m > 0.0 &&
                 params_.in_range(gate.range_m) && gate.cnr_db >= params_.min_cnr_db &&
                 gate.cnr_db <= params_.max_cnr_db;
  }
}

void LidarReader::judge_time(double time_s, State& state, LidarMeasurement& m,
                             Notice& notice) const noexcept {
  const bool future = m.time_s > time_s + kFuture_s;
  if (future && !state.future) {
    notice.warn("lidar: time stamps are %.3g s ahead of the controller's clock: not used",
                m.time_s - time_s);
  } else if (state.future && !future) {
    notice.warn("lidar: time stamps are right again");
  }
  state.future = future;
  if (future) drop_all(m);
}

void LidarReader::judge_repeats(SwapView swap, State& state, LidarMeasurement& m,
                                Notice& notice) const noexcept {
  const auto beam = static_cast<std::size_t>(m.beam_id);
  const double wind_mps = swap.get(Rec::HubWindSpeed);
  bool same = true;
  bool any_valid = false;
  for (int g = 0; g < m.gate_count; ++g) {
    any_valid = any_valid || m.gates[static_cast<std::size_t>(g)].valid;
    float& last = state.last_speed[beam * kGates + static_cast<std::size_t>(g)];
    const auto now = static_cast<float>(m.gates[static_cast<std::size_t>(g)].speed_mps);
    same = same && repeats(now, last);
    last = now;
  }
  state.repeats[beam] = same ? state.repeats[beam] + 1 : 0;
  if (!same) state.wind_at_change_mps[beam] = wind_mps;
  if (!any_valid) return;  // error values repeat themselves and are no use anyway
  const bool wind_moved =
      std::abs(wind_mps - state.wind_at_change_mps[beam]) > params_.stuck_wind_change_mps;
  const bool stuck =
      params_.stuck_scans > 0 && same &&
      (state.stuck[beam] != 0 || (state.repeats[beam] >= params_.stuck_scans && wind_moved));
  if (stuck != (state.stuck[beam] != 0)) {
    if (stuck) {
      notice.warn("lidar: beam %d repeats itself while the wind changes: stuck, not used",
                  m.beam_id);
    } else {
      notice.warn("lidar: beam %d gives fresh values again", m.beam_id);
    }
    state.stuck[beam] = stuck ? 1 : 0;
  }
  if (stuck) drop_all(m);
}

}  // namespace lac
