// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/state_archive.hpp"

namespace lac {

/// Adds the increment to the pitch demands another controller has written (records 42 to 45, each
/// on its own, so that individual pitch passes) and keeps the sum within limits of angle and rate.
/// Without an increment, and once the sum is the other's demand again, that passes untouched.
///
/// A demand that is still the sum of the step before, and not one of the limits, was not written
/// anew; its increment is replaced, not added to.
class AddedDemands {
 public:
  static constexpr std::size_t kDemands = 4;
  using Demands = std::array<float, kDemands>;  // [rad]

  struct Params {
    double min_rad = 0.0;
    double max_rad = 0.0;
    double max_rate_radps = 0.0;
  };
  struct State {
    Demands base{};   // the other's, in the step before
    Demands given{};  // the sums, in the step before
    bool started = false;
    int not_written = 0;  // steps in a row in which nobody wrote the first demand
    void visit(StateArchive& a) { a(base), a(given), a(started), a(not_written); }
  };

  AddedDemands(const Params& params, double time_step_s)
      : params_(params), step_rad_(params.max_rate_radps * time_step_s) {}
  /// One step, in place. Returns whether a limit cut a sum.
  bool step(double increment_rad, Demands& demands, State& state) const noexcept;

 private:
  bool is_at_a_limit(float demand_rad) const noexcept;
  float limit(double wanted_rad, double before_rad, bool& limited) const noexcept;

  Params params_;
  double step_rad_;
};

}  // namespace lac
