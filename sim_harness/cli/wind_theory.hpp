// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "sim_harness/cli/wind_command.hpp"

namespace lac::sim {

/// The theory that `lac wind check` compares with: of --theory-case, of --theory and its numbers,
/// or, if the wind is made from a case file, its own. Throws lac::Error if there is none.
std::unique_ptr<TurbulenceTheory> theory_of(const WindCheckOptions& options,
                                            const LoadedWind& wind);

}  // namespace lac::sim
