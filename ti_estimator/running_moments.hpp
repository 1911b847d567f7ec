// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "core/state_archive.hpp"

namespace lac {

/// Mean and standard deviation of a set of speeds that samples enter and leave, O(1) each.
///
/// Sums are whole numbers of 2^-16 m/s and of its square, so that taking a sample out again is
/// exact: no drift, however long the run. 2^-16 m/s (15 um/s) is a thousandth of what a lidar
/// resolves. Limits: |speed| below 128 m/s (2^23 units), at most 65536 samples (2^62 in the sum of
/// squares).
class RunningMoments {
 public:
  static constexpr double kUnitsPerMps = 65536.0;
  static constexpr double kLimit_mps = 128.0;
  static constexpr int kMaxSamples = 65536;

  /// False for numbers out of range, infinite ones and NaN.
  static bool fits(double speed_mps) { return std::abs(speed_mps) < kLimit_mps; }
  /// Precondition: fits(speed_mps).
  static std::int32_t quantise(double speed_mps) {
    return static_cast<std::int32_t>(std::lrint(speed_mps * kUnitsPerMps));
  }

  void add(std::int32_t units) noexcept {
    sum_ += units;
    sum_of_squares_ += square(units);
    ++count_;
  }
  /// Precondition: `units` was added before and not removed since.
  void remove(std::int32_t units) noexcept {
    sum_ -= units;
    sum_of_squares_ -= square(units);
    --count_;
  }

  /// In units.
  std::int64_t sum() const { return sum_; }
  int count() const { return static_cast<int>(count_); }
  /// Precondition: count() >= 1.
  double mean_mps() const {
    return static_cast<double>(sum_) / (static_cast<double>(count_) * kUnitsPerMps);
  }
  /// Sample variance [m^2/s^2], divisor n - 1 (S20 eq. 5). Precondition: count() >= 2.
  /// Deviations are taken from a whole number m near the mean, exactly; r = sum - m n is the rest.
  double variance() const {
    const auto n = static_cast<double>(count_);
    const auto m = static_cast<std::int64_t>(static_cast<double>(sum_) / n);
    const std::int64_t r = sum_ - m * count_;
    const auto about_m = static_cast<double>(sum_of_squares_ - m * (sum_ + r));
    const auto rest = static_cast<double>(r);
    return (about_m - rest * rest / n) / ((n - 1.0) * kUnitsPerMps * kUnitsPerMps);
  }
  /// Precondition: count() >= 2.
  double standard_deviation_mps() const { return std::sqrt(variance()); }

  void visit(StateArchive& a) { a(sum_), a(sum_of_squares_), a(count_); }

 private:
  static std::int64_t square(std::int64_t units) { return units * units; }

  std::int64_t sum_ = 0;
  std::int64_t sum_of_squares_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace lac
