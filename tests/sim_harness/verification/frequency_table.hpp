// SPDX-License-Identifier: Apache-2.0
// Tables of numbers that the scripts in python/ have printed: a row per frequency, lines with # are
// left out.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace lac::sim {

class FrequencyTable {
 public:
  /// Throws lac::Error if there are fewer than four rows of so many columns, the frequency [Hz]
  /// first and rising.
  FrequencyTable(const std::filesystem::path& file, std::size_t columns) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with('#')) continue;
      std::istringstream numbers(line);
      std::vector<double> row(columns);
      for (double& x : row) numbers >> x;
      if (!numbers || !(rows_.empty() || row[0] > rows_.back()[0])) {
        throw Error(file.string() + ": a row of " + std::to_string(columns) +
                    " numbers expected, found: " + line);
      }
      rows_.push_back(std::move(row));
    }
    if (rows_.size() < 4) throw Error(file.string() + ": fewer than four rows");
  }

  const std::vector<std::vector<double>>& rows() const { return rows_; }

  /// Cubic through the four rows around, over log f.
  double at(double frequency_hz, std::size_t column) const {
    return interpolated(frequency_hz, [&](const auto& row) { return row[column]; });
  }
  /// The same for what is above 0, its logarithm interpolated.
  double positive_at(double frequency_hz, std::size_t column) const {
    return std::exp(
        interpolated(frequency_hz, [&](const auto& row) { return std::log(row[column]); }));
  }

 private:
  double interpolated(double frequency_hz, const auto& value) const {
    std::size_t first = 0;
    while (first + 4 < rows_.size() && rows_[first + 2][0] < frequency_hz) ++first;
    double sum = 0.0;
    for (std::size_t j = first; j < first + 4; ++j) {
      double weight = 1.0;
      for (std::size_t l = first; l < first + 4; ++l) {
        if (l != j)
          weight *= std::log(frequency_hz / rows_[l][0]) / std::log(rows_[j][0] / rows_[l][0]);
      }
      sum += weight * value(rows_[j]);
    }
    return sum;
  }

  std::vector<std::vector<double>> rows_;
};

}  // namespace lac::sim
