// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/lidar_block.hpp"
#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/lidar/random_stream.hpp"

namespace lac::sim {

enum class LidarFaultKind {
  kNone,
  kDead,        // no measurement any more
  kNotANumber,  // speeds are NaN, flag and validity still up
  kStuck,       // every beam repeats its last speeds; time, beam and flag go on
  kFrozen,      // the last message again and again, time included, flag up
  kOutOfRange,  // speeds are 999, flag and validity still up
  kBias,        // speeds come multiplied
  kMissing,     // measurements do not arrive, at random
  kStuckBeam,   // one beam repeats its last speeds, the others go on
};

struct LidarFault {
  LidarFaultKind kind = LidarFaultKind::kNone;
  double start_s = 0.0;
  double end_s = std::numeric_limits<double>::infinity();
  double factor = 1.0;  // kBias
  double share = 0.0;   // kMissing: of measurements, lost independently of each other
  int beam_id = 0;      // kStuckBeam
};

/// Keys kind (none, dead, nan, stuck, frozen, 999, bias, missing, stuck_beam), start_s, end_s; with
/// bias factor, with missing share, with stuck_beam beam (from 1). Throws lac::Error.
LidarFault read_lidar_fault(YamlReader& in, int beam_count);

/// Stands between a lidar and its reader and spoils what passes while the fault lasts. What came
/// before nothing else, as the first measurement during a fault from the start, counts as good.
class LidarFaultInjector {
 public:
  /// `seed`: of the case, for what is random.
  LidarFaultInjector(const LidarFault& fault, int beam_count, std::uint64_t seed = 1);

  /// measurement and is_new as the lidar gave them; returns the new is_new.
  bool apply(double time_s, LidarMeasurement& measurement, bool is_new);

 private:
  void repeat_speeds(LidarMeasurement& measurement);

  LidarFault fault_;
  RandomStream random_;
  std::vector<LidarMeasurement> last_good_;  // of each beam
  int last_beam_ = -1;
};

}  // namespace lac::sim
