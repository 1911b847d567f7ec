// SPDX-License-Identifier: Apache-2.0
#include "core/guo_lidar.hpp"

namespace lac {

GuoLidarParams GuoLidarParams::read(InputFile& in, int number_of_beams) {
  GuoLidarParams p;
  const auto beams = static_cast<std::size_t>(number_of_beams);
  const auto azimuth = in.numbers("BeamAzimuth", beams, "NumberOfBeams", Range::between(-90, 90));
  const auto elevation =
      in.numbers("BeamElevation", beams, "NumberOfBeams", Range::between(-90, 90));
  for (std::size_t i = 0; i < beams; ++i) {
    p.beam_dir_L.push_back(beam_direction(rad_from_deg(azimuth[i]), rad_from_deg(elevation[i])));
  }
  p.gate_range_m = in.numbers("GateRanges", Range::positive());
  if (p.gate_range_m.size() > static_cast<std::size_t>(native_lidar::kMaxGates)) {
    in.fail("GateRanges", "more than 50 gates");
  }
  const auto position = in.numbers("LidarPosition", 3, "x, y, z");
  p.position_I_m = {position[0], position[1], position[2]};
  return p;
}

GuoLidar::GuoLidar(GuoLidarParams params) : params_(std::move(params)) {}

bool GuoLidar::fetch(const SwapReader& swap, double time_s, State& state, LidarMeasurement& m,
                     Notice& notice) const noexcept {
  const GuoBlock block = find_guo_block(swap.data());
  if (block.first == 0 || block.gates != static_cast<int>(params_.gate_range_m.size())) {
    if (!state.reported) {
      notice.warn("lidar: no block of Guo's layout with %d gates at record 63 (found %d gates)",
                  static_cast<int>(params_.gate_range_m.size()), block.gates);
    }
    state.reported = true;
    return false;
  }
  if (!guo_lidar_is_new(swap.data(), block)) return false;
  read_guo_lidar(swap.data(), block, m);
  m.time_s = time_s;
  m.position_I_m = params_.position_I_m;
  if (m.beam_id >= 0 && m.beam_id < static_cast<int>(params_.beam_dir_L.size())) {
    m.beam_dir_L = params_.beam_dir_L[static_cast<std::size_t>(m.beam_id)];
  }
  for (int g = 0; g < m.gate_count; ++g) {
    m.gates[static_cast<std::size_t>(g)].range_m =
        params_.gate_range_m[static_cast<std::size_t>(g)];
  }
  return true;
}

}  // namespace lac
