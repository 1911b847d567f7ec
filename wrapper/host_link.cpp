// SPDX-License-Identifier: Apache-2.0
#include "wrapper/host_link.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/error.hpp"
#include "core/lidar_block.hpp"

namespace lac {
namespace {

constexpr RecordBlock kLegacyRest{"rest of the legacy part", 165, 835};  // 165-999, torque table
constexpr RecordBlock kExtendedDemands{"cable and structural control", 2601, 400};
constexpr int kHostSize = kHostBlock.size;

/// Records that are taken from the host only if they are finite.
constexpr std::array<bool, kHostSize + 1> kMustBeFinite = [] {
  std::array<bool, kHostSize + 1> must{};
  for (const int record : kMeasuredRecords) must[static_cast<std::size_t>(record)] = true;
  for (const int record : kDemandRecords) must[static_cast<std::size_t>(record)] = true;
  return must;
}();

/// Records that only the chain writes: they keep the chain's own values, also with a host that
/// brings a fresh array to every call.
constexpr bool is_chains_own(int record) {
  return std::ranges::any_of(kRecords, [record](const RecordInfo& r) {
    return r.index == record && r.direction == Direction::Out;
  });
}

struct Run {
  int first = 0;
  std::size_t size = 0;
};
constexpr int next_run(int from, Run& run) {
  while (from <= kHostSize && is_chains_own(from)) ++from;
  run.first = from;
  while (from <= kHostSize && !is_chains_own(from)) ++from;
  run.size = static_cast<std::size_t>(from - run.first);
  return from;
}
constexpr std::size_t count_runs() {
  Run run;
  std::size_t n = 0;
  for (int from = 1; from <= kHostSize; ++n) from = next_run(from, run);
  return n;
}
/// The host block without the chain's own records.
constexpr auto kInputRuns = [] {
  std::array<Run, count_runs()> runs{};
  int from = 1;
  for (Run& run : runs) from = next_run(from, run);
  return runs;
}();

/// Sign bit set if x is infinite or not a number: the exponent, all ones, carries into it. Tests
/// are or-ed over many records without a branch.
std::uint32_t non_finite_bit(float x) {
  return (std::bit_cast<std::uint32_t>(x) & 0x7f800000u) + 0x00800000u;
}
bool is_finite(float x) {
  return (non_finite_bit(x) >> 31) == 0;
}
bool host_block_is_finite(const float* x) {
  std::uint32_t bad = 0;
  for (int i = 0; i < kHostSize; ++i) bad |= non_finite_bit(x[i]);
  return (bad >> 31) == 0;
}

/// Calls f(i, record) for each demand, unrolled: the records are constants.
template <class F>
void for_each_demand(F f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (f(i, kDemandRecords[i]), ...);
  }
  (std::make_index_sequence<kDemandRecords.size()>{});
}

/// From one host block to another, unrolled with constant sizes: half the time of one memcpy.
void copy_inputs(const float* from, float* to) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (std::memcpy(to + kInputRuns[i].first - 1, from + kInputRuns[i].first - 1,
                 kInputRuns[i].size * sizeof(float)),
     ...);
  }
  (std::make_index_sequence<kInputRuns.size()>{});
}

void copy_block(SwapView from, PrivateArray& to, int first, int size) {
  std::memcpy(to.record(first), from.data() + first - 1,
              static_cast<std::size_t>(size) * sizeof(float));
}

/// Flag, beam, gate count, speeds, attitude and velocity; what follows belongs to the chain.
int host_part_of(GuoBlock block) {
  return guo_lidar::kAfterGates + block.gates + 6;
}

/// The block, if it lies within what is known of the array. An array without a known size is
/// trusted: the user has said that it carries this layout.
GuoBlock fitting_guo_block(SwapView host) {
  const int end = host.size() > kHostBlock.last() ? host.size() : kExtendedArraySize;
  const int header_end = host.integer(Rec::LogStart, 0) + guo_lidar::kNumberOfGates;
  if (header_end > end) return {};
  const GuoBlock block = find_guo_block(host.data());
  return block.first + host_part_of(block) - 1 <= end ? block : GuoBlock{};
}

const char* name_of(int record) {
  return find_record(record)->name.data();  // stringised in the table, hence terminated
}

}  // namespace

void HostLink::require(const SwapReader& host) const {
  const auto need = [&](const RecordBlock& block, const std::string& key) {
    if (host.holds(block)) return;
    throw Error(key + " needs records " + std::to_string(block.first) + "-" +
                std::to_string(block.last()) + " (" + std::string(block.name) + "), but only " +
                std::to_string(host.size()) +
                " records of the host's array are known to exist; a longer one says so with "
                "record 66 = 1001 and its length in record 129");
  };
  if (lidar_ == HostLidar::Native) need(kNativeLidarBlock, "LidarLayout native");
  if (extended_demands_) need(kExtendedDemands, "ExtendedDemands");
}

