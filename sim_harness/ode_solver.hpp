// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace lac::sim {

/// Right-hand side y' = f(t, y) of n states; `time_s` counts from the start of the interval.
using OdeFunction = void (*)(double time_s, const double* state, double* rates,
                             const void* context);

/// Integrates an ordinary differential equation over one interval after the other with SUNDIALS
/// (ARKODE, explicit Runge-Kutta with embedded error estimate, Bogacki and Shampine 3(2)).
///
/// Each interval is a fresh initial-value problem: no derivative, step size or error history is
/// carried over, so demands may jump between intervals and two solvers never disturb each other.
/// The first step tried is the whole interval; it stands when the error estimate allows, with
/// |error_i| <= relative |y_i| + absolute_i in the root mean square over the states.
/// No allocation after the first interval.
class OdeSolver {
 public:
  struct Statistics {
    long intervals = 0;
    long steps = 0;
    long rejected_steps = 0;
    long function_calls = 0;
  };

  /// `absolute_tolerance` has one entry per state, in the unit of the state. Throws Error when
  /// SUNDIALS refuses.
  OdeSolver(OdeFunction function, double relative_tolerance,
            const std::vector<double>& absolute_tolerance);
  ~OdeSolver();
  OdeSolver(OdeSolver&&) noexcept;
  OdeSolver& operator=(OdeSolver&&) noexcept;

  /// Replaces `state` by the solution `duration_s` later. `context` is handed to the function.
  /// Throws Error when the tolerance cannot be met.
  void advance(double duration_s, double* state, const void* context);

  const Statistics& statistics() const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace lac::sim
