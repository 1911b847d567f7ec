// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sim_harness/wind/complex_normal.hpp"

namespace lac::sim {

/// The anemometer on the nacelle stands behind the rotor. Defaults: in the undisturbed wind.
struct NacelleAnemometerParams {
  double induction_share = 0.0;  // of a, how much the wind has slowed down at its place
  double induction_lag_s = 10.0;
  double added_intensity = 0.0;  // standard deviation of what the rotor adds, over the mean there
  double time_scale_s = 0.3;     // of that

  bool disturbed() const { return induction_share != 0.0 || added_intensity != 0.0; }
};

/// What it measures,
///
///   v = (1 - share a) (1 + added x) v_hub,   a = (1 - sqrt(1 - C_T))/2
///
/// a: axial induction of momentum theory, C_T at most 0.96 (where a = 0.4), behind a lag of first
/// order: the faster wind above rated is held up less, so that gusts grow and the mean falls. x:
/// turbulence of blade roots and nacelle, Gaussian of unit variance with the autocorrelation
/// exp(-t / time_scale). The same seed gives the same numbers.
class NacelleAnemometer {
 public:
  /// Throws lac::Error unless lag and time scale are above 0, share in 0 ... 1 and added in 0
  /// ... 1.
  NacelleAnemometer(const NacelleAnemometerParams& params, std::uint64_t seed, double time_step_s);

  /// Once a step.
  double measure(double hub_wind_mps, double thrust_coefficient);

 private:
  NacelleAnemometerParams params_;
  double lag_factor_;  // of a step
  double kept_;        // of x over a step
  ComplexNormal draw_;
  bool started_ = false;
  double induction_ = 0.0;
  double added_ = 0.0;
};

}  // namespace lac::sim
