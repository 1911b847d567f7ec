// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/fingerprint.hpp"
#include "sim_harness/campaign/marked_case.hpp"
#include "sim_harness/cli/commands.hpp"
#include "sim_harness/run/run_case.hpp"

namespace lac::sim {

void run_command(const RunOptions& options, std::ostream& out) {
  if (options.mark) {
    const std::string fingerprint = Fingerprints().of_case(options.case_file, options.overrides);
    fly_marked({options.case_file, options.overrides, options.output_folder}, fingerprint, nullptr,
               out);
    return;
  }
  Case c = load_case(options.case_file, options.overrides);
  if (!options.output_folder.empty()) c.outputs.folder = options.output_folder;
  run_case(c, out);
}

}  // namespace lac::sim
