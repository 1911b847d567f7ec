// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/lookup_table.hpp"
#include "core/units.hpp"
#include "sim_harness/turbine/turbine_params.hpp"

namespace lac::sim {

/// The static pitch curve theta_ss(v) of the feedforward (GUO eq. 37): the pitch that balances
/// rated torque at rated speed in steady wind; fine pitch below. Its slope is the small-signal
/// optimum -(dM_a/dv)/(dM_a/dtheta) (methods section 13).
struct PitchCurve {
  LookupTable pitch_rad;           // over wind speed [m/s]
  double rated_wind_mps = 0.0;     // the blades leave fine pitch here
  double last_balance_mps = 0.0;   // beyond, the last slope goes on: the rotor table ends
  double largest_error_rad = 0.0;  // of straight lines between the points, as found half-way
};

struct PitchCurveSettings {
  double last_wind_mps = 40.0;  // gusts included: beyond the curve FFP is off
  double tolerance_rad = rad_from_deg(0.05);
};

/// From steady_state(). Points lie so close that straight lines between them stay within the
/// tolerance. Throws lac::Error if the rotor does not reach rated power up to cut-out, or if the
/// pitch falls with the wind somewhere.
PitchCurve static_pitch_curve(const TurbineParams& turbine,
                              const PitchCurveSettings& settings = {});

/// The FFP input with the curve in the place of StaticWind and StaticPitch, its origin in comments.
/// Precondition: the template was read.
std::string with_pitch_curve(std::string_view ffp_input, const TurbineParams& turbine,
                             const PitchCurve& curve);

}  // namespace lac::sim
