// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace lac::sim {

/// Throws lac::Error for an option of `lac life` or `lac compare` that nothing would come of: what
/// figures are computed from without a folder, what chooses rows without a table.
void require_effect(const CLI::App& command, const std::vector<std::filesystem::path>& inputs);

/// Throws lac::Error if an option that names a controller is given for a folder: it holds the
/// results of one.
void require_table(const CLI::App& command, const std::string& option,
                   const std::filesystem::path& input);

}  // namespace lac::sim
