// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace lac {

/// One module's state in a file. A restarted process knows nothing but this file's name, so the
/// file also says what the module was built from.
struct Checkpoint {
  std::string module;      // which library wrote it
  std::string input_file;  // what the module was built from
  std::string out_name;
  double time_step_s = 0.0;
  std::int64_t steps = 0;  // steps done since status 0
  std::vector<std::byte> state;
};

/// Format: "LACCHKP", version, length-prefixed fields, 64-bit FNV-1a sum of all before it.
/// Written beside its final name and moved there, so that a broken write leaves no file.
/// Throws lac::Error (file, reason).
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// Throws lac::Error: no file, no checkpoint, other version, damaged, other module.
Checkpoint read_checkpoint(const std::filesystem::path& file, const std::string& module);

}  // namespace lac
