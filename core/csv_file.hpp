// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/part_file.hpp"
#include "core/table_writer.hpp"

namespace lac {

/// Comma-separated text, one header line "Time [s],RotSpeed [rpm],...". Values are the shortest
/// text that reads back as the same float32, time has ten significant digits; "nan", "inf" and
/// "-inf" as such. Line ends are "\n". TableSpec::description has no place here.
/// Memory: block_rows * (17 channels + 26) bytes.
class CsvWriter final : public TableWriter {
 public:
  explicit CsvWriter(TableSpec spec);
  ~CsvWriter() override = default;

  bool append(const float* row) noexcept override;
  void finish() override;

 private:
  bool flush_block() noexcept;

  TableSpec spec_;
  PartFile file_;
  std::vector<char> block_;
  std::size_t bytes_in_block_ = 0;
  std::size_t rows_in_block_ = 0;
  std::uint64_t rows_ = 0;
  bool healthy_ = true;
  bool finished_ = false;
};

}  // namespace lac
