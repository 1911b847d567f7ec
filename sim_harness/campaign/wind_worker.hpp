// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "sim_harness/campaign/marked_case.hpp"

namespace lac::sim {

/// Cases that fly in one wind.
struct WindOrder {
  std::vector<MarkedCase> cases;
  std::vector<std::string> fingerprints;  // one per case
  double time_limit_s = 0.0;              // of each flight; 0: none
};

/// A process that makes the wind and flies the cases one after the other, each again in a process
/// of its own that shares the wind in memory: whatever happens to one of them, its folder gets a
/// marker and the others go on. What a case prints goes to log.txt in its folder.
class WindWorker {
 public:
  /// Starts it. Throws lac::Error.
  explicit WindWorker(WindOrder order);
  /// Ends it and its flight at once if it still runs; no marker is left of that flight.
  ~WindWorker();
  WindWorker(const WindWorker&) = delete;
  WindWorker& operator=(const WindWorker&) = delete;

  /// Becomes readable whenever take_reports() has something to tell.
  int descriptor() const { return reports_; }

  /// The cases that have ended since the last call, in their order. At the end of the process also
  /// those it could not fly, which then have a marker that says why.
  std::vector<MarkedCase> take_reports();
  bool ended() const { return process_ == 0; }

 private:
  void mark_rest(const std::string& reason);

  WindOrder order_;
  pid_t process_ = 0;
  int reports_ = -1;  // one byte per case that has ended
  std::size_t reported_ = 0;
};

}  // namespace lac::sim
