// SPDX-License-Identifier: Apache-2.0
#include "core/lidar_block.hpp"

#include <algorithm>

namespace lac {
namespace {

constexpr int kBase = kNativeLidarBlock.first;
namespace nat = native_lidar;

void put(SwapView& swap, int record, const Vec3& v) {
  swap.put(record, v.x);
  swap.put(record + 1, v.y);
  swap.put(record + 2, v.z);
}
Vec3 vector_at(const SwapReader& swap, int record) {
  return {swap.at(record), swap.at(record + 1), swap.at(record + 2)};
}

}  // namespace

void write_native_lidar(SwapView swap, const LidarMeasurement& m, bool new_data) {
  swap.put(kBase + nat::kVersion, nat::kLayoutVersion);
  swap.put(kBase + nat::kNewData, new_data ? 1.0 : 0.0);
  if (!new_data) return;
  swap.put(kBase + nat::kMeasurementTime, m.time_s);
  swap.put(kBase + nat::kBeamId, m.beam_id);
  put(swap, kBase + nat::kBeamDirection, m.beam_dir_L);
  swap.put(kBase + nat::kNumberOfGates, m.gate_count);
  put(swap, kBase + nat::kPosition, m.position_I_m);
  put(swap, kBase + nat::kAttitude, {m.roll_rad, m.pitch_rad, m.yaw_rad});
  put(swap, kBase + nat::kVelocity, m.velocity_I_mps);
  for (int g = 0; g < m.gate_count; ++g) {
    const LidarGate& gate = m.gates[static_cast<std::size_t>(g)];
    const int at = kBase + nat::gate_offset(g);
    swap.put(at + nat::kGateRange, gate.range_m);
    swap.put(at + nat::kGateSpeed, gate.speed_mps);
    swap.put(at + nat::kGateValid, gate.valid ? 1.0 : 0.0);
    swap.put(at + nat::kGateCnr, gate.cnr_db);
  }
}

void read_native_lidar(const SwapReader& swap, LidarMeasurement& m) {
  m.time_s = swap.at(kBase + nat::kMeasurementTime);
  m.beam_id = swap.integer(kBase + nat::kBeamId, -1);
  m.beam_dir_L = vector_at(swap, kBase + nat::kBeamDirection);
  m.gate_count = std::clamp(swap.integer(kBase + nat::kNumberOfGates, 0), 0, nat::kMaxGates);
  m.position_I_m = vector_at(swap, kBase + nat::kPosition);
  m.roll_rad = swap.at(kBase + nat::kAttitude);
  m.pitch_rad = swap.at(kBase + nat::kAttitude + 1);
  m.yaw_rad = swap.at(kBase + nat::kAttitude + 2);
  m.velocity_I_mps = vector_at(swap, kBase + nat::kVelocity);
  for (int g = 0; g < m.gate_count; ++g) {
    const int at = kBase + nat::gate_offset(g);
    m.gates[static_cast<std::size_t>(g)] = {
        swap.at(at + nat::kGateRange), swap.at(at + nat::kGateSpeed),
        swap.integer(at + nat::kGateValid, 0) == 1, swap.at(at + nat::kGateCnr)};
  }
}

bool native_lidar_present(const SwapReader& swap) {
  return swap.holds(kNativeLidarBlock) &&
         swap.integer(kBase + nat::kVersion, 0) == nat::kLayoutVersion;
}

bool native_lidar_is_new(const SwapReader& swap) {
  return swap.integer(kBase + nat::kNewData, 0) == 1;
}

GuoBlock find_guo_block(const float* swap) {
  const SwapReader host(swap, kHostBlock.last());
  const int first = host.integer(Rec::LogStart, 0);
  if (first <= kHostBlock.last() || first + guo_lidar::kFixedSize > kExtendedArraySize) return {};
  const SwapReader header(swap, first + guo_lidar::kFirstSpeed);
  const int gates = header.integer(first + guo_lidar::kNumberOfGates, 0);
  if (gates < 1 || gates > guo_lidar::kMaxGates) return {};
  if (first + guo_lidar::kFixedSize + gates - 1 > kExtendedArraySize) return {};
  return {first, gates};
}

void read_guo_lidar(const float* swap, GuoBlock block, LidarMeasurement& m) {
  const SwapReader view(swap, block.first + guo_lidar::kFixedSize + block.gates);
  m.beam_id = view.integer(block.first + guo_lidar::kBeamId, -1);
  m.gate_count = block.gates;
  for (int g = 0; g < block.gates; ++g) {
    LidarGate& gate = m.gates[static_cast<std::size_t>(g)];
    gate.speed_mps = view.at(block.first + guo_lidar::kFirstSpeed + g);
    gate.valid = true;  // the layout carries no flag; LidarReader looks at the values
    gate.cnr_db = 0.0;
  }
  const int after = block.first + guo_lidar::kAfterGates + block.gates;
  m.roll_rad = view.at(after);
  m.pitch_rad = view.at(after + 1);
  m.yaw_rad = view.at(after + 2);
  m.velocity_I_mps = vector_at(view, after + 3);
}

bool guo_lidar_is_new(const float* swap, GuoBlock block) {
  const SwapReader view(swap, block.first + guo_lidar::kFirstSpeed);
  return view.integer(block.first + guo_lidar::kNewData, 0) == 1;
}

OpenFastHeader read_openfast_header(const SwapReader& swap) {
  constexpr int kFirst = kOpenFastLidarBlock.first;
  return {swap.integer(kFirst + openfast_lidar::kSensorType, -1),
          swap.integer(kFirst + openfast_lidar::kNumberOfBeams, -1),
          swap.integer(kFirst + openfast_lidar::kNumberOfGates, -1)};
}

double openfast_speed(const SwapReader& swap, int point) {
  return swap.at(kOpenFastLidarBlock.first + openfast_lidar::kFirstSpeed + point);
}

double openfast_x(const SwapReader& swap, int point, int points) {
  return openfast_speed(swap, points + point);
}

}  // namespace lac
