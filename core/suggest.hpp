// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lac {

/// The candidate closest to a mistyped word (edit distance, case ignored), or empty if none is
/// close enough to be meant (at most a third of the letters wrong, at least one allowed).
std::string closest(std::string_view word, const std::vector<std::string>& candidates);

/// " (did you mean 'X'?)" or empty.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// Equal but for upper and lower case (ASCII).
bool equal_ignoring_case(std::string_view a, std::string_view b);

}  // namespace lac
