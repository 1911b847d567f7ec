// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace lac::sim {

struct DesignOptions {
  std::filesystem::path file;
  std::vector<std::string> overrides;   // "key=value"
  std::filesystem::path output_folder;  // empty: results/<name>
  bool fit = false;
};

/// `lac design`: from turbulence, rotor and lidar to the feedforward's schedules (docs/design.md).
/// Prints the table; writes ffp.IN, schedule.csv, curves.csv and design.html. Throws lac::Error.
void design_command(const DesignOptions& options, std::ostream& out);

/// `lac design --fit`: prints the Kaimal spectra and exponential coherences closest to the design's
/// Mann tensor (GUO eqs. 20-22), nothing else. Throws lac::Error: Kaimal already, frozen.
void fit_command(const DesignOptions& options, std::ostream& out);

}  // namespace lac::sim
