// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/thinned_grid.hpp"

#include <algorithm>
#include <utility>

namespace lac::sim {

GridColumns::GridColumns(const std::vector<bool>& kept) : columns_(kept.size(), kNone) {
  for (std::size_t point = 0; point < kept.size(); ++point) {
    if (!kept[point]) continue;
    columns_[point] = static_cast<std::int32_t>(points_.size());
    points_.push_back(static_cast<std::uint32_t>(point));
  }
}

ThinnedGrid::ThinnedGrid(const GridSpec& spec, GridColumns columns)
    : spec_(spec), columns_(std::move(columns)), size_(3 * static_cast<std::size_t>(spec.nt)) {
  spec_.check();
  values_.resize(size_ * columns_.count() + 1);
}

ThinnedGrid::ThinnedGrid(const VelocityGrid& whole, GridColumns columns)
    : ThinnedGrid(whole.spec(), std::move(columns)) {
  for (int it = 0; it < spec_.nt; ++it) {
    const std::span<const float> plane = whole.plane(it);
    for (std::size_t i = 0; i < columns_.count(); ++i) {
      const std::size_t point = columns_.points()[i];
      std::copy_n(plane.data() + 3 * point, 3, column(i).data() + 3 * it);
    }
  }
}

}  // namespace lac::sim
