// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/lidar_block.hpp"
#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

enum class LidarFaultKind {
  kNone,
  kDead,        // no measurement any more
  kNotANumber,  // speeds are NaN, flag and validity still up
  kStuck,       // every beam repeats its last speeds; time, beam and flag go on
  kFrozen,      // the last message again and again, time included, flag up
  kOutOfRange,  // speeds are 999, flag and validity still up
};

struct LidarFault {
  LidarFaultKind kind = LidarFaultKind::kNone;
  double start_s = 0.0;
  double end_s = std::numeric_limits<double>::infinity();
};

/// Keys kind (none, dead, nan, stuck, frozen, 999), start_s, end_s. Throws lac::Error.
LidarFault read_lidar_fault(YamlReader& in);

/// Stands between a lidar and its reader and spoils what passes while the fault lasts. What came
/// before nothing else, as the first measurement during a fault from the start, counts as good.
class LidarFaultInjector {
 public:
  LidarFaultInjector(const LidarFault& fault, int beam_count);

  /// measurement and is_new as the lidar gave them; returns the new is_new.
  bool apply(double time_s, LidarMeasurement& measurement, bool is_new);

 private:
  LidarFault fault_;
  std::vector<LidarMeasurement> last_good_;  // of each beam
  int last_beam_ = -1;
};

}  // namespace lac::sim
