// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>

namespace lac::sim {

struct MigrateOptions {
  std::filesystem::path file;
  std::filesystem::path output;  // empty: to `out`
  bool force = false;            // replace an existing file
};

/// `lac migrate`: an input file of Guo's chain (WRAPPER.IN, LDP, FFP) as one of our own form.
/// Throws lac::Error.
void migrate_command(const MigrateOptions& options, std::ostream& out);

}  // namespace lac::sim
