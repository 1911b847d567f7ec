// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/optimize_command.hpp"

#include <ostream>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/cli/written_table.hpp"
#include "sim_harness/design/optimize_report.hpp"

namespace lac::sim {
namespace {

std::string head_of(const DesignCase& d, const OptimizedLidar& o) {
  return "Beams and gates of lac optimize " + d.file.filename().string() + ": k0.5 " +
         shortest(o.figures.k05_radpm) + " rad/m at " + shortest(d.optimize->wind_speed_mps) +
         " m/s.\n" + describe_turbulence(d.turbulence);
}

}  // namespace

void optimize_command(const DesignOptions& o, std::ostream& out) {
  const DesignCase design = load_design(o.file, o.overrides);
  if (!design.optimize) {
    throw Error(design.file.string() +
                ": optimize: missing, expected what is free and what must hold (docs/design.md)");
  }
  const std::filesystem::path folder =
      o.output_folder.empty() ? design.output_folder : o.output_folder;
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) throw Error(folder.string() + ": cannot be made: " + failed.message());
  const std::vector<OptimizedLidar> found = optimize_lidar(design, *design.optimize);
  const LayoutJudge judge(design, *design.optimize);
  out << optimize_table(design, found, judge.figures(design.lidar).k05_radpm);
  const OptimizedLidar& best = best_of(found);
  write_table(folder / "map.csv", map_csv(found), out);
  write_table(folder / "map.html", map_page(design, found), out);
  write_table(folder / "lidar.yaml",
              lidar_file(with_layout(design.lidar, best.best), head_of(design, best)), out);
}

}  // namespace lac::sim
