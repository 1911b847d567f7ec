// SPDX-License-Identifier: Apache-2.0
// The input file of one library of a chain with some of its values replaced.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lac::sim {

/// A key and the value it is to have.
struct KeyValue {
  std::string key;
  std::string value;
};

/// The text with these values in the place of those of its keys, everything behind them kept; keys
/// it does not have come at the end, with a comment. Case of keys ignored.
std::string with_values(std::string_view input_text, const std::vector<KeyValue>& values);

/// Input file of the secondary of this name in the master's input file. Throws lac::Error.
std::filesystem::path input_of_secondary(const std::filesystem::path& master_input,
                                         const std::string& secondary);

/// Makes `folder` a copy by links of the folder that holds the master's input file, in a copy by
/// links of the folder above, so that paths within both still hold, but with `text` in the place of
/// `changed`. Returns the master's input file there. `changed` must lie beside the master's input
/// file, else, or if something cannot be made, throws lac::Error.
std::filesystem::path linked_chain(const std::filesystem::path& master_input,
                                   const std::filesystem::path& changed, const std::string& text,
                                   const std::filesystem::path& folder);

}  // namespace lac::sim