void HostLink::start(SwapView host, PrivateArray& array, State& state) const {
  for (const int record : kMeasuredRecords) {
    if (!is_finite(host.data()[record - 1])) {
      throw Error("record " + std::to_string(record) + " (" + name_of(record) +
                  ") is not finite at the first call");
    }
  }
  copy_block(host, array, kHostBlock.first, kHostBlock.size);
  if (host.holds(kLegacyRest) && lidar_ != HostLidar::Guo) {
    copy_block(host, array, kLegacyRest.first, kLegacyRest.size);
  }
  for (const int record : kDemandRecords) {
    float& demand = *array.record(record);
    if (!is_finite(demand)) demand = 0.0f;  // never written by a chain yet
  }
  std::memcpy(state.good.data(), array.record(1), sizeof state.good);
  keep_demands(array, state);
}

void HostLink::take_inputs(SwapView host, PrivateArray& array, State& state,
                           Notice& notice) const noexcept {
  if (host_block_is_finite(host.data()) && !state.holding) {
    copy_inputs(host.data(), state.good.data());
  } else {
    take_doubtful_inputs(host.data(), state, notice);
  }
  copy_inputs(state.good.data(), array.record(1));
  if (host.holds(kPlatformBlock)) {
    copy_block(host, array, kPlatformBlock.first, kPlatformBlock.size);
  }
  if (extended_demands_) {
    copy_block(host, array, kExtendedDemands.first, kExtendedDemands.size);
  }
  take_lidar(host, array, state);
}

void HostLink::take_doubtful_inputs(const float* host, State& state,
                                    Notice& notice) const noexcept {
  for (int record = 1; record <= kHostSize; ++record) {
    const float value = host[record - 1];
    if (is_finite(value) || !kMustBeFinite[static_cast<std::size_t>(record)]) {
      state.good[static_cast<std::size_t>(record - 1)] = value;
    }
  }
  bool any = false;
  for (std::size_t i = 0; i < kMeasuredRecords.size(); ++i) {
    const int record = kMeasuredRecords[i];
    const bool bad = !is_finite(host[record - 1]);
    if (bad && !state.not_finite[i]) {
      notice.warn("record %d (%s) is not finite: demands are held until it is good again", record,
                  name_of(record));
    }
    state.not_finite[i] = bad;
    any = any || bad;
  }
  if (state.holding && !any) notice.warn("all measured records are finite again: demands go on");
  state.holding = any;
}

void HostLink::take_lidar(SwapView host, PrivateArray& array, State& state) const noexcept {
  if (lidar_ == HostLidar::Native) {
    const int first = kNativeLidarBlock.first;
    copy_block(host, array, first, native_lidar::kNewData + 1);
    if (!native_lidar_is_new(host)) return;
    const int gates = std::clamp(host.integer(first + native_lidar::kNumberOfGates, 0), 0,
                                 native_lidar::kMaxGates);
    copy_block(host, array, first, native_lidar::gate_offset(gates));
  } else if (lidar_ == HostLidar::Guo) {
    const GuoBlock block = fitting_guo_block(host);
    state.log_start = block.first;  // 0: the reader of the block reports it
    if (block.first == 0) return;
    copy_block(host, array, block.first, host_part_of(block));
  }
}

void HostLink::keep_demands(PrivateArray& array, State& state) const noexcept {
  for_each_demand([&](std::size_t i, int record) { state.demands[i] = *array.record(record); });
}

void HostLink::hold_demands(PrivateArray& array, const State& state) const noexcept {
  for_each_demand([&](std::size_t i, int record) { *array.record(record) = state.demands[i]; });
}

void HostLink::give_demands(PrivateArray& array, SwapView host, bool fresh) const noexcept {
  for_each_demand([&](std::size_t, int record) { host.put(record, *array.record(record)); });
  host.set(Rec::LogCount, 0.0);
  if (extended_demands_ && fresh) {
    std::memcpy(host.data() + kExtendedDemands.first - 1, array.record(kExtendedDemands.first),
                static_cast<std::size_t>(kExtendedDemands.size) * sizeof(float));
  }
}

int HostLink::bad_demand(PrivateArray& array) noexcept {
  std::uint32_t bad = 0;
  for_each_demand([&](std::size_t, int record) { bad |= non_finite_bit(*array.record(record)); });
  if ((bad >> 31) == 0) return 0;
  for (const int record : kDemandRecords) {
    if (!is_finite(*array.record(record))) return record;
  }
  return 0;
}

}  // namespace lac
