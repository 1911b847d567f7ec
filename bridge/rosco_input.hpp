// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "bridge/bridge_params.hpp"
#include "core/input_file.hpp"

namespace lac {

/// Refuses a DISCON.IN of ROSCO in which the signals of the bridge would mean something else, or
/// nothing. `in` is the bridge's own file, for the message. Throws lac::Error.
void check_rosco_input(const InputFile& in, const std::filesystem::path& discon_in,
                       const BridgeParams& params);

}  // namespace lac
