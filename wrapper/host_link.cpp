// SPDX-License-Identifier: Apache-2.0
#include "wrapper/host_link.hpp"

#include <cstdint>
#include <cstring>
#include <utility>

#include "core/error.hpp"
#include "wrapper/host_lidar.hpp"

namespace lac {
namespace {

constexpr RecordBlock kLegacyRest{"rest of the legacy part", 165, 835};  // 165-999, torque table
constexpr int kHostSize = kHostBlock.size;

}  // namespace

void HostLink::require(const SwapReader& host) const {
  require_host_lidar(lidar_, host);
  if (extended_demands_) {
    require_records(host, kExtendedDemands, "ExtendedDemands",
                    "a longer one says so with record 66 = 1001 and its length in record 129");
  }
}

void HostLink::start(SwapView host, PrivateArray& array, State& state) const {
  for (const int record : kMeasuredRecords) {
    if (!is_finite(host.data()[record - 1])) {
      throw Error("record " + std::to_string(record) + " (" + name_of_record(record) +
                  ") is not finite at the first call");
    }
  }
  copy_records(host.data(), array, kHostBlock.first, kHostBlock.size);
  if (host.holds(kLegacyRest) && lidar_ != HostLidar::Guo) {
    copy_records(host.data(), array, kLegacyRest.first, kLegacyRest.size);
  }
  for (const int record : kDemandRecords) {
    float& demand = *array.record(record);
    if (!is_finite(demand)) demand = 0.0f;  // never written by a chain yet
  }
  pack_runs<kJudgedRuns>(array.record(1), state.good);
  keep_demands(array, state);
}

void HostLink::take_inputs(SwapView host, PrivateArray& array, State& state,
                           Notice& notice) const noexcept {
  copy_runs<kInputRuns>(host.data(), array.record(1));
  if (all_finite<kJudgedRuns>(host.data()) && !state.holding) {
    pack_runs<kJudgedRuns>(host.data(), state.good);
  } else {
    take_doubtful_inputs(host.data(), array, state, notice);
  }
  if (host.holds(kPlatformBlock)) {
    copy_records(host.data(), array, kPlatformBlock.first, kPlatformBlock.size);
  }
  if (extended_demands_) {
    copy_records(host.data(), array, kExtendedDemands.first, kExtendedDemands.size);
  }
  state.log_start = take_host_lidar(lidar_, host, array);
}

void HostLink::take_doubtful_inputs(const float* host, PrivateArray& array, State& state,
                                    Notice& notice) const noexcept {
  for (int record = 1; record <= kHostSize; ++record) {
    if (!detail::is_judged(record)) continue;
    const int packed = kPackedIndex<kJudgedRuns>[static_cast<std::size_t>(record)];
    float& good = state.good[static_cast<std::size_t>(packed)];
    if (is_finite(host[record - 1])) good = host[record - 1];
    *array.record(record) = good;
  }
  bool any = false;
  for (std::size_t i = 0; i < kMeasuredRecords.size(); ++i) {
    const int record = kMeasuredRecords[i];
    const bool bad = !is_finite(host[record - 1]);
    if (bad && !state.not_finite[i]) {
      notice.warn("record %d (%s) is not finite: demands are held until it is good again", record,
                  name_of_record(record));
    }
    state.not_finite[i] = bad;
    any = any || bad;
  }
  if (state.holding && !any) notice.warn("all measured records are finite again: demands go on");
  state.holding = any;
}

void HostLink::keep_demands(PrivateArray& array, State& state) const noexcept {
  pack_runs<kDemandRuns>(array.record(1), state.demands);
}

void HostLink::hold_demands(PrivateArray& array, const State& state) const noexcept {
  for_each_demand([&](auto record) {
    *array.record(record) = state.demands[kPackedIndex<kDemandRuns>[record]];
  });
}

void HostLink::give_demands(PrivateArray& array, SwapView host, bool fresh) const noexcept {
  for_each_demand([&](auto record) { host.put(record, *array.record(record)); });
  host.set(Rec::LogCount, 0.0);
  if (extended_demands_ && fresh) {
    std::memcpy(host.data() + kExtendedDemands.first - 1, array.record(kExtendedDemands.first),
                static_cast<std::size_t>(kExtendedDemands.size) * sizeof(float));
  }
}

int HostLink::bad_demand(PrivateArray& array) noexcept {
  if (all_finite<kDemandRuns>(array.record(1))) return 0;
  for (const int record : kDemandRecords) {
    if (!is_finite(*array.record(record))) return record;
  }
  return 0;  // a record between them, which is none
}

}  // namespace lac
