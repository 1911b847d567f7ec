// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "sim_harness/output/recording.hpp"

namespace lac::sim {

/// Reads an OpenFAST binary output file. Format ids: 4 (layout: core/outb_file.hpp), 2 (the same,
/// names of ten characters without their length in the file), 1 (as 2, with int32 times, which must
/// be equidistant) and 3 (as 2, float64 values without scale and offset). Throws lac::Error with
/// file, found and expected.
Recording read_outb(const std::filesystem::path& file);

}  // namespace lac::sim
