// SPDX-License-Identifier: Apache-2.0
// The program lac: reads the command line and hands over.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "core/suggest.hpp"
#include "sim_harness/cli/analysis_options.hpp"
#include "sim_harness/cli/campaign_command.hpp"
#include "sim_harness/cli/commands.hpp"
#include "sim_harness/cli/design_command.hpp"
#include "sim_harness/cli/migrate_command.hpp"
#include "sim_harness/cli/optimize_command.hpp"
#include "sim_harness/cli/tune_command.hpp"
#include "sim_harness/cli/wind_options.hpp"

namespace {

constexpr int kFailed = 1;

/// Every word that could stand at this place of the command line.
std::vector<std::string> known_words(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  for (const CLI::App* command : app.get_subcommands({})) words.push_back(command->get_name());
  return words;
}

/// "unknown option '--outptu' (did you mean '--output'?)", or the parser's own words.
std::string explain(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* at = &app;
  std::string place = "lac";
  while (!at->get_subcommands().empty()) {
    at = at->get_subcommands().front();
    place += " " + at->get_name();
  }
  const std::string hint = "; '" + place + " --help' lists what there is";
  const std::vector<std::string> extras = app.remaining(true);
  if (extras.empty()) return std::string(error.what()) + hint;
  const std::string word = extras.front().substr(0, extras.front().find('='));
  const bool command_wanted = !at->get_subcommands({}).empty();
  const std::string what = word.starts_with('-') ? "option" : command_wanted ? "command" : "word";
  return "unknown " + what + " '" + word + "'" + lac::did_you_mean(word, known_words(*at)) + hint;
}

int fail(const std::string& text) {
  std::cerr << "lac: " << text << '\n';
  return kFailed;
}

int run_program(int argc, char** argv) {
  CLI::App app("LAC Chain: flies wind-turbine controllers with a simulated turbine and lidar");
  app.name("lac");
  app.require_subcommand(0, 1);
  bool version = false;
  app.add_flag("--version", version, "Version, build, libraries and record layouts");

  lac::sim::RunOptions run;
  CLI::App* run_command = app.add_subcommand("run", "Fly all controllers of a case file");
  run_command->add_option("case", run.case_file, "Case file (YAML)")->required();
  run_command->add_option("--set", run.overrides, "Replace a value, e.g. time.duration_s=120")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* run_output =
      run_command->add_option("--output", run.output_folder, "Folder for the results");
  run_command->add_flag("--mark", run.mark, "Leave a file done or failed there, as in a campaign")
      ->needs(run_output);

  std::string wrapper_input;
  CLI::App* check_command = app.add_subcommand(
      "check", "Try a chain: load and call it, show who reads and writes each record");
  check_command->add_option("input", wrapper_input, "Input file of the master")->required();

  std::string trace_file;
  CLI::App* trace_command =
      app.add_subcommand("trace", "Show what a host sends, from a file of the host probe");
  trace_command->add_option("file", trace_file, "Trace (.lactrace)")->required();

  lac::sim::MigrateOptions migrate;
  CLI::App* migrate_command =
      app.add_subcommand("migrate", "Turn an input file of Guo's chain into one of our own form");
  migrate_command->add_option("file", migrate.file, "Its WRAPPER.IN, LDP or FFP file")->required();
  migrate_command->add_option("-o,--output", migrate.output, "File to write; without it, printed");
  migrate_command->add_flag("--force", migrate.force, "Replace a file that is there already");

  lac::sim::CampaignCommand campaign(app);
  lac::sim::TuneCommand tune(app);
  lac::sim::WindOptions wind(app);
  lac::sim::AnalysisOptions analysis(app);

  lac::sim::DesignOptions design;
  CLI::App* design_command = app.add_subcommand(
      "design", "Compute the feedforward's low-pass and buffer from turbulence, rotor and lidar");
  design_command->add_option("file", design.file, "Design file (YAML)")->required();
  design_command->add_option("--set", design.overrides, "Replace a value, e.g. yaw_error_deg=10")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  design_command->add_option("-o,--output", design.output_folder, "Folder for the results");

  design_command->add_flag("--fit", design.fit,
                           "Print the Kaimal model closest to the Mann tensor, and nothing else");

  lac::sim::DesignOptions optimize;
  CLI::App* optimize_command = app.add_subcommand(
      "optimize", "Find the beams and gates with which a lidar sees most of what the rotor feels");
  optimize_command->add_option("file", optimize.file, "Design file (YAML)")->required();
  optimize_command
      ->add_option("--set", optimize.overrides, "Replace a value, e.g. optimize.grid=11")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  optimize_command->add_option("-o,--output", optimize.output_folder, "Folder for the results");

  CLI::App* records_command = app.add_subcommand("records", "Print the map of records");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return 0;
  } catch (const CLI::ParseError& e) {
    return fail(explain(app, e));
  }
  if (version) return lac::sim::print_version(std::cout), 0;
  if (run_command->parsed()) return lac::sim::run_command(run, std::cout), 0;
  if (check_command->parsed()) return lac::sim::check_command(wrapper_input, std::cout), 0;
  if (trace_command->parsed()) return lac::sim::trace_command(trace_file, std::cout), 0;
  if (migrate_command->parsed()) return lac::sim::migrate_command(migrate, std::cout), 0;
  if (campaign.parsed()) return campaign.run(std::cout);
  if (tune.parsed()) return tune.run(std::cout);
  if (wind.parsed()) return wind.run(std::cout);
  if (analysis.parsed()) return analysis.run(std::cout), 0;
  if (design.fit) return lac::sim::fit_command(design, std::cout), 0;
  if (design_command->parsed()) return lac::sim::design_command(design, std::cout), 0;
  if (optimize_command->parsed()) return lac::sim::optimize_command(optimize, std::cout), 0;
  if (records_command->parsed()) return lac::sim::print_records(std::cout), 0;
  std::cout << app.help();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const std::bad_alloc&) {
    return fail("not enough memory");
  } catch (const std::exception& e) {
    return fail(e.what());
  }
}
