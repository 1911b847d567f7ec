// SPDX-License-Identifier: Apache-2.0
#include "core/lidar_reader.hpp"

#include <cmath>

#include "core/error.hpp"

namespace lac {
namespace {

constexpr double kErrorValueBelow = -90.0;  // simulators send -99, some plus the lidar's motion
constexpr double kErrorValue = 999.0;       // Guo's chain
constexpr double kAcrossLimit = 0.05;       // smallest n_x of a beam that can give a wind speed

constexpr auto kGates = static_cast<std::size_t>(native_lidar::kMaxGates);

}  // namespace

LidarReaderParams LidarReaderParams::read(InputFile& in) {
  LidarReaderParams p;
  p.layout = static_cast<LidarLayout>(in.choice("LidarLayout", 0, {"native", "guo"}));
  p.number_of_beams = in.integer("NumberOfBeams", Range::between(1, 256));
  p.min_speed_mps = in.number("MinimumSpeed", p.min_speed_mps, Range::between(-90.0, 0.0));
  p.max_speed_mps = in.number("MaximumSpeed", p.max_speed_mps, Range::between(1.0, 120.0));
  p.stuck_scans = in.integer("StuckScans", p.stuck_scans, Range::not_negative());
  if (p.layout == LidarLayout::Native) return p;

  const auto beams = static_cast<std::size_t>(p.number_of_beams);
  const auto azimuth = in.numbers("BeamAzimuth", beams, "NumberOfBeams", Range::between(-90, 90));
  const auto elevation =
      in.numbers("BeamElevation", beams, "NumberOfBeams", Range::between(-90, 90));
  for (std::size_t i = 0; i < beams; ++i) {
    p.beam_dir_L.push_back(beam_direction(rad_from_deg(azimuth[i]), rad_from_deg(elevation[i])));
  }
  p.gate_range_m = in.numbers("GateRanges", Range::positive());
  if (p.gate_range_m.size() > kGates) in.fail("GateRanges", "more than 50 gates");
  const auto position = in.numbers("LidarPosition", 3, "x, y, z");
  p.position_I_m = {position[0], position[1], position[2]};
  return p;
}

LidarReader::LidarReader(LidarReaderParams params) : params_(std::move(params)) {}

void LidarReader::require(const SwapReader& swap) const {
  if (params_.layout == LidarLayout::Native && !swap.holds(kNativeLidarBlock)) {
    throw Error("LidarLayout native needs records " + std::to_string(kNativeLidarBlock.first) +
                " to " + std::to_string(kNativeLidarBlock.last()) + ", the host's array has " +
                std::to_string(swap.size()) +
                " known records (an extended array has 1001 in record 66 and its length in 129)");
  }
}

LidarReader::State LidarReader::initial_state() const {
  const auto beams = static_cast<std::size_t>(params_.number_of_beams);
  State s;
  s.last_speed.assign(beams * kGates, 0.0f);
  s.repeats.assign(beams, 0);
  s.wind_at_change_mps.assign(beams, 0.0);
  s.stuck.assign(beams, 0);
  return s;
}

bool LidarReader::read(SwapView swap, double time_s, State& state, LidarMeasurement& m,
                       Notice& notice) const noexcept {
  if (!fetch(swap, time_s, state, m, notice)) return false;
  if (m.beam_id < 0 || m.beam_id >= params_.number_of_beams) {
    if (!state.layout_reported) {
      notice.warn("lidar: beam id %d, expected 0 to %d (NumberOfBeams); such beams are not used",
                  m.beam_id, params_.number_of_beams - 1);
    }
    state.layout_reported = true;
    return false;
  }
  judge_samples(m);
  judge_repeats(swap, state, m, notice);
  return true;
}

bool LidarReader::fetch(SwapView swap, double time_s, State& state, LidarMeasurement& m,
                        Notice& notice) const noexcept {
  if (params_.layout == LidarLayout::Native) {
    if (!native_lidar_present(swap)) {
      if (!state.layout_reported) {
        notice.warn(
            "lidar: record %d is not %d: the host fills no native lidar block, or the master "
            "does not pass it on (its key LidarLayout)",
            kNativeLidarBlock.first, native_lidar::kLayoutVersion);
      }
      state.layout_reported = true;
      return false;
    }
    if (!native_lidar_is_new(swap)) return false;
    read_native_lidar(swap, m);
    if (!std::isfinite(m.time_s) || m.time_s == state.last_time_s) return false;
    state.last_time_s = m.time_s;
    return true;
  }
  const GuoBlock block = find_guo_block(swap.data());
  if (block.first == 0 || block.gates != static_cast<int>(params_.gate_range_m.size())) {
    if (!state.layout_reported) {
      notice.warn("lidar: no block of Guo's layout with %zu gates at record 63 (found %d gates)",
                  params_.gate_range_m.size(), block.gates);
    }
    state.layout_reported = true;
    return false;
  }
  if (!guo_lidar_is_new(swap.data(), block)) return false;
  read_guo_lidar(swap.data(), block, m);
  m.time_s = time_s;
  m.position_I_m = params_.position_I_m;
  if (m.beam_id >= 0 && m.beam_id < params_.number_of_beams) {
    m.beam_dir_L = params_.beam_dir_L[static_cast<std::size_t>(m.beam_id)];
  }
  for (int g = 0; g < m.gate_count; ++g) {
    m.gates[static_cast<std::size_t>(g)].range_m =
        params_.gate_range_m[static_cast<std::size_t>(g)];
  }
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
                 std::isfinite(gate.range_m) && gate.range_m > 0.0;
  }
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
    same = same && now == last;
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
  if (!stuck) return;
  for (int g = 0; g < m.gate_count; ++g) m.gates[static_cast<std::size_t>(g)].valid = false;
}

}  // namespace lac
