// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim_harness/wind/wind_field.hpp"

namespace lac::test {

/// Any velocity as a function of place and time.
class FunctionWind final : public sim::WindField {
 public:
  using Function = Vec3 (*)(const Vec3& position_I_m, double time_s);

  explicit FunctionWind(Function f, sim::WindExtent extent = {}) : f_(f), extent_(extent) {}
  Vec3 velocity(const Vec3& p, double t) const override { return f_(p, t); }
  double mean_speed_mps() const override { return 10.0; }
  sim::WindExtent extent() const override { return extent_; }

 private:
  Function f_;
  sim::WindExtent extent_;
};

}  // namespace lac::test
