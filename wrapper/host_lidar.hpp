// SPDX-License-Identifier: Apache-2.0
// The host's lidar records on their way to the private array. Their values are judged by their
// reader, not here: a lidar that sends rubbish is no reason to hold the turbine's demands.
#pragma once

#include <string>

#include "core/swap_view.hpp"
#include "wrapper/chain_config.hpp"
#include "wrapper/private_array.hpp"

namespace lac {

/// Throws lac::Error unless the host's array is known to hold the block; `key` is what asked.
void require_records(const SwapReader& host, const RecordBlock& block, const std::string& key,
                     const std::string& hint);

/// Throws lac::Error if the host's array cannot carry the layout, with the hosts that can. A Guo
/// block is looked for in each call; where there is none its readers say so.
void require_host_lidar(HostLidar layout, const SwapReader& host);

/// Copies what the host sends: native, the header and the gates in use while the flag is up (the
/// flag always); guo, flag to velocity; openfast, the block. Gives the first record of Guo's block,
/// 0 if there is none, and for the other layouts the private logging area. [real time]
int take_host_lidar(HostLidar layout, SwapView host, PrivateArray& array) noexcept;

}  // namespace lac
