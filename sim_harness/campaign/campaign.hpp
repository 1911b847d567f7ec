// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>

namespace lac::sim {

struct CampaignOptions {
  std::filesystem::path study;
  std::filesystem::path output;  // folder of the results; empty: as the study says
  int jobs = 0;                  // processes at a time; 0: one per core
  bool only_failed = false;      // fly what has failed before, and nothing else
  bool list = false;             // only show every case with its state
  bool dry_run = false;          // only show what would be flown, one command a line
  bool report = true;            // write the page too
};

/// Flies what is not done of a study, over all cores, and writes its table of results:
/// <folder>/study.txt (its name) and cases.txt (the commands) first, cases/<case>/ with a marker
/// each, results.csv and, if there are controllers to compare, report.html last. What was done by
/// the same program with the same inputs stays. The table goes to the folder also when the
/// campaign is interrupted. True if every case is done. Throws lac::Error, also if the folder holds
/// the results of another study; no case's failure is one.
bool run_campaign(const CampaignOptions& options, std::ostream& out);

}  // namespace lac::sim
