// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/discon_module.hpp"

namespace lac {

/// The module for an LDP input file of Guo's chain, or nullptr if the file is of our own form. It
/// needs no master of ours: it reads the lidar block at record 63 and writes its REWS behind it,
/// and the Lidar* records where there are any. Throws lac::Error.
std::unique_ptr<DisconModule> make_guo_ldp(const StartInfo& start, SwapView swap, Notice& notice);

}  // namespace lac
