// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/report_command.hpp"

#include <ostream>

#include "sim_harness/campaign_report/campaign_page.hpp"
#include "sim_harness/output/page_parts.hpp"

namespace lac::sim {
namespace fs = std::filesystem;

void report_command(const ReportOptions& options, std::ostream& out) {
  const CampaignReport report = campaign_report(options.report);
  for (const std::string& note : report.notes) out << "note: " << note << '\n';
  const fs::path page =
      options.output.empty() ? page_beside(options.report.inputs.front()) : options.output;
  write_page(page, campaign_page(report));
  out << "wrote " << page.string() << '\n';
}

}  // namespace lac::sim
