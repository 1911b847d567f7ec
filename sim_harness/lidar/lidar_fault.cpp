// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_fault.hpp"

#include <algorithm>

namespace lac::sim {
namespace {

void set_all_speeds(LidarMeasurement& m, double speed_mps) {
  for (int g = 0; g < m.gate_count; ++g) {
    m.gates[static_cast<std::size_t>(g)].speed_mps = speed_mps;
  }
}

}  // namespace

LidarFault read_lidar_fault(YamlReader& in, int beam_count) {
  LidarFault fault;
  fault.kind = static_cast<LidarFaultKind>(in.choice(
      "kind", {"none", "dead", "nan", "stuck", "frozen", "999", "bias", "missing", "stuck_beam"}));
  fault.start_s = in.number("start_s", fault.start_s, Range::not_negative());
  fault.end_s = in.number("end_s", fault.end_s, Range::not_negative());
  if (fault.end_s <= fault.start_s) in.fail("end_s", "expected a time after start_s");
  if (fault.kind == LidarFaultKind::kBias) fault.factor = in.number("factor", Range::positive());
  if (fault.kind == LidarFaultKind::kMissing) {
    fault.share = in.number("share", Range::between(0.0, 1.0));
  }
  if (fault.kind == LidarFaultKind::kStuckBeam) {
    fault.beam_id = in.integer("beam", Range::between(1, beam_count)) - 1;
  }
  return fault;
}

LidarFaultInjector::LidarFaultInjector(const LidarFault& fault, int beam_count, std::uint64_t seed)
    : fault_(fault),
      random_(seed, LidarStream::kFault),
      last_good_(static_cast<std::size_t>(beam_count)) {}

void LidarFaultInjector::repeat_speeds(LidarMeasurement& m) {
  LidarMeasurement& last_good = last_good_[static_cast<std::size_t>(m.beam_id)];
  if (last_good.gate_count == 0) last_good = m;
  m.gates = last_good.gates;
}

bool LidarFaultInjector::apply(double time_s, LidarMeasurement& m, bool is_new) {
  if (fault_.kind == LidarFaultKind::kNone || !is_new) return is_new;
  LidarMeasurement& last_good = last_good_[static_cast<std::size_t>(m.beam_id)];
  if (time_s < fault_.start_s || time_s >= fault_.end_s) {
    last_good = m;
    last_beam_ = m.beam_id;
    return true;
  }
  switch (fault_.kind) {
    case LidarFaultKind::kNone:
      break;
    case LidarFaultKind::kDead:
      return false;
    case LidarFaultKind::kNotANumber:
      set_all_speeds(m, std::numeric_limits<double>::quiet_NaN());
      break;
    case LidarFaultKind::kStuck:
      repeat_speeds(m);
      break;
    case LidarFaultKind::kFrozen:
      if (last_beam_ < 0) {
        last_good = m;
        last_beam_ = m.beam_id;
      }
      m = last_good_[static_cast<std::size_t>(last_beam_)];
      break;
    case LidarFaultKind::kOutOfRange:
      set_all_speeds(m, 999.0);
      break;
    case LidarFaultKind::kBias:
      for (LidarGate& gate : m.gates) gate.speed_mps *= fault_.factor;
      break;
    case LidarFaultKind::kMissing:
      return !random_.happens(fault_.share);
    case LidarFaultKind::kStuckBeam:
      if (m.beam_id == fault_.beam_id) repeat_speeds(m);
      break;
  }
  return true;
}

}  // namespace lac::sim
