// SPDX-License-Identifier: Apache-2.0
// Runs of records in the host block, made when compiling, and what is done with them: copies and
// tests without a branch per record.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/swap_layout.hpp"

namespace lac {

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

template <auto is_of_kind, int unit>
constexpr bool any_of_kind(int from) {
  for (int r = from; r < from + unit && r <= kHostBlock.last(); ++r) {
    if (is_of_kind(r)) return true;
  }
  return false;
}
template <auto is_of_kind, int unit>
constexpr RecordRun next_run(int from) {
  while (from <= kHostBlock.last() && !is_of_kind(from)) ++from;
  RecordRun run{from, 0};
  while (any_of_kind<is_of_kind, unit>(run.first + run.size)) run.size += unit;
  return run;
}
template <auto is_of_kind, int unit>
constexpr std::size_t count_runs() {
  std::size_t n = 0;
  int from = 1;
  for (RecordRun run = next_run<is_of_kind, unit>(from); run.size > 0; ++n) {
    from = run.first + run.size;
    run = next_run<is_of_kind, unit>(from);
  }
  return n;
}
/// Runs of the host block that hold all records of a kind, each a multiple of `unit` long: gaps and
/// what follows are taken along if that is cheaper than a run of its own.
template <auto is_of_kind, int unit>
constexpr auto runs_of() {
  std::array<RecordRun, count_runs<is_of_kind, unit>()> runs{};
  int from = 1;
  for (RecordRun& run : runs) {
    run = next_run<is_of_kind, unit>(from);
    from = run.first + run.size;
  }
  return runs;
}

}  // namespace detail

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

}  // namespace lac
