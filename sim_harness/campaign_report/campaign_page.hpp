// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "sim_harness/campaign_report/campaign_report.hpp"

namespace lac::sim {

/// One self-contained page: no other file, no network. Tables of comparisons are in the HTML;
/// figures, filters and the table of all rows are drawn by its scripts from campaign_data_json().
std::string campaign_page(const CampaignReport& report);

/// Where the page of a folder or table goes: beside the table, report.html for results.csv, else
/// <name of the table>.html.
std::filesystem::path page_beside(const std::filesystem::path& folder_or_table);

/// What the scripts read: {"controllers":[name..],"columns":[{"name","figure"}..],"varied":[..],
/// "quantities":[{"name","unit","column","shown"}..],"rows":[[cell..]..],"runs":[[row, controller,
/// speed]..], "views":[{"name","column","value","lives":[{"speeds":[..],"values":[[at speeds..,
/// life]..]}..], "comparisons":[{"a","b","speeds":[..],"pairs":[[row a, row b, speed]..],
/// "changes":[[change at speeds.., over a life]..]}..]}..]}. A change is [pairs, a, b, relative,
/// low, high, significant] or null. Numbers have six digits.
std::string campaign_data_json(const CampaignReport& report);

}  // namespace lac::sim
