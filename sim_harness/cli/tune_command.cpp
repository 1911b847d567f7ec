// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/tune_command.hpp"

namespace lac::sim {

TuneCommand::TuneCommand(CLI::App& app)
    : command_(
          app.add_subcommand("tune", "Find the best values of a controller's keys by flying")) {
  TuningOptions& o = options_;
  command_->add_option("file", o.file, "Tuning file (YAML)")->required();
  command_->add_option("--set", o.overrides, "Replace a value of the case, e.g. time.step_s=0.05")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command_->add_option("-o,--output", o.output_folder, "Folder for the results");
  command_->add_option("--jobs", o.jobs, "Flights at a time; without it, one per core")
      ->check(CLI::PositiveNumber);
}

int TuneCommand::run(std::ostream& out) {
  return run_tuning(options_, out) ? 0 : 1;
}

}  // namespace lac::sim
