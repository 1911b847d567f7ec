// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/error.hpp"
#include "core/swap_view.hpp"

namespace lac {

/// Is this array the master's, with the records our libraries share?
inline bool has_chain_block(const SwapReader& swap) {
  return swap.holds(kChainBlock) && swap.holds(kChainSecondBlock) &&
         swap.integer(Rec::ChainVersion, 0) == kChainLayoutVersion;
}

/// For libraries that cannot do without it. Throws lac::Error.
inline void require_chain_block(const SwapReader& swap) {
  if (has_chain_block(swap)) return;
  throw Error("the records of the chain (" + std::to_string(kChainBlock.first) + " to " +
              std::to_string(kChainBlock.last()) + ", layout " +
              std::to_string(kChainLayoutVersion) + ") are not there; the array has " +
              std::to_string(swap.size()) +
              " known records. This library works behind the LAC wrapper: name it there as a "
              "secondary instead of loading it from the host");
}

}  // namespace lac
