// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim_harness/comparison/comparison.hpp"

namespace lac::sim {

/// For the terminal: a table of wind speed by quantity, "-12.3 ± 2.1 %", in brackets what is not
/// significant; the same in words; what the numbers mean, and how many would be called significant
/// by chance.
std::string comparison_text(const Comparison& comparison, const WindDistribution& wind);

/// One cell of that table; "n/a" for none.
std::string change_text(const std::optional<Change>& change);

/// What stands below it: what intervals, life and loads mean, what was left out.
std::vector<std::string> comparison_notes(const Comparison& comparison,
                                          const WindDistribution& wind);

/// One row per quantity and wind speed ("life" for the whole): values, change, interval, verdict.
std::string comparison_csv(const Comparison& comparison);

}  // namespace lac::sim
