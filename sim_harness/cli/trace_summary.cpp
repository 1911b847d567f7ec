// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/trace_summary.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/swap_layout.hpp"

namespace lac::sim {
namespace {

double value_of(const std::vector<float>& array, Rec record) {
  return static_cast<double>(array.at(static_cast<std::size_t>(record) - 1));
}

bool same(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool is_demand(std::size_t record) {
  const RecordInfo* info = find_record(static_cast<int>(record));
  return info != nullptr && info->direction != Direction::In;
}

}  // namespace

void RecordHistory::take(float value, bool changed) {
  if (!seen) first = smallest = largest = value;
  seen = true;
  smallest = std::min(smallest, value);
  largest = std::max(largest, value);
  changes += changed ? 1 : 0;
}

TraceSummary::TraceSummary(TraceReader& trace)
    : host(static_cast<std::size_t>(trace.records())),
      controller(static_cast<std::size_t>(trace.records())) {
  TraceCall call;
  std::vector<float> last_answer(host.size());
  while (trace.next(call)) {
    if (calls == 0) first = call;
    take(call, last_answer);
    last_answered = call.answered;
    last_answer = call.answered ? call.answer : call.sent;
  }
}

void TraceSummary::take(const TraceCall& call, const std::vector<float>& last_answer) {
  ++calls;
  ++statuses[static_cast<int>(value_of(call.sent, Rec::Status))];
  last_time_s = value_of(call.sent, Rec::Time);
  step_s = value_of(call.sent, Rec::TimeStep);
  for (std::size_t i = 0; i < host.size(); ++i) {
    const bool changed = !same(call.sent[i], last_answer[i]);
    if (changed && calls > 1 && is_demand(i + 1)) array_kept = false;
    if (changed || host[i].seen) host[i].take(call.sent[i], changed);
    if (!call.answered) continue;
    const bool written = !same(call.answer[i], call.sent[i]);
    if (written || controller[i].seen) controller[i].take(call.answer[i], written);
  }
  if (call.answered && call.fail != 0) {
    Message& m = messages[call.message];
    if (m.count++ == 0) m = {call.fail, 1, last_time_s};
  }
}

}  // namespace lac::sim
