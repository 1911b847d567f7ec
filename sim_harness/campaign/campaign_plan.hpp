// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim_harness/campaign/case_marker.hpp"
#include "sim_harness/campaign/study_cases.hpp"
#include "sim_harness/campaign/wind_worker.hpp"

namespace lac::sim {

/// A study, and how far it is.
struct CampaignPlan {
  Study study;
  std::vector<StudyCase> cases;
  std::vector<std::string> fingerprints;  // one per case, of what would fly now
  std::vector<CaseMarker> markers;        // one per case
  /// What a marker of other inputs or of another program says; kOpen: there is none.
  std::vector<CaseState> outdated;

  std::size_t count(CaseState state) const;
};

/// Reads and checks the study and looks at what is there. `output`: empty, or another folder for
/// the results. Throws lac::Error.
CampaignPlan plan_campaign(const std::filesystem::path& study, const std::filesystem::path& output);

/// Reads the markers anew.
void look_again(CampaignPlan& plan);

/// The cases to fly now: what is neither done nor failed, or only what has failed, be it outdated.
std::vector<std::size_t> cases_to_fly(const CampaignPlan& plan, bool only_failed);

/// The same by their winds, in the order of the study. A wind that more cases share than keep the
/// jobs evenly busy is made more than once.
std::vector<WindOrder> wind_orders(const CampaignPlan& plan, const std::vector<std::size_t>& cases,
                                   int jobs);

/// One line per case: its state and name, and why it failed.
void list_cases(const CampaignPlan& plan, std::ostream& out);

}  // namespace lac::sim
