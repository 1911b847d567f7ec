// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim_harness/wind/velocity_grid.hpp"

namespace lac::sim {

/// The points of a y-z grid that are kept; each is a column over time.
class GridColumns {
 public:
  static constexpr std::int32_t kNone = -1;

  /// kept: one per point, [z][y].
  explicit GridColumns(const std::vector<bool>& kept);

  std::size_t count() const { return points_.size(); }
  /// Index of the column of a point, or kNone.
  std::int32_t of_point(std::size_t point) const { return columns_[point]; }
  /// The points of the columns, rising.
  std::span<const std::uint32_t> points() const { return points_; }

 private:
  std::vector<std::int32_t> columns_;
  std::vector<std::uint32_t> points_;
};

/// The numbers of a gridded field at some of its points alone: (u, v, w) [m/s] as in VelocityGrid,
/// stored [column][t][3].
class ThinnedGrid {
 public:
  /// All zero. Throws lac::Error as GridSpec::check().
  ThinnedGrid(const GridSpec& spec, GridColumns columns);
  /// What the whole field has there.
  ThinnedGrid(const VelocityGrid& whole, GridColumns columns);

  const GridSpec& spec() const { return spec_; }
  const GridColumns& columns() const { return columns_; }
  /// [t][3]; one number more behind it may be read.
  std::span<float> column(std::size_t i) { return {values_.data() + i * size_, size_}; }
  std::span<const float> column(std::size_t i) const { return {values_.data() + i * size_, size_}; }

 private:
  GridSpec spec_;
  GridColumns columns_;
  std::size_t size_;           // of a column
  std::vector<float> values_;  // one number longer: interpolation loads points four at a time
};

}  // namespace lac::sim
