// SPDX-License-Identifier: Apache-2.0
// The lidar block of Guo's chain with the four results behind it (guo_lidar::kRews ...), for
// libraries of ours that work on it in their own master or in a foreign one.
#pragma once

#include <cmath>

#include "core/lidar_block.hpp"
#include "core/swap_view.hpp"

namespace lac {

/// What that chain writes where it has no wind speed. (Not a number would stay in its filters.)
inline constexpr double kGuoNoValue = 999.0;

/// The block at record 63 if it lies, results included, within what is known of the array. An array
/// without a known length is trusted up to kExtendedArraySize: the input file says that the host
/// follows this layout. first = 0 if there is none.
inline GuoBlock find_guo_results(const SwapReader& swap) {
  const int end = swap.size() > kHostBlock.last() ? swap.size() : kExtendedArraySize;
  const int first = swap.integer(Rec::LogStart, 0);
  if (first <= kHostBlock.last() || first + guo_lidar::kFixedSize > end) return {};
  const SwapReader header(swap.data(), end);
  const int gates = header.integer(first + guo_lidar::kNumberOfGates, 0);
  if (gates < 1 || gates > guo_lidar::kMaxGates) return {};
  if (first + guo_lidar::kFixedSize + gates - 1 > end) return {};
  return {first, gates};
}

/// One of the results; `offset` is guo_lidar::kRews or one of those behind it.
/// Precondition: block.first > 0.
inline double guo_result(const SwapReader& swap, GuoBlock block, int offset) {
  const int record = block.first + block.gates + offset;
  return SwapReader(swap.data(), record).at(record);
}
/// A value that is not finite is written as kGuoNoValue.
inline void put_guo_result(SwapView& swap, GuoBlock block, int offset, double value) {
  const int record = block.first + block.gates + offset;
  SwapView(swap.data(), record).put(record, std::isfinite(value) ? value : kGuoNoValue);
}

}  // namespace lac
