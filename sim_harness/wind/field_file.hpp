// SPDX-License-Identifier: Apache-2.0
// Gridded wind files of all formats behind one name.
#pragma once

#include <filesystem>
#include <string>

#include "sim_harness/wind/box_file.hpp"

namespace lac::sim {

enum class FieldFormat {
  kBts,     // TurbSim, bts_file.hpp
  kBladed,  // .wnd with .sum, bladed_file.hpp
  kBox,     // HAWC2 / Mann, box_file.hpp
};

struct FieldFile {
  FieldFormat format = FieldFormat::kBts;
  std::filesystem::path file;  // of a box the file of u, or a name without u: box_files()
  GridSpec box_spec = {};      // of a box, to read it
  BoxOrder box_order = {};
};

/// Throws lac::Error as the reader of the format.
GriddedWind read_field(const FieldFile& file);

/// description goes where the format has room for it. Throws lac::Error as the writer.
void write_field(const FieldFile& file, const GriddedWind& wind, const std::string& description);

}  // namespace lac::sim
