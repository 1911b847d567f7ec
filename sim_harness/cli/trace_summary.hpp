// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/host_probe/host_trace.hpp"

namespace lac::sim {

/// What one record of a trace did.
struct RecordHistory {
  bool seen = false;  // ever different from 0
  float first = 0.0F;
  float smallest = 0.0F;
  float largest = 0.0F;
  int changes = 0;

  void take(float value, bool changed);
};

/// What a host does, read off a trace (tools/host_probe).
class TraceSummary {
 public:
  /// Reads to the end. Throws lac::Error.
  explicit TraceSummary(TraceReader& trace);

  struct Message {
    int fail = 0;
    int count = 0;
    double first_time_s = 0.0;
  };

  int calls = 0;
  bool last_answered = true;
  bool array_kept = true;       // what the controller wrote came back with the next call
  std::map<int, int> statuses;  // status -> calls
  std::map<std::string, Message> messages;  // by text
  TraceCall first;
  double step_s = 0.0;
  double last_time_s = 0.0;
  std::vector<RecordHistory> host;        // record n at n - 1, as sent
  std::vector<RecordHistory> controller;  // as answered, where the controller changed it

 private:
  void take(const TraceCall& call, const std::vector<float>& last_answer);
};

}  // namespace lac::sim
