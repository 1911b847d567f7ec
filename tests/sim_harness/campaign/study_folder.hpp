// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <sstream>
#include <string>

#include "sim_harness/campaign/campaign.hpp"
#include "support/temp_folder.hpp"

namespace lac::test {

/// A folder with a case of 20 s in steady wind, flown by the toy that ends as it is told, and room
/// for studies of it.
class StudyFolder {
 public:
  StudyFolder() {
    for (const char* how : {"fly", "crash", "exit", "hang", "fail"})
      folder.write(std::string(how) + ".in", how);
    folder.write("case.yaml",
                 "turbine: " LAC_SOURCE_DIR
                 "/config/turbines/nrel5mw/turbine.yaml\n"
                 "time: {duration_s: 20, run_in_s: 5}\n"
                 "wind: {kind: steady, speed_mps: 18}\n"
                 "outputs: {csv: no, html: no}\n"
                 "controllers:\n"
                 "  - {name: toy, input: fly.in, library: " LAC_TOY_DIR "/libtoy_end}\n");
  }

  /// A study of these lines behind its first one, `case: case.yaml`.
  std::filesystem::path study(const std::string& lines) const {
    return folder.write("study.yaml", "case: case.yaml\n" + lines);
  }

  /// Flies study.yaml into the folder `results` here; true if all is done.
  bool fly(sim::CampaignOptions options = {}) {
    options.study = folder.path("study.yaml");
    if (options.output.empty()) options.output = folder.path("results");
    said.str("");
    return sim::run_campaign(options, said);
  }
  bool fly(int jobs) {
    sim::CampaignOptions options;
    options.jobs = jobs;
    return fly(options);
  }

  std::string table() const { return folder.read("results/results.csv"); }

  TempFolder folder;
  std::ostringstream said;
};

}  // namespace lac::test
