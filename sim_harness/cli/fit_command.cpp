// SPDX-License-Identifier: Apache-2.0
#include <ostream>

#include "core/error.hpp"
#include "sim_harness/cli/design_command.hpp"
#include "sim_harness/design/design_case.hpp"
#include "sim_harness/design/turbulence_fit.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {

void fit_command(const DesignOptions& o, std::ostream& out) {
  const DesignCase design = load_design(o.file, o.overrides);
  const auto* mann = std::get_if<MannParams>(&design.turbulence);
  if (!mann) {
    throw Error(design.file.string() +
                ": turbulence.kind: found kaimal, expected mann: there is nothing to fit");
  }
  const KaimalTurbulence k = fit_kaimal(*mann);
  out << "fitted to: " << describe_turbulence(design.turbulence) << '\n';
  TextTable components({"component", "sigma [m/s]", "length scale [m]"});
  const KaimalModel& m = k.model;
  const auto add = [&](const char* name, const KaimalComponent& c) {
    components.add_row(
        {name, format_significant(c.sigma_mps, 4), format_significant(c.length_scale_m, 4)});
  };
  add("u", m.u), add("v", m.v), add("w", m.w);
  out << components.text() << "coherence across: decay " << format_significant(m.coherence_decay, 4)
      << ", length " << format_significant(m.coherence_length_m, 4) << " m\n"
      << "squared coherence along: a_x " << format_significant(k.evolution.decay, 4) << ", b_x "
      << k.evolution.offset_per_m << " 1/m\n";
}

}  // namespace lac::sim
