// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/discon_module.hpp"

namespace lac {

/// The module for an FFP input file of Guo's chain, or nullptr if the file is of our own form. It
/// needs no master of ours: see guo_ffp_discon.cpp for what it reads and writes. Throws lac::Error.
std::unique_ptr<DisconModule> make_guo_ffp(const StartInfo& start, SwapView swap, Notice& notice);

}  // namespace lac
