// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim_harness/design/design_report.hpp"
#include "sim_harness/output/html_report.hpp"

namespace lac::sim {

/// Coherence, |G_RL| with the low-pass that was designed, and the figures, of at most six wind
/// speeds, evenly taken.
HtmlReport design_page(const DesignResult& result);

}  // namespace lac::sim
