// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/design_command.hpp"

#include <fstream>
#include <ostream>
#include <sstream>

#include "core/error.hpp"
#include "core/part_file.hpp"
#include "sim_harness/design/design_page.hpp"
#include "sim_harness/design/quadrature_check.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr double kLargestError = 5e-3;  // of the gain, by the quadrature

std::string text_of_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw Error(path.string() + ": cannot be read");
  return text.str();
}

/// The template may hold what somebody tuned by hand.
void require_other_file(const fs::path& path, const fs::path& ffp_template) {
  std::error_code ignored;
  if (!fs::equivalent(path, ffp_template, ignored)) return;
  throw Error(path.string() +
              ": is the template of the design and is not written over; give "
              "another folder (--output)");
}

void write(const fs::path& path, const std::string& text, std::ostream& out) {
  PartFile file(path);
  file.write(text.data(), text.size());
  file.commit();
  out << "wrote " << path.string() << '\n';
}

}  // namespace

void design_command(const DesignOptions& o, std::ostream& out) {
  const DesignCase design = load_design(o.file, o.overrides);
  const LidarVolumes lidar = lidar_volumes(design.lidar, design.volumes);
  const CorrelationCurves curves(*make_correlation(design, lidar), design.speeds_mps,
                                 design.curves);
  std::vector<FeedforwardPoint> points =
      design_feedforward(curves, lidar, design.rule, design.timing);
  const double error = quadrature_error(design, points);
  if (error > kLargestError) {
    throw Error(design.file.string() + ": |G_RL| at the cut-off moves by " + shortest(error) +
                " with finer steps; raise quadrature_nodes, or range_points");
  }
  const DesignResult result{design, lidar, curves, std::move(points), error};
  out << design_table(result);
  const fs::path folder = o.output_folder.empty() ? design.output_folder : o.output_folder;
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw Error(folder.string() + ": cannot be made: " + failed.message());
  require_other_file(folder / "ffp.IN", design.ffp_template);
  write(folder / "ffp.IN", designed_ffp_input(text_of_file(design.ffp_template), result), out);
  write(folder / "schedule.csv", schedule_csv(result), out);
  write(folder / "curves.csv", curves_csv(result), out);
  write(folder / "design.html", html_report(design_page(result)), out);
}

}  // namespace lac::sim
