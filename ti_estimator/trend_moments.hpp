// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ti_estimator/running_moments.hpp"

namespace lac {

/// RunningMoments that also know how the speeds went over time, O(1) per sample and as exact.
///
/// Times are whole ticks from an origin that is moved along. Limits: |tick| below 2^19 (two hours),
/// so that the sum of products stays below 2^58.
class TrendMoments {
 public:
  static constexpr double kTicksPerSecond = 64.0;

  void add(std::int32_t units, std::int64_t tick) noexcept {
    speeds_.add(units);
    sum_of_ticks_ += tick;
    sum_of_squares_ += tick * tick;
    sum_of_products_ += tick * units;
  }
  /// Precondition: was added with this tick (as counted from the present origin) and is still in.
  void remove(std::int32_t units, std::int64_t tick) noexcept {
    speeds_.remove(units);
    sum_of_ticks_ -= tick;
    sum_of_squares_ -= tick * tick;
    sum_of_products_ -= tick * units;
  }
  /// The origin goes on by so many ticks: all ticks become smaller.
  void move_origin(std::int64_t ticks) noexcept {
    const std::int64_t n = speeds_.count();
    sum_of_squares_ += ticks * (n * ticks - 2 * sum_of_ticks_);
    sum_of_products_ -= ticks * speeds_.sum();
    sum_of_ticks_ -= n * ticks;
  }

  const RunningMoments& speeds() const { return speeds_; }
  /// Of what a straight line through the samples leaves [m^2/s^2], divisor n - 2; the plain
  /// variance if all came at one time. Precondition: count() >= 3.
  double variance_about_trend() const {
    const auto n = static_cast<double>(speeds_.count());
    const double time = about_means(sum_of_squares_, sum_of_ticks_, sum_of_ticks_);
    if (!(time > 0.0)) return speeds_.variance();
    const double both =
        about_means(sum_of_products_, sum_of_ticks_, speeds_.sum()) / RunningMoments::kUnitsPerMps;
    const double left = (n - 1.0) * speeds_.variance() - both * both / time;
    return left > 0.0 ? left / (n - 2.0) : 0.0;
  }

  void visit(StateArchive& a) {
    a(speeds_), a(sum_of_ticks_), a(sum_of_squares_), a(sum_of_products_);
  }

 private:
  /// Sum of (a - mean a)(b - mean b): exact about whole numbers near the means, then the rest.
  double about_means(std::int64_t products, std::int64_t sum_a, std::int64_t sum_b) const {
    const std::int64_t n = speeds_.count();
    const std::int64_t mean_a = sum_a / n, mean_b = sum_b / n;
    const std::int64_t rest_a = sum_a - n * mean_a, rest_b = sum_b - n * mean_b;
    const std::int64_t about = products - mean_a * sum_b - mean_b * rest_a;
    return static_cast<double>(about) -
           static_cast<double>(rest_a) * static_cast<double>(rest_b) / static_cast<double>(n);
  }

  RunningMoments speeds_;
  std::int64_t sum_of_ticks_ = 0;
  std::int64_t sum_of_squares_ = 0;
  std::int64_t sum_of_products_ = 0;
};

}  // namespace lac
