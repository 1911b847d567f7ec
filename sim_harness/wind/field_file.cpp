// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/field_file.hpp"

#include "sim_harness/wind/bladed_file.hpp"
#include "sim_harness/wind/bts_file.hpp"

namespace lac::sim {

GriddedWind read_field(const FieldFile& file) {
  switch (file.format) {
    case FieldFormat::kBts:
      return read_bts(file.file);
    case FieldFormat::kBladed:
      return read_bladed(file.file);
    default:
      return read_box(box_files(file.file), file.box_spec, file.box_order);
  }
}

void write_field(const FieldFile& file, const GriddedWind& wind, const std::string& description) {
  switch (file.format) {
    case FieldFormat::kBts:
      return write_bts(file.file, wind, description);
    case FieldFormat::kBladed:
      return write_bladed(file.file, wind);
    default:
      return write_box(box_files(file.file), wind, file.box_order);
  }
}

}  // namespace lac::sim
