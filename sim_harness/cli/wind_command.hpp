// SPDX-License-Identifier: Apache-2.0
// What the commands of `lac wind` do. All throw lac::Error with a text for the user.
#pragma once

#include "sim_harness/cli/wind_output.hpp"
#include "sim_harness/wind_check/theory_check.hpp"

namespace lac::sim {

struct WindConvertOptions {
  std::filesystem::path input;
  std::filesystem::path output;
  WindFileOptions file;
  WindSamplingOptions sampling;
  bool planes = false;  // of evolving wind: all of them, not the rotor's alone
};

/// `lac wind make` and `lac wind convert`: the wind of a case file or wind file as another file.
void wind_convert_command(const WindConvertOptions& options, std::ostream& out);

struct WindStatsOptions {
  std::filesystem::path input;
  WindFileOptions file;
  double window_s = 600.0;         // of the running turbulence intensity
  double duration_s = 600.0;       // of winds that never end
  double time_step_s = 0.0;        // 0: that of the grid, 0.1 s if there is none
  std::filesystem::path channels;  // .outb or .csv to write; empty: none
};

/// `lac wind stats`: hub, rotor, shears; the rotor the greatest that fits if nobody says.
void wind_stats_command(const WindStatsOptions& options, std::ostream& out);

struct WindCheckOptions {
  std::filesystem::path input;
  WindFileOptions file;
  std::filesystem::path theory_case;  // case file whose wind section is the theory
  std::string theory;                 // "kaimal" or "mann", with the numbers below
  double sigma_u_mps = 0.0;
  bool lateral_as_u = false;   // coherence of v and w (Kaimal)
  double length_m = 0.0;       // Mann
  double gamma = 0.0;          // Mann
  bool mann_lifetime = false;  // Mann's own eddy lifetime, else Guo's
  CheckSettings settings;
  std::filesystem::path page;  // HTML to write; empty: none
};

/// `lac wind check`: spectra, coherence and standard deviations against theory. False if
/// something is outside.
bool wind_check_command(const WindCheckOptions& options, std::ostream& out);

}  // namespace lac::sim
