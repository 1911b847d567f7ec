// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "support/temp_folder.hpp"

namespace lac::test {

/// A complete case in a folder of its own: NREL 5 MW in steady wind, flown twice by the probe
/// controller with constant demands.
class ProbeCase {
 public:
  ProbeCase() {
    folder.write("probe.in", "quiet 1\npitch_rad 0.26\ntorque_Nm 43000\n");
    folder.write("other.in", "quiet 1\npitch_rad 0.27\ntorque_Nm 43000\n");
  }

  /// The case file with one text in it replaced.
  std::string file(const std::string& from = {}, const std::string& to = {}) const {
    std::string text = "turbine: " LAC_SOURCE_DIR
                       "/config/turbines/nrel5mw/turbine.yaml\n"
                       "time:\n"
                       "  duration_s: 20\n"
                       "  run_in_s: 5\n"
                       "wind:\n"
                       "  kind: steady\n"
                       "  speed_mps: 18\n"
                       "controllers:\n"
                       "  - name: first\n"
                       "    input: probe.in\n"
                       "    library: " LAC_TOY_DIR
                       "/libtoy_recorder\n"
                       "  - {name: second, input: other.in, library: " LAC_TOY_DIR
                       "/libtoy_recorder}\n"
                       "outputs:\n"
                       "  folder: results\n";
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    return folder.write("case.yaml", text);
  }

  TempFolder folder;
};

}  // namespace lac::test
