// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>

#include "sim_harness/campaign_report/campaign_report.hpp"

namespace lac::sim {

struct ReportOptions {
  CampaignReportOptions report;
  std::filesystem::path output;  // the page; empty: beside the first table, report.html of
                                 // results.csv, else <name of the table>.html
};

/// `lac report`: one page with the results of a campaign. Throws lac::Error.
void report_command(const ReportOptions& options, std::ostream& out);

}  // namespace lac::sim
