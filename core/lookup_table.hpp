// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "core/input_file.hpp"

namespace lac {

/// y(x) by straight lines between given points; held constant outside of them. Pitch curves,
/// gain and filter schedules. Points are checked where they are read (read_table).
class LookupTable {
 public:
  LookupTable() = default;
  /// Precondition: same length, at least one point, x strictly rising.
  LookupTable(std::vector<double> x, std::vector<double> y)
      : x_(std::move(x)), y_(std::move(y)), slopes_(x_.size(), 0.0) {
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
      slopes_[i] = (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
    }
  }

  double at(double x) const noexcept {
    const std::size_t i = interval(x);
    return y_[i] + slopes_[i] * (clamped(x) - x_[i]);
  }
  /// dy/dx; zero outside the points.
  double slope(double x) const noexcept {
    return x < x_.front() || x > x_.back() ? 0.0 : slopes_[interval(x)];
  }
  bool empty() const { return x_.empty(); }
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }

 private:
  double clamped(double x) const noexcept { return std::clamp(x, x_.front(), x_.back()); }
  std::size_t interval(double x) const noexcept {
    std::size_t i = 0;
    while (i + 2 < x_.size() && x >= x_[i + 1]) ++i;
    return i;
  }

  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> slopes_;  // of the interval to the right of x_[i]; last: 0
};

/// Reads two rows of an input file; x must rise strictly, y must have as many values.
/// `scale` brings y to SI units. Errors are lac::Error with file, line and key.
inline LookupTable read_table(InputFile& in, const std::string& x_key, const std::string& y_key,
                              double scale = 1.0, Range y_range = Range::any()) {
  std::vector<double> x = in.numbers(x_key);
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (!(x[i] > x[i - 1])) {
      in.fail(x_key, "value " + std::to_string(i + 1) + " (" + std::to_string(x[i]) +
                         ") is not above the one before it, expected rising values");
    }
  }
  std::vector<double> y =
      in.numbers(y_key, x.size(), x_key + " (" + std::to_string(x.size()) + " points)", y_range);
  for (double& v : y) v *= scale;
  return {std::move(x), std::move(y)};
}

}  // namespace lac
