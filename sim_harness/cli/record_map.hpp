// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sim_harness/cli/chain_observation.hpp"

namespace lac::sim {

/// Who writes and who reads a record, or a lidar block as a whole.
struct RecordUse {
  int first = 0;
  int last = 0;
  std::string name;                  // "-": a record without a name
  std::vector<std::string> writers;  // "host" or "master", then secondaries in the order of calls
  std::vector<std::string> readers;
};

/// Every record that a secondary touches and every named signal, in the order of numbers.
std::vector<RecordUse> record_map(const WrapperParams& chain,
                                  const std::vector<SecondaryAccess>& all);

/// What is wrong with the map: records that two secondaries write and SharedRecords does not name,
/// as a text for the user; empty if there are none. Logged values do not count: each secondary
/// writes its own.
std::string writers_in_conflict(const WrapperParams& chain,
                                const std::vector<SecondaryAccess>& all);

/// Lines on what looks like a mistake but may be meant: records that are read and written by
/// nobody, signals without use, SharedRecords that are not shared, a lidar block not passed on.
std::vector<std::string> doubts(const WrapperParams& chain,
                                const std::vector<SecondaryAccess>& all);

/// "a, b".
std::string joined(const std::vector<std::string>& words);

}  // namespace lac::sim
