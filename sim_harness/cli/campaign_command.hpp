// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <iosfwd>

#include "sim_harness/campaign/campaign.hpp"

namespace lac::sim {

/// The command line of `lac campaign`.
class CampaignCommand {
 public:
  /// Adds the command; this must outlive the parsing.
  explicit CampaignCommand(CLI::App& app);

  bool parsed() const { return command_->parsed(); }
  /// Returns the exit code: 1 if a case is not done. Throws lac::Error.
  int run(std::ostream& out);

 private:
  CLI::App* command_;
  CampaignOptions options_;
  std::string only_;
};

}  // namespace lac::sim
