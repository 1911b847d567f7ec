// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/wind_options.hpp"

#include <ostream>

namespace lac::sim {
namespace {

void add_file_options(CLI::App& command, WindFileOptions& o) {
  command.add_option("--set", o.overrides, "Replace a value of a case file, e.g. seed=3")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--hub-height", o.hub_height_m, "Of boxes and uniform wind files [m]");
  command.add_option("--rotor-diameter", o.rotor_diameter_m, "Of the rotor [m]");
  command.add_option("--points", o.points, "Of a box: along x, y, z")->expected(3);
  command.add_option("--spacing", o.spacing_m, "Of a box: along x, y, z [m]")->expected(3);
  command.add_option("--mean-speed", o.mean_speed_mps, "Of a box [m/s]");
  command.add_flag_callback(
      "--last-plane-first", [&o] { o.box_order.first_plane_first = false; },
      "Box with x down-wind: its last plane meets the rotor first");
  command.add_flag_callback(
      "--rows-from-right", [&o] { o.box_order.rows_from_left = false; },
      "Box with y to the left, looking down-wind");
}

void add_convert_options(CLI::App& command, WindConvertOptions& o) {
  add_file_options(command, o.file);
  command
      .add_option_function<std::vector<double>>(
          "--grid",
          [&o](const std::vector<double>& v) {
            o.sampling.points_across = static_cast<int>(v[0]);
            o.sampling.points_up = static_cast<int>(v[1]);
            o.sampling.width_m = v[2];
            o.sampling.height_m = v[3];
          },
          "Sample on NY x NZ points, WIDTH x HEIGHT [m] about the hub")
      ->expected(4);
  command.add_option("--duration", o.sampling.duration_s, "Of what is sampled [s]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--time-step", o.sampling.time_step_s, "Of what is sampled [s]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
}

void add_theory_options(CLI::App& command, WindCheckOptions& o) {
  command.add_option("--theory-case", o.theory_case, "Case file whose wind section is the theory");
  command.add_option("--theory", o.theory, "kaimal or mann, with the numbers below")
      ->check(CLI::IsMember({"kaimal", "mann"}));
  command.add_option("--sigma-u", o.sigma_u_mps, "Standard deviation of u [m/s]");
  command.add_flag("--lateral-as-u", o.lateral_as_u, "v and w have the coherence of u (Kaimal)");
  command.add_option("--length", o.length_m, "Length scale L [m] (Mann)");
  command.add_option("--gamma", o.gamma, "Anisotropy (Mann)");
  command.add_flag("--mann-lifetime", o.mann_lifetime,
                   "Mann's own eddy lifetime, not Guo's (Mann)");
  command
      .add_option("--spectrum-allowance", o.settings.spectrum_allowance,
                  "Let pass beyond the limits, share of a density or variance")
      ->capture_default_str();
  command
      .add_option("--coherence-allowance", o.settings.coherence_allowance,
                  "Let pass beyond the limits, root coherence")
      ->capture_default_str();
  command.add_option("--confidence", o.settings.confidence, "Of all tests together")
      ->capture_default_str();
  command
      .add_option("--block", o.settings.block_s,
                  "Of fields that do not repeat [s]; 0: a quarter of the field")
      ->capture_default_str();
  command.add_option("--max-frequency", o.settings.max_frequency_hz, "Highest tested [Hz]");
  command.add_option("--html", o.page, "Page with spectra and coherences to write");
}

}  // namespace

WindOptions::WindOptions(CLI::App& app)
    : wind_(app.add_subcommand("wind", "Make, convert, look at and check wind")),
      make_(wind_->add_subcommand("make", "Make the wind of a case file and write it")),
      convert_(wind_->add_subcommand("convert", "Write a wind file in another format")),
      stats_(wind_->add_subcommand("stats", "Statistics at the hub and over the rotor")),
      check_(wind_->add_subcommand("check", "Compare turbulence with theory")) {
  wind_->require_subcommand(1);
  make_->add_option("case", make_options_.input, "Case file, or a file with a wind section (YAML)")
      ->required();
  make_->add_option("-o,--output", make_options_.output, "File to write: .bts, .wnd, .bin, .hh")
      ->required();
  add_convert_options(*make_, make_options_);
  make_->add_flag("--planes", make_options_.planes,
                  "Of wind that evolves every plane, one file each, not the rotor's alone");
  convert_->add_option("input", convert_options_.input, "Wind file or case file")->required();
  convert_->add_option("output", convert_options_.output, "File to write: .bts, .wnd, .bin, .hh")
      ->required();
  add_convert_options(*convert_, convert_options_);

  stats_->add_option("file", stats_options_.input, "Wind file or case file")->required();
  add_file_options(*stats_, stats_options_.file);
  stats_->add_option("--window", stats_options_.window_s, "Of the turbulence intensity [s]")
      ->capture_default_str();
  stats_->add_option("--duration", stats_options_.duration_s, "Of wind that never ends [s]")
      ->capture_default_str();
  stats_->add_option("--time-step", stats_options_.time_step_s, "Of the samples [s]");
  stats_->add_option("--channels", stats_options_.channels, "Time series to write: .outb, .csv");

  check_->add_option("file", check_options_.input, "Wind file or case file")->required();
  add_file_options(*check_, check_options_.file);
  add_theory_options(*check_, check_options_);
}

int WindOptions::run(std::ostream& out) const {
  if (make_->parsed()) wind_convert_command(make_options_, out);
  if (convert_->parsed()) wind_convert_command(convert_options_, out);
  if (stats_->parsed()) wind_stats_command(stats_options_, out);
  if (check_->parsed()) return wind_check_command(check_options_, out) ? 0 : 1;
  return 0;
}

}  // namespace lac::sim
