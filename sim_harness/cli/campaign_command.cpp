// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/campaign_command.hpp"

namespace lac::sim {

CampaignCommand::CampaignCommand(CLI::App& app)
    : command_(app.add_subcommand("campaign", "Fly all cases of a study file, over all cores")) {
  CampaignOptions& o = options_;
  command_->add_option("study", o.study, "Study file (YAML)")->required();
  command_->add_option("--jobs", o.jobs, "Cases at a time; without it, one per core")
      ->check(CLI::PositiveNumber);
  command_->add_option("--output", o.output, "Folder for the results");
  command_->add_option("--only", only_, "failed: fly what has failed before, and nothing else")
      ->check(CLI::IsMember({"failed"}));
  command_->add_flag("--list", o.list, "Only show every case with its state");
  command_->add_flag("!--no-report", o.report, "Leave out the page with the comparison");
  command_->add_flag("--dry-run", o.dry_run, "Only show what would be flown, a command a line");
}

int CampaignCommand::run(std::ostream& out) {
  options_.only_failed = !only_.empty();
  return run_campaign(options_, out) ? 0 : 1;
}

}  // namespace lac::sim
