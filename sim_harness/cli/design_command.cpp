// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/design_command.hpp"

#include <ostream>

#include "core/error.hpp"
#include "core/part_file.hpp"
#include "sim_harness/config/input_text.hpp"
#include "sim_harness/design/design_page.hpp"
#include "sim_harness/design/flown_lidar_report.hpp"
#include "sim_harness/design/quadrature_check.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr auto kTemplate = "the template of the design";
constexpr double kLargestError = 5e-3;  // of the gain, by the quadrature

void write(const fs::path& path, const std::string& text, std::ostream& out) {
  write_whole_file(path, text);
  out << "wrote " << path.string() << '\n';
}

void predict(DesignResult& r) {
  const DesignCase& d = r.design;
  if (d.flown_lidar) r.flown = flown_lidar(*d.flown_lidar);
  if (d.designs_pitch_curve) r.pitch_curve = static_pitch_curve(*d.turbine);
  if (!d.feedback) return;
  r.closed_loop = predict_closed_loop(
      d, r.curves, r.points, r.pitch_curve ? r.pitch_curve->pitch_rad : d.ffp.static_pitch_rad);
}

std::string ffp_input(const DesignResult& r) {
  const DesignCase& d = r.design;
  const std::string text = designed_ffp_input(text_of_file(d.ffp_template), r);
  return r.pitch_curve ? with_pitch_curve(text, *d.turbine, *r.pitch_curve) : text;
}

void write_inputs(const fs::path& folder, const DesignResult& r, std::ostream& out) {
  const DesignCase& d = r.design;
  require_other_file(folder / "ffp.IN", d.ffp_template, kTemplate);
  if (d.feedback) require_other_file(folder / "feedback.IN", d.feedback->file, kTemplate);
  write(folder / "ffp.IN", ffp_input(r), out);
  if (!d.feedback) return;
  write(folder / "feedback.IN",
        designed_feedback_input(text_of_file(d.feedback->file), *d.feedback, *d.turbine), out);
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
  const fs::path folder = o.output_folder.empty() ? design.output_folder : o.output_folder;
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw Error(folder.string() + ": cannot be made: " + failed.message());
  DesignResult result{design, lidar, curves, std::move(points), error};
  predict(result);
  out << design_table(result);
  if (!result.flown.empty()) {
    out << '\n' << flown_lidar_table(compare_flown_lidar(design, lidar, curves, result.flown));
  }
  if (result.closed_loop) {
    out << '\n' << closed_loop_table(*result.closed_loop);
    out << flown_table(*result.closed_loop, design);
  }
  write_inputs(folder, result, out);
  write(folder / "schedule.csv", schedule_csv(result), out);
  write(folder / "curves.csv", curves_csv(result), out);
  if (!result.flown.empty())
    write(folder / "flown_coherence.csv", flown_coherence_csv(curves, result.flown), out);
  if (result.closed_loop) {
    write(folder / "closed_loop.csv", closed_loop_csv(*result.closed_loop), out);
    write(folder / "rotor_speed.csv", rotor_speed_csv(*result.closed_loop), out);
  }
  write(folder / "design.html", html_report(design_page(result)), out);
}

}  // namespace lac::sim
