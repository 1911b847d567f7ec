// SPDX-License-Identifier: Apache-2.0
// The wind that a command line names: a case file, or a wind file of any format.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim_harness/run/wind_case.hpp"

namespace lac::sim {

/// What files do not say of themselves. 0 or empty: not given.
struct WindFileOptions {
  std::vector<std::string> overrides;  // "key=value", of a case file
  std::vector<int> points;             // of a box: along x, y, z
  std::vector<double> spacing_m;       // of a box: along x, y, z
  double mean_speed_mps = 0.0;         // of a box
  double hub_height_m = 0.0;           // of boxes and uniform wind files; else in place of its own
  double rotor_diameter_m = 0.0;       // of uniform wind files; of statistics
  BoxOrder box_order = {};
};

/// The wind section of a case file, not yet made.
struct WindSection {
  WindCase wind;
  WindSurroundings around;
};

/// A case file needs its wind section alone: hub height and rotor come from its turbine, or from
/// its keys hub_height_m and rotor_radius_m; seed (1). Throws lac::Error.
WindSection read_wind_case(const std::filesystem::path& file,
                           const std::vector<std::string>& overrides);

struct LoadedWind {
  std::string name;  // for reports
  std::unique_ptr<WindField> field;
  std::optional<WindCase> made_of;  // of a case file
  double hub_height_m = 0.0;
  double rotor_diameter_m = 0.0;  // 0: nobody said

  /// The field at the rotor plane as numbers on a grid, or nullptr.
  const GriddedWind* gridded() const;
  /// nullptr if it is not.
  const UniformWind* uniform() const;
};

enum class WindFileKind { kCase, kBts, kBladed, kUniform, kBox };

/// By the ending: .yaml .yml, .bts, .hh .dat, .bin .turb .u; a .wnd is Bladed's if it is binary (it
/// begins with a negative number), else text. Throws lac::Error for other endings.
WindFileKind wind_file_kind(const std::filesystem::path& file);

/// Throws lac::Error as the reader of the kind.
LoadedWind load_wind(const std::filesystem::path& file, const WindFileOptions& options);

}  // namespace lac::sim
