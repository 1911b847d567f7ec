// SPDX-License-Identifier: Apache-2.0
// Which of the host's records pass in which direction, as tables made from core/swap_records.def,
// and tests and copies over them that cost little.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/swap_layout.hpp"
#include "wrapper/private_array.hpp"

namespace lac {

/// What ExtendedDemands passes both ways.
inline constexpr RecordBlock kExtendedDemands{"cable and structural control", 2601, 400};

namespace detail {

constexpr bool is_demand(const RecordInfo& r) {
  return r.direction != Direction::In && r.index <= kHostBlock.last() &&
         r.index != static_cast<int>(Rec::LogCount);  // counts values in the private log area
}
constexpr bool is_measured(const RecordInfo& r) {
  return r.direction == Direction::In && r.index <= kHostBlock.last() && r.unit != "-";
}
template <auto predicate>
constexpr auto records_where() {
  constexpr auto count = std::count_if(kRecords.begin(), kRecords.end(), predicate);
  std::array<int, static_cast<std::size_t>(count)> all{};
  std::size_t n = 0;
  for (const RecordInfo& r : kRecords) {
    if (predicate(r)) all[n++] = r.index;
  }
  return all;
}

}  // namespace detail

/// What the chain gives to the host (Out and Both), and what must be finite to control at all.
inline constexpr auto kDemandRecords = detail::records_where<detail::is_demand>();
inline constexpr auto kMeasuredRecords = detail::records_where<detail::is_measured>();

/// Records that are taken from the host only if they are finite; index 0 is unused.
inline constexpr std::array<bool, kHostBlock.size + 1> kMustBeFinite = [] {
  std::array<bool, kHostBlock.size + 1> must{};
  for (const int record : kMeasuredRecords) must[static_cast<std::size_t>(record)] = true;
  for (const int record : kDemandRecords) must[static_cast<std::size_t>(record)] = true;
  return must;
}();

/// Sign bit set if x is infinite or not a number: the exponent, all ones, carries into it. Tests
/// are or-ed over many records without a branch.
inline std::uint32_t non_finite_bit(float x) {
  return (std::bit_cast<std::uint32_t>(x) & 0x7f800000u) + 0x00800000u;
}
inline bool is_finite(float x) {
  return (non_finite_bit(x) >> 31) == 0;
}

/// A run of records.
struct RecordRun {
  int first = 0;
  int size = 0;
};

namespace detail {

constexpr bool is_chains_own(int record) {
  return std::ranges::any_of(kRecords, [record](const RecordInfo& r) {
    return r.index == record && r.direction == Direction::Out;
  });
}
constexpr bool is_input(int record) {
  return !is_chains_own(record);
}
constexpr bool is_judged(int record) {
  return is_input(record) && kMustBeFinite[static_cast<std::size_t>(record)];
}
constexpr bool is_demand_record(int record) {
  return std::ranges::find(kDemandRecords, record) != kDemandRecords.end();
}

/// Runs of the host block that hold all records of a kind, each a multiple of `unit` long: gaps and
/// what follows are taken along if that is cheaper than a run of its own.
template <auto is_of_kind, int unit>
constexpr auto runs_of() {
  constexpr auto any = [](int from) {
    for (int r = from; r < from + unit && r <= kHostBlock.last(); ++r) {
      if (is_of_kind(r)) return true;
    }
    return false;
  };
  constexpr auto next = [any](int from, RecordRun& run) {
    while (from <= kHostBlock.last() && !is_of_kind(from)) ++from;
    run = {from, 0};
    for (; any(from); from += unit) run.size += unit;
    return from;
  };
  constexpr auto count = [=] {
    RecordRun run;
    std::size_t n = 0;
    for (int from = next(1, run); run.size > 0; from = next(from, run)) ++n;
    return n;
  }();
  std::array<RecordRun, count> runs{};
  int from = 1;
  for (RecordRun& run : runs) from = next(from, run);
  return runs;
}

}  // namespace detail

/// What is copied from the host: all but the records that only the chain writes, which keep the
/// chain's own values, also with a host that brings a fresh array to every call.
inline constexpr auto kInputRuns = detail::runs_of<detail::is_input, 1>();
/// Input records that must be finite, with some others between them.
inline constexpr auto kJudgedRuns = detail::runs_of<detail::is_judged, 4>();
/// Demand records, likewise.
inline constexpr auto kDemandRuns = detail::runs_of<detail::is_demand_record, 4>();

/// How many records the runs hold.
template <const auto& runs>
constexpr std::size_t kPackedSize = [] {
  int sum = 0;
  for (const RecordRun& run : runs) sum += run.size;
  return static_cast<std::size_t>(sum);
}();

/// Where the records of the host block stand if the runs follow each other without gaps; -1 if they
/// are in no run. Index 0 is unused.
template <const auto& runs>
constexpr auto kPackedIndex = [] {
  std::array<int, kHostBlock.size + 1> index{};
  index.fill(-1);
  int n = 0;
  for (const RecordRun& run : runs) {
    for (int r = run.first; r < run.first + run.size; ++r) index[static_cast<std::size_t>(r)] = n++;
  }
  return index;
}();

/// Calls f(first, size) for each run with both as constants: loops over them are unrolled.
template <const auto& runs, class F>
void for_each_run(F f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (f(std::integral_constant<int, runs[i].first>{}, std::integral_constant<int, runs[i].size>{}),
     ...);
  }
  (std::make_index_sequence<runs.size()>{});
}

/// True if every record of the runs, whose sizes are multiples of 4, is finite: four at a time.
template <const auto& runs>
bool all_finite(const float* block) {
  std::array<std::uint32_t, 4> bad{};
  for_each_run<runs>([&](auto first, auto size) {
    static_assert(size % 4 == 0 && first + size - 1 <= kHostBlock.last());
    for (int i = 0; i < size; i += 4) {
      for (int j = 0; j < 4; ++j) bad[j] |= non_finite_bit(block[first - 1 + i + j]);
    }
  });
  return ((bad[0] | bad[1] | bad[2] | bad[3]) >> 31) == 0;
}

/// From one host block to another.
template <const auto& runs>
void copy_runs(const float* from, float* to) {
  for_each_run<runs>([&](auto first, auto size) {
    std::memcpy(to + first - 1, from + first - 1, size * sizeof(float));
  });
}
/// From a host block to as few cache lines as possible.
template <const auto& runs>
void pack_runs(const float* from, std::array<float, kPackedSize<runs>>& to) {
  for_each_run<runs>([&](auto first, auto size) {
    std::memcpy(to.data() + kPackedIndex<runs>[first], from + first - 1, size * sizeof(float));
  });
}

/// Calls f(record) for each demand, unrolled: the records are constants.
template <class F>
void for_each_demand(F f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (f(std::integral_constant<int, kDemandRecords[i]>{}), ...);
  }
  (std::make_index_sequence<kDemandRecords.size()>{});
}

/// Precondition: both arrays hold the records.
inline void copy_records(const float* from, PrivateArray& to, int first, int size) {
  std::memcpy(to.record(first), from + first - 1, static_cast<std::size_t>(size) * sizeof(float));
}

inline const char* name_of_record(int record) {
  return find_record(record)->name.data();  // stringised in the table, hence terminated
}

}  // namespace lac
