// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/state_archive.hpp"

namespace lac {

/// The last `size` values of a signal as one contiguous stretch, oldest first.
class ContiguousHistory {
 public:
  ContiguousHistory() = default;
  explicit ContiguousHistory(std::size_t size) : size_(size), values_(2 * size, 0.0) {}

  void push(double value) noexcept {
    values_[head_] = value;
    values_[head_ + size_] = value;
    head_ = head_ + 1 == size_ ? 0 : head_ + 1;
  }
  const double* oldest() const noexcept { return &values_[head_]; }
  void visit(StateArchive& a) { a(values_), a(head_); }

 private:
  std::size_t size_ = 1;
  std::vector<double> values_{0.0, 0.0};
  std::size_t head_ = 0;
};

/// Running covariances of two signals without mean, with exponential forgetting:
///
///     cross(k) = E[x(t) y(t + k)], |k| <= max_lag     auto_x(j) = E[x(t) x(t + j)], 0 <= j <=
///     max_auto
///
/// in ticks. State of a module: built with its size, then never allocates.
class LaggedMoments {
 public:
  LaggedMoments() = default;
  /// Precondition: max_auto <= max_lag.
  LaggedMoments(std::size_t max_lag, std::size_t max_auto)
      : max_lag_(max_lag),
        x_(2 * max_lag + 1),
        y_(2 * max_lag + 1),
        cross_(2 * max_lag + 1, 0.0),
        auto_x_(max_auto + 1, 0.0),
        auto_y_(max_auto + 1, 0.0) {}

  /// `share`: what the newest product counts, 1 for the first.
  void add(double x, double y, double share) noexcept {
    x_.push(x);
    y_.push(y);
    if (pushed_ < cross_.size()) ++pushed_;
    if (!filled()) return;
    const double* xs = x_.oldest();
    const double* ys = y_.oldest();
    const double centre_x = xs[max_lag_], centre_y = ys[max_lag_];
    const std::size_t last = cross_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {  // lag i - max_lag, x that much before the centre
      cross_[i] += share * (xs[last - i] * centre_y - cross_[i]);
    }
    for (std::size_t j = 0; j < auto_x_.size(); ++j) {
      auto_x_[j] += share * (centre_x * xs[max_lag_ - j] - auto_x_[j]);
      auto_y_[j] += share * (centre_y * ys[max_lag_ - j] - auto_y_[j]);
    }
  }
  /// What comes next does not follow what was there: no products across the gap.
  void break_off() noexcept { pushed_ = 0; }
  bool filled() const noexcept { return pushed_ == cross_.size(); }

  std::size_t max_lag() const noexcept { return max_lag_; }
  double cross(std::ptrdiff_t lag) const noexcept {
    return cross_[static_cast<std::size_t>(lag + static_cast<std::ptrdiff_t>(max_lag_))];
  }
  double auto_x(std::size_t lag) const noexcept { return auto_x_[lag]; }
  double auto_y(std::size_t lag) const noexcept { return auto_y_[lag]; }

  void visit(StateArchive& a) { a(x_), a(y_), a(cross_), a(auto_x_), a(auto_y_), a(pushed_); }

 private:
  std::size_t max_lag_ = 0;
  ContiguousHistory x_, y_;
  std::vector<double> cross_{0.0}, auto_x_{0.0}, auto_y_{0.0};
  std::size_t pushed_ = 0;
};

}  // namespace lac
