// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim_harness/campaign_report/campaign_report.hpp"

namespace lac::sim {

/// What was flown, how much of it is done, and what the numbers mean: names and values. The
/// conventions of loads are always among them.
std::vector<std::pair<std::string, std::string>> campaign_summary(const CampaignReport& report);

/// Parameters that are the same in all rows, with their value.
std::vector<std::pair<std::string, std::string>> fixed_parameters(const CampaignReport& report);

struct CaseNotDone {
  std::string name;
  std::string status;
  std::string reason;
};
std::vector<CaseNotDone> cases_not_done(const CampaignReport& report);

}  // namespace lac::sim
