// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/state_archive.hpp"

namespace lac {

/// PI law u = k_p e + I with limits on the output and on its rate; both loops use it.
///
///   I' = k_p/T_I e + feed rate + (u - u_wanted)/T_I
///
/// The last term is the back-calculation: u_wanted = k_p e + I is what the law asks for and u
/// what the limits leave. With the tracking time T_I the error cancels out of I' at a limit, so
/// that I settles at the limit itself and u leaves it in the step in which e changes sign,
/// however long and large the error was. I is kept within the limits for the same reason.
class LimitedPi {
 public:
  struct Gains {
    double proportional = 0.0;     // k_p, unit of u per unit of e
    double integral_time_s = 1.0;  // T_I
  };
  /// Precondition: min <= max, rate >= 0. They may change from step to step.
  struct Limits {
    double min = 0.0;
    double max = 0.0;
    double rate_per_s = 0.0;
  };

  /// Starts at `output`, which is then where the rate limit counts from even outside the limits.
  void start(double error, double output, const Gains& gains, const Limits& limits) noexcept {
    output_ = output;
    integral_ = std::clamp(output - gains.proportional * error, limits.min, limits.max);
  }

  /// One step; `feed_rate` (unit of u per s) is integrated with the error. Returns u.
  double step(double error, double feed_rate, const Gains& gains, const Limits& limits,
              double time_step_s) noexcept {
    const double proportional = gains.proportional * error;
    const double integral =
        integral_ + (proportional / gains.integral_time_s + feed_rate) * time_step_s;
    const double wanted = proportional + integral;
    const double change = limits.rate_per_s * time_step_s;
    const double allowed = std::clamp(wanted, limits.min, limits.max);
    output_ += std::clamp(allowed - output_, -change, change);
    // Implicit in I, so that the error cancels in discrete time too.
    const double tracking = time_step_s / (gains.integral_time_s + time_step_s);
    integral_ = std::clamp(integral + (output_ - wanted) * tracking, limits.min, limits.max);
    return output_;
  }

  double output() const noexcept { return output_; }
  double integral() const noexcept { return integral_; }
  void visit(StateArchive& a) { a(output_), a(integral_); }

 private:
  double output_ = 0.0;
  double integral_ = 0.0;
};

}  // namespace lac
