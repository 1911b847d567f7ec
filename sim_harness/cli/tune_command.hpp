// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <iosfwd>

#include "sim_harness/tuning/tuning.hpp"

namespace lac::sim {

/// The command line of `lac tune`.
class TuneCommand {
 public:
  /// Adds the command; this must outlive the parsing.
  explicit TuneCommand(CLI::App& app);

  bool parsed() const { return command_->parsed(); }
  /// Returns the exit code: 1 if no parameters meet the conditions. Throws lac::Error.
  int run(std::ostream& out);

 private:
  CLI::App* command_;
  TuningOptions options_;
};

}  // namespace lac::sim
