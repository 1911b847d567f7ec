// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/input_file.hpp"
#include "core/units.hpp"
#include "sim_harness/design/closed_loop.hpp"
#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/csv_table.hpp"

namespace lac::sim {
namespace {

constexpr double kBandEdges_hz[] = {0.005, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32};

double rpm2(double variance_radps2) {
  return variance_radps2 * rpm_from_radps(1.0) * rpm_from_radps(1.0);
}

double variance(const Spectrum& s, double from_hz, double to_hz) {
  double sum = 0.0;
  const double step_hz = s.frequency_hz[1] - s.frequency_hz[0];
  for (std::size_t i = 1; i < s.frequency_hz.size(); ++i) {
    const double low = std::max(from_hz, s.frequency_hz[i] - 0.5 * step_hz);
    const double high = std::min(to_hz, s.frequency_hz[i] + 0.5 * step_hz);
    sum += std::max(high - low, 0.0) * s.density[i];
  }
  return sum;
}

void add_rows(TextTable& table, const RotorSpeedPrediction& p, const FlownRuns& runs,
              const FeedforwardTuning& tuning) {
  const Spectrum alone = flown_rotor_speed(runs.feedback_only, runs.run_in_s);
  const Spectrum with = flown_rotor_speed(runs.assisted, runs.run_in_s);
  const std::vector<double> model_alone = p.feedback_only();
  const std::vector<double> model_with = p.assisted(tuning);
  const auto row = [&](const std::string& band, double from_hz, double to_hz) {
    const double a = p.variance(model_alone, from_hz, to_hz), b = variance(alone, from_hz, to_hz);
    const double c = p.variance(model_with, from_hz, to_hz), d = variance(with, from_hz, to_hz);
    table.add_row({format_value(runs.mean_speed_mps, 1), band, format_value(rpm2(a), 5),
                   format_value(rpm2(b), 5), format_value(rpm2(c), 5), format_value(rpm2(d), 5),
                   format_change(std::sqrt(c / a) - 1.0), format_change(std::sqrt(d / b) - 1.0)});
  };
  for (std::size_t i = 1; i < std::size(kBandEdges_hz); ++i) {
    const double from_hz = kBandEdges_hz[i - 1], to_hz = kBandEdges_hz[i];
    row(format_value(from_hz, 3) + " to " + format_value(to_hz, 3), from_hz, to_hz);
  }
  row("together", std::begin(kBandEdges_hz)[0], std::end(kBandEdges_hz)[-1]);
}

}  // namespace

std::string closed_loop_table(const ClosedLoop& loop) {
  TextTable table({"wind [m/s]", "std fb [rpm]", "designed", "limit", "1 s late", "1 s early",
                   "cut-off /2", "cut-off x2", "best trim [s]", "with it", "template", "why",
                   "above threshold"});
  for (const ClosedLoopPoint& p : loop.points) {
    const auto change = [&](double std_radps) {
      return format_change(std_radps / p.feedback_only - 1.0);
    };
    table.add_row({format_value(p.mean_speed_mps, 1),
                   format_value(rpm_from_radps(p.feedback_only), 3), change(p.assisted),
                   change(p.least), change(p.late), change(p.early), change(p.half_cutoff),
                   change(p.twice_cutoff), format_value(p.best_trim_s, 2), change(p.with_best_trim),
                   change(p.with_template), p.template_verdict,
                   std::isnan(p.share_above_threshold)
                       ? "n/a"
                       : format_value(100.0 * p.share_above_threshold, 0) + " %"});
  }
  return "predicted standard deviation of the rotor speed, against feedback only:\n" + table.text();
}

std::string closed_loop_csv(const ClosedLoop& loop) {
  std::string text =
      csv_line({"mean_speed [m/s]", "feedback_only [rpm]", "designed [rpm]", "limit [rpm]",
                "late_1s [rpm]", "early_1s [rpm]", "half_cutoff [rpm]", "twice_cutoff [rpm]",
                "best_trim [s]", "with_best_trim [rpm]", "template_cutoff [Hz]", "template [rpm]",
                "template_verdict", "above_threshold [-]"});
  for (const ClosedLoopPoint& p : loop.points) {
    const auto rpm = [](double std_radps) { return csv_number(rpm_from_radps(std_radps)); };
    text += csv_line({csv_number(p.mean_speed_mps), rpm(p.feedback_only), rpm(p.assisted),
                      rpm(p.least), rpm(p.late), rpm(p.early), rpm(p.half_cutoff),
                      rpm(p.twice_cutoff), csv_number(p.best_trim_s), rpm(p.with_best_trim),
                      csv_number(p.of_template.low_pass.frequency_hz), rpm(p.with_template),
                      p.template_verdict, csv_number(p.share_above_threshold)});
  }
  return text;
}

std::string rotor_speed_csv(const ClosedLoop& loop) {
  std::string text = csv_line({"mean_speed [m/s]", "frequency [Hz]", "feedback_only [rpm^2/Hz]",
                               "designed [rpm^2/Hz]", "limit [rpm^2/Hz]"});
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const RotorSpeedPrediction& p = loop.predictions[i];
    const std::vector<double> alone = p.feedback_only(), with = p.assisted(loop.points[i].designed);
    const std::vector<double> least = p.least();
    for (std::size_t j = 0; j < alone.size(); ++j) {
      text += csv_line({csv_number(loop.points[i].mean_speed_mps), csv_number(p.frequency_hz()[j]),
                        csv_number(rpm2(alone[j])), csv_number(rpm2(with[j])),
                        csv_number(rpm2(least[j]))});
    }
  }
  return text;
}

std::string flown_table(const ClosedLoop& loop, const DesignCase& design) {
  if (design.flown.empty()) return {};
  TextTable table({"wind [m/s]", "band [Hz]", "fb predicted [rpm^2]", "flown", "lac predicted",
                   "flown", "std predicted", "flown"});
  std::string notes;
  for (const FlownRuns& runs : design.flown) {
    const auto at =
        std::ranges::find(loop.points, runs.mean_speed_mps, &ClosedLoopPoint::mean_speed_mps);
    if (at == loop.points.end()) {
      notes += "not compared: the runs flown at " + shortest(runs.mean_speed_mps) +
               " m/s, for which the closed loop is not predicted (near or below rated, or no gate "
               "leads enough)\n";
      continue;
    }
    const auto i = static_cast<std::size_t>(at - loop.points.begin());
    add_rows(table, loop.predictions[i], runs, runs.designed ? at->designed : at->of_template);
  }
  return "variance of the rotor speed by band, predicted beside flown:\n" + table.text() + notes;
}

}  // namespace lac::sim
