// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>

#include "feedback/feedback_params.hpp"
#include "sim_harness/turbine/operating_point.hpp"

namespace lac::sim {

/// SLOW in closed loop with the feedback controller, linear about a steady state above rated
/// (methods sections 11 to 13), as transfer functions of frequency, e^(+i 2 pi f t):
///
///   J s Omega = M_v (v - s x) + M_Omega Omega + M_theta theta - i/eta M_g
///   (m s^2 + c s + k) x = F_v (v - s x) + F_Omega Omega + F_theta theta
///   theta = A(s) [ k_p (1 + 1/(T_I s)) i H(s) Omega + theta_FF ]
///   M_g = -(M/Omega_g) i H(s) Omega / (1 + tau s)   constant power; 0 for constant torque
///
/// H: low-pass and notch of the generator speed; A: pitch actuators of turbine and controller.
/// Left out: steps of the controller, limits of angle and rate, set-point fading (at rest there).
class LinearTurbine {
 public:
  using Complex = std::complex<double>;

  /// Throws lac::Error below rated, where the blades rest at fine pitch.
  LinearTurbine(const TurbineParams& turbine, const FeedbackParams& feedback, double wind_mps);

  struct RotorSpeed {
    Complex per_wind;         // rad/s per m/s: G_R
    Complex per_feedforward;  // rad/s per rad of theta_FF
  };
  RotorSpeed rotor_speed(double frequency_hz) const;

  const OperatingPoint& point() const { return point_; }

 private:
  struct Slopes {
    double per_wind, per_speed, per_pitch;
  };
  Complex actuators(Complex s) const;
  Complex speed_filter(Complex s) const;

  TurbineParams turbine_;
  FeedbackParams feedback_;
  OperatingPoint point_;
  Slopes torque_, thrust_;
  LimitedPi::Gains gains_;
};

}  // namespace lac::sim
