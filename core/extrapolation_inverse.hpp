// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "core/state_archive.hpp"

namespace lac {

/// What a host sends that extrapolates its values one step ahead, back to what they were.
///
/// OpenFAST fills a controller's inputs at t_k with the polynomial of order `InterpOrder` through
/// the values x of the steps up to t_(k-1):
///   order 1   y(k) = 2 x(k-1) - x(k-2)               x(k-1) = (y(k) + x(k-2)) / 2
///   order 2   y(k) = 3 x(k-1) - 3 x(k-2) + x(k-3)    x(k-1) = (y(k) + 3 x(k-2) - x(k-3)) / 3
/// so that a value held and then stepped from a to b is seen as a, a + 2(b-a), b ... or
/// a, a + 3(b-a), a, b ... The inverse is exact and stable (poles of modulus 0.5 and 0.577): the
/// rounding of y to single precision stays within 1.1 times itself, and so does not build up.
class ExtrapolationInverse {
 public:
  /// A received value of this size or more is no wind speed and no place.
  static constexpr double kNoValue = 1.0e5;
  /// Calls after which what came before a bad value is forgotten: 0.577^20 = 2e-5.
  static constexpr int kSettlingCalls = 20;

  /// The value of the step before, from the value received now; order 0 gives it as it comes. Not a
  /// number for a received value that is none, and for some calls after it.
  double step(double received, int order) noexcept {
    if (!(std::abs(received) < kNoValue)) {
      lose();
      return std::numeric_limits<double>::quiet_NaN();
    }
    if (!running_) last_ = before_ = received;  // at its start the host's history is constant
    running_ = true;
    double value = received;
    if (order == 1) value = (received + last_) / 2.0;
    if (order == 2) value = (received + 3.0 * last_ - before_) / 3.0;
    before_ = last_;
    last_ = value;
    if (settling_ == 0 || order == 0) return value;
    --settling_;
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// The next value begins anew, with an unknown past.
  void lose() noexcept {
    running_ = false;
    settling_ = kSettlingCalls;
  }

  void visit(StateArchive& a) { a(last_), a(before_), a(settling_), a(running_); }

 private:
  double last_ = 0.0;    // x(k-1)
  double before_ = 0.0;  // x(k-2)
  int settling_ = 0;
  bool running_ = false;
};

}  // namespace lac
