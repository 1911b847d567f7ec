// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/table_writer.hpp"

namespace lac::sim {

/// Time series of one run in memory, row after row; row i belongs to
/// start_time_s + i time_step_s.
class Recording {
 public:
  /// Memory for expected_rows is reserved here; append() allocates only beyond it.
  Recording(std::vector<TableChannel> channels, double start_time_s, double time_step_s,
            std::size_t expected_rows);

  /// Takes channels().size() values.
  void append(const float* row) { values_.insert(values_.end(), row, row + channels_.size()); }

  const std::vector<TableChannel>& channels() const { return channels_; }
  double start_time_s() const { return start_time_s_; }
  double time_step_s() const { return time_step_s_; }
  std::size_t rows() const { return values_.size() / channels_.size(); }
  std::span<const float> row(std::size_t index) const;

  /// Index of the first row at or after a time, at most rows().
  std::size_t first_row_from(double time_s) const;

  /// A copy of one channel. Throws lac::Error naming the channels there are.
  std::vector<double> column(std::string_view name) const;

  /// As ".outb" or ".csv", by the ending; nothing half-written. Throws lac::Error.
  void write(const std::filesystem::path& path, const std::string& description = {}) const;

 private:
  std::vector<TableChannel> channels_;
  double start_time_s_;
  double time_step_s_;
  std::vector<float> values_;
};

}  // namespace lac::sim
