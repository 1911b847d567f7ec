// SPDX-License-Identifier: Apache-2.0
// The part of a report that its script reads: traces and spectra as JSON.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "sim_harness/output/html_report.hpp"

namespace lac::sim {

/// {"runs":[..],"t0":..,"dt":..,"n":..,"runIn":..,"traces":[..],"spectra":[..]}; "<" and "&" do
/// not occur in it, so that it can stand inside a script element. Trace data is base64 of
/// little-endian uint16: 0 ... 65534 from "low" to "high", 65535 no value.
std::string report_json(const HtmlReport& report);

/// How many samples become one value on the page; 1 if the traces are stored whole.
std::size_t thinning_factor(const HtmlReport& report);

/// Every stretch of 2 * factor samples becomes its minimum and maximum in the order in which
/// they occur; a stretch without a finite value becomes two NaN. factor 1 changes nothing.
std::vector<double> thinned(std::span<const double> values, std::size_t factor);

}  // namespace lac::sim
