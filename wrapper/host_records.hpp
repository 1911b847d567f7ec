// SPDX-License-Identifier: Apache-2.0
// Which of the host's records pass in which direction: tables made from core/swap_records.def.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/swap_layout.hpp"
#include "wrapper/private_array.hpp"
#include "wrapper/record_runs.hpp"

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

}  // namespace detail

/// What is copied from the host: all but the records that only the chain writes, which keep the
/// chain's own values, also with a host that brings a fresh array to every call.
inline constexpr auto kInputRuns = detail::runs_of<detail::is_input, 1>();
/// Input records that must be finite, with some others between them.
inline constexpr auto kJudgedRuns = detail::runs_of<detail::is_judged, 4>();
/// Demand records, likewise.
inline constexpr auto kDemandRuns = detail::runs_of<detail::is_demand_record, 4>();

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
