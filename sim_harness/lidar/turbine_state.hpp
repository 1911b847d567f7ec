// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lac::sim {

/// What a lidar is told of the turbine it rides on, as of a control step.
struct TurbineState {
  double tower_x_m = 0.0;  // tower top, down-wind
  double tower_v_mps = 0.0;
  double azimuth_rad = 0.0;  // of the rotor, clockwise looking down-wind, blade 1 up: 0
  double rotor_speed_radps = 0.0;
  double pitch_rad = 0.0;           // of the blades, positive towards feather
  double thrust_coefficient = 0.0;  // of the wind that the rotor feels, rotor wind less tower_v
};

}  // namespace lac::sim
