// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/campaign_plan.hpp"

#include <algorithm>
#include <map>
#include <ostream>

#include "sim_harness/campaign/fingerprint.hpp"
#include "sim_harness/campaign/result_table.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kPiecesPerJob = 2;   // for an even load at the end
constexpr std::size_t kFewestPerWind = 8;  // fewer flights are not worth another wind

}  // namespace

std::size_t CampaignPlan::count(CaseState state) const {
  return static_cast<std::size_t>(std::ranges::count(markers, state, &CaseMarker::state));
}

CampaignPlan plan_campaign(const fs::path& study, const fs::path& output) {
  CampaignPlan plan;
  plan.study = load_study(study);
  if (!output.empty()) plan.study.folder = output;
  check_columns(plan.study);
  plan.cases = study_cases(plan.study);
  check_cases(plan.study, plan.cases);
  Fingerprints fingerprints;
  for (const StudyCase& c : plan.cases)
    plan.fingerprints.push_back(fingerprints.of_case(plan.study.base_case, c.overrides));
  look_again(plan);
  return plan;
}

void look_again(CampaignPlan& plan) {
  plan.markers.clear();
  plan.outdated.clear();
  for (std::size_t i = 0; i < plan.cases.size(); ++i) {
    CaseMarker marker = read_marker(plan.cases[i].folder);
    const bool other =
        marker.state != CaseState::kOpen && marker.fingerprint != plan.fingerprints[i];
    plan.outdated.push_back(other ? marker.state : CaseState::kOpen);
    plan.markers.push_back(other ? CaseMarker{} : std::move(marker));
  }
}

std::vector<std::size_t> cases_to_fly(const CampaignPlan& plan, bool only_failed) {
  std::vector<std::size_t> cases;
  for (std::size_t i = 0; i < plan.cases.size(); ++i) {
    const CaseState state = plan.markers[i].state;
    const bool failed = state == CaseState::kFailed || plan.outdated[i] == CaseState::kFailed;
    if (only_failed ? failed : state == CaseState::kOpen) cases.push_back(i);
  }
  return cases;
}

std::vector<WindOrder> wind_orders(const CampaignPlan& plan, const std::vector<std::size_t>& cases,
                                   int jobs) {
  const std::size_t pieces = kPiecesPerJob * static_cast<std::size_t>(jobs);
  const std::size_t most = std::max(kFewestPerWind, (cases.size() + pieces - 1) / pieces);
  std::vector<WindOrder> orders;
  std::map<std::string, std::size_t> latest;  // order of a wind that still takes cases
  for (const std::size_t i : cases) {
    const StudyCase& c = plan.cases[i];
    const auto [at, is_new] = latest.try_emplace(c.wind, orders.size());
    if (is_new || orders[at->second].cases.size() >= most) {
      at->second = orders.size();
      orders.emplace_back().time_limit_s = plan.study.time_limit_s;
    }
    WindOrder& order = orders[at->second];
    order.cases.push_back({plan.study.base_case, c.overrides, c.folder});
    order.fingerprints.push_back(plan.fingerprints[i]);
  }
  return orders;
}

void list_cases(const CampaignPlan& plan, std::ostream& out) {
  for (std::size_t i = 0; i < plan.cases.size(); ++i) {
    const CaseMarker& marker = plan.markers[i];
    const bool outdated = plan.outdated[i] != CaseState::kOpen;
    out << (outdated ? "outdated" : word(marker.state)) << "  " << plan.cases[i].name
        << (marker.reason.empty() ? "" : ": ") << marker.reason << '\n';
  }
}

}  // namespace lac::sim
