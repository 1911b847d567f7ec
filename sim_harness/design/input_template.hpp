// SPDX-License-Identifier: Apache-2.0
// Controller input files with some of their keys written anew.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lac::sim {

/// The text with `block` in the place of the first of these keys, all lines of them left out, and
/// the comments right above them too, as they tell of other numbers. Everything else stays as it
/// is. Keys in lower case. Precondition: the text has been read as an input file.
std::string with_keys_replaced(std::string_view text, const std::vector<std::string>& keys,
                               const std::string& block);

/// "! text" of each line.
std::string commented(const std::string& text);

/// "1 2.5 3 ! Key - description" with these decimals.
std::string key_row(const std::vector<double>& values, int decimals,
                    const std::string& key_and_description);

}  // namespace lac::sim
