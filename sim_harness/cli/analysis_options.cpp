// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/analysis_options.hpp"

#include <map>
#include <ostream>

#include "sim_harness/cli/option_effect.hpp"

namespace lac::sim {
namespace {

const std::map<std::string, ReferenceCycles> kReferences{
    {word_of(ReferenceCycles::kOneHertz), ReferenceCycles::kOneHertz},
    {word_of(ReferenceCycles::kTwoMillionInTwentyYears),
     ReferenceCycles::kTwoMillionInTwentyYears}};
const std::map<std::string, RainflowRule> kRules{
    {word_of(RainflowRule::kAstm), RainflowRule::kAstm},
    {word_of(RainflowRule::kFourPoint), RainflowRule::kFourPoint}};
/// An option with a word for each value of an enumeration.
template <class Value>
void add_choice(CLI::App& command, const std::string& name, Value& value,
                const std::map<std::string, Value>& words, const std::string& description) {
  std::string choices;
  for (const auto& [word, meaning] : words) choices += (choices.empty() ? "" : ", ") + word;
  command
      .add_option_function<std::string>(
          name, [&value, &words](const std::string& word) { value = words.at(word); },
          description + ": " + choices)
      ->check(CLI::IsMember(words));
}

void add_figure_options(CLI::App& command, FigureOptions& o) {
  command.add_option("--from", o.from_s, "Leave out what is before this time [s]");
  command.add_option("--to", o.to_s, "Leave out what is from this time on [s]");
  command.add_option("--woehler", o.woehler_exponents, "Exponents m of the loads (4,10)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::PositiveNumber);
  add_choice(command, "--reference", o.reference, kReferences, "Cycles the loads refer to (1hz)");
  add_choice(command, "--rainflow", o.counting, kRules, "How cycles are counted (astm)");
}

void add_quantities(CLI::App& command, std::vector<std::string>& names) {
  command.add_option("--quantities", names, "Columns, e.g. TwrBsMyt_del4 (the usual ones)")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void add_run_options(CLI::App& command, RunTableOptions& o) {
  command.add_option("--column", o.controller_column, "That tells the controllers apart")
      ->capture_default_str();
  command.add_option("--pair-by", o.pair_by, "Columns that tell the winds apart (all parameters)")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--where", o.where, "Only rows with this value, e.g. stability=neutral")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--wind", o.wind_column, "Column of the mean wind speed (mean_speed_mps)");
  command.add_option("--bin", o.bin_mps, "Width of bins of a measured wind speed [m/s]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
}

void add_life_options(CLI::App& command, WindDistribution& wind) {
  command
      .add_option_function<std::string>(
          "--iec-class",
          [&wind](const std::string& word) {
            wind = WindDistribution::rayleigh(word == "I" ? 10.0 : word == "II" ? 8.5 : 7.5);
          },
          "Winds of a life: Rayleigh with the mean of the class (I)")
      ->check(CLI::IsMember({"I", "II", "III"}));
  command
      .add_option_function<std::vector<double>>(
          "--weibull",
          [&wind](const std::vector<double>& v) {
            wind = {v[0], v[1]};
          },
          "Winds of a life: SCALE [m/s] and SHAPE")
      ->expected(2)
      ->check(CLI::PositiveNumber)
      ->excludes("--iec-class");
}

void add_correlate_input(CLI::App& command, CorrelateInput& o) {
  command.add_option("files", o.files, "Time series of the same time")->required();
  command.add_option("--wind", o.winds, "Wind speeds measured up-wind")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->required();
  command.add_option("--load", o.load, "What follows them")->required();
  CLI::Option* inertia =
      command
          .add_option("--inertia", o.torque.inertia_kgm2,
                      "Of the drive train about the slow shaft [kg m^2]: the load is a generator "
                      "torque, taken to the rotor")
          ->check(CLI::PositiveNumber);
  command.add_option("--gear-ratio", o.torque.gear_ratio, "Generator speed over rotor speed")
      ->check(CLI::PositiveNumber)
      ->needs(inertia);
  command.add_option("--rotor-speed", o.torque.rotor_speed, "Channel with it")
      ->capture_default_str()
      ->needs(inertia);
  command.add_option("--power", o.power, "Tells the mode")->capture_default_str();
  command.add_option("--pitch", o.pitch, "Tells the mode")->capture_default_str();
  command.add_option("--from", o.from_s, "Leave out what is before this time [s]");
  command.add_option("--rate", o.rate_hz, "All series are averaged down to it [Hz]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--min", o.wind_rule.min, "Least wind speed that counts [m/s]");
  command.add_option("--max", o.wind_rule.max, "Greatest wind speed that counts [m/s]");
  command.add_option("--stuck", o.wind_rule.stuck_s, "Equal wind speeds over longer than this [s]")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--fill", o.wind_rule.fill_s, "Gaps up to this are filled linearly [s]")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--cnr", o.companion, "Channel that must be between the next two");
  command.add_option("--cnr-min", o.companion_min, "")->capture_default_str();
  command.add_option("--cnr-max", o.companion_max, "")->capture_default_str();
}

void add_correlate_options(CLI::App& command, CorrelateOptions& o) {
  command.add_option("--ranges", o.ranges_m, "Distance of each wind speed [m]")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--window", o.window.length_s, "Of correlation and delay [s]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--overlap", o.window.overlap, "Of the windows")->capture_default_str();
  command.add_option("--min-delay", o.lags.min_s, "Least delay looked at [s]");
  command.add_option("--max-delay", o.lags.max_s, "Greatest [s]")->capture_default_str();
  command.add_flag_callback(
      "--either-sign", [&o] { o.lags.sign = PeakSign::kEither; },
      "Peak of the magnitude: loads that fall when the wind rises");
  command.add_option("--rated-power", o.rule.rated_power, "(the largest there is)")
      ->check(CLI::PositiveNumber);
  command.add_option("--fine-pitch", o.rule.fine_pitch, "Above rated is a degree more [deg]");
  command.add_option("--ti", o.intensity_limit, "Between two classes of turbulence intensity")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--availability", o.least_availability, "Least share of good wind speeds")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1.0));
  command.add_option("--block", o.block_s, "Of the coherence [s]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--csv", o.csv, "Table of all windows to write");
  command.add_option("--spectra", o.spectra, "Table of spectra and coherence with bands to write");
}

}  // namespace

AnalysisOptions::AnalysisOptions(CLI::App& app)
    : stats_(app.add_subcommand("stats", "Figures of results: means, extremes, loads, energy")),
      life_(app.add_subcommand("life", "A controller at each wind speed and over a life")),
      compare_(app.add_subcommand("compare", "Two controllers on the same winds: what differs")),
      report_(app.add_subcommand("report", "One page with the results of a campaign")),
      correlate_(app.add_subcommand(
          "correlate", "Wind measured up-wind and a load: correlation, delay, coherence")) {
  stats_->add_option("files", stats_options_.inputs, ".outb, .out, .csv, or folders of them")
      ->required();
  stats_->add_option("--channels", stats_options_.channels, "Only these")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_figure_options(*stats_, stats_options_.figures);
  stats_->add_flag_callback(
      "--missing-rows", [this] { stats_options_.missing_rows = MissingRows::kNotNumbers; },
      "Take rows that are missing for gaps");
  stats_->add_option("--csv", stats_options_.csv, "Table to write, one row per file");

  life_->add_option("input", life_options_.input, "A table (.csv) or a folder of results")
      ->required();
  life_->add_option("--controller", life_options_.controller, "Of a table");
  add_quantities(*life_, life_options_.quantities);
  add_run_options(*life_, life_options_.runs);
  add_life_options(*life_, life_options_.wind);
  add_figure_options(*life_, life_options_.figures);

  compare_
      ->add_option("inputs", compare_options_.inputs,
                   "One table (.csv) with two controllers, two tables, or two folders of results")
      ->required()
      ->expected(1, 2);
  compare_->add_option("--baseline", compare_options_.baseline, "Controller A");
  compare_->add_option("--against", compare_options_.against, "Controller B");
  add_quantities(*compare_, compare_options_.comparison.quantities);
  compare_->add_option("--confidence", compare_options_.comparison.confidence, "Of the intervals")
      ->capture_default_str()
      ->check(CLI::Range(0.5, 0.9999));
  add_run_options(*compare_, compare_options_.runs);
  add_life_options(*compare_, compare_options_.comparison.wind);
  add_figure_options(*compare_, compare_options_.figures);
  compare_->add_option("--csv", compare_options_.csv, "Table to write");

  report_
      ->add_option("inputs", report_options_.report.inputs,
                   "Folder of a campaign, or a table (.csv); several tables: a controller each")
      ->required();
  report_->add_option("-o,--output", report_options_.output, "Page to write (beside the table)");
  report_->add_option("--title", report_options_.report.title, "Of the page (name of the folder)");
  report_->add_option("--baseline", report_options_.report.baseline,
                      "Controller that the others are compared with (the first)");
  add_quantities(*report_, report_options_.report.quantities);
  report_->add_option("--confidence", report_options_.report.confidence, "Of the intervals")
      ->capture_default_str()
      ->check(CLI::Range(0.5, 0.9999));
  add_run_options(*report_, report_options_.report.runs);
  add_life_options(*report_, report_options_.report.wind);

  add_correlate_input(*correlate_, correlate_options_.input);
  add_correlate_options(*correlate_, correlate_options_);
}

void AnalysisOptions::run(std::ostream& out) const {
  if (stats_->parsed()) stats_command(stats_options_, out);
  if (life_->parsed()) {
    require_effect(*life_, {life_options_.input});
    require_table(*life_, "--controller", life_options_.input);
    life_command(life_options_, out);
  }
  if (compare_->parsed()) {
    require_effect(*compare_, compare_options_.inputs);
    require_table(*compare_, "--baseline", compare_options_.inputs.front());
    require_table(*compare_, "--against", compare_options_.inputs.back());
    compare_command(compare_options_, out);
  }
  if (report_->parsed()) report_command(report_options_, out);
  if (correlate_->parsed()) correlate_command(correlate_options_, out);
}

}  // namespace lac::sim
