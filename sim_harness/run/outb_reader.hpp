// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "sim_harness/output/recording.hpp"

namespace lac::sim {

/// Reads an OpenFAST binary output file of format id 4 (layout: core/outb_file.hpp). Throws
/// lac::Error with file, found and expected.
Recording read_outb(const std::filesystem::path& file);

}  // namespace lac::sim
