// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sim_harness/output/html_report.hpp"
#include "sim_harness/wind_check/theory_check.hpp"

namespace lac::sim {

/// What was compared with what, for headings.
struct CheckTitle {
  std::string wind;    // file or description
  std::string theory;  // name and parameters
  double mean_speed_mps = 0.0;
};

/// Standard deviations and a line on what lies outside, for the terminal.
std::string check_table(const TheoryCheck& check, const CheckTitle& title,
                        const CheckSettings& settings);

/// Spectra and coherences with theory and its 95 % band.
HtmlReport check_page(const TheoryCheck& check, const CheckTitle& title,
                      const CheckSettings& settings);

}  // namespace lac::sim
