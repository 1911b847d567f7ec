// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/linear_turbine.hpp"

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

using Complex = std::complex<double>;

// Half widths of the differences: of the size of what turbulence does, not of a cell of the table.
constexpr double kWindStep_mps = 0.5;
constexpr double kSpeedStep = 0.01;
constexpr double kPitchStep_rad = rad_from_deg(0.5);

Complex second_order(Complex s, double frequency_radps, double damping) {
  const double w = frequency_radps;
  return w * w / (s * s + 2.0 * damping * w * s + w * w);
}

}  // namespace

LinearTurbine::LinearTurbine(const TurbineParams& turbine, const FeedbackParams& feedback,
                             double wind_mps)
    : turbine_(turbine), feedback_(feedback), point_(steady_state(turbine, wind_mps)) {
  if (!(point_.pitch_rad > turbine.fine_pitch_rad)) {
    throw Error(turbine.name + ": " + shortest(wind_mps) +
                " m/s is below rated; the rotor speed can be predicted above it");
  }
  const auto slopes = [&](auto load) {
    const double v = wind_mps, w = point_.rotor_speed_radps, p = point_.pitch_rad;
    const double dw = kSpeedStep * w;
    return Slopes{
        (load(v + kWindStep_mps, w, p) - load(v - kWindStep_mps, w, p)) / (2.0 * kWindStep_mps),
        (load(v, w + dw, p) - load(v, w - dw, p)) / (2.0 * dw),
        (load(v, w, p + kPitchStep_rad) - load(v, w, p - kPitchStep_rad)) / (2.0 * kPitchStep_rad)};
  };
  const RotorAero& rotor = turbine_.rotor;
  torque_ = slopes([&](double v, double w, double p) { return rotor.torque_Nm(v, w, p); });
  thrust_ = slopes([&](double v, double w, double p) { return rotor.thrust_N(v, w, p); });
  gains_ = feedback_.pitch.gains.at(point_.pitch_rad);
}

Complex LinearTurbine::actuators(Complex s) const {
  Complex a = 1.0;
  const PitchActuator& own = turbine_.pitch_actuator;
  if (own.enabled) a *= second_order(s, own.frequency_radps, own.damping_ratio);
  const auto& added = feedback_.actuator;
  if (feedback_.use_actuator) a *= second_order(s, added.frequency_radps, added.damping);
  return a;
}

Complex LinearTurbine::speed_filter(Complex s) const {
  const SpeedFilter::Params& p = feedback_.speed;
  const double low_radps = radps_from_hz(p.low_pass_hz);
  const double width_radps = radps_from_hz(p.notch_bandwidth_hz);
  const Complex low = low_radps / (s + low_radps);
  if (width_radps == 0.0) return low;
  const double centre_radps = radps_from_hz(
      SpeedFilter::notch_centre_hz(p, point_.rotor_speed_radps * turbine_.gearbox_ratio));
  const Complex flat = s * s + centre_radps * centre_radps;
  return low * (flat + p.notch_depth * width_radps * s) / (flat + width_radps * s);
}

LinearTurbine::RotorSpeed LinearTurbine::rotor_speed(double frequency_hz) const {
  const Complex s(0.0, radps_from_hz(frequency_hz));
  const double i = turbine_.gearbox_ratio, omega = point_.rotor_speed_radps;
  const Complex filtered = i * speed_filter(s), actuator = actuators(s);
  const Complex pi_law = gains_.proportional * (1.0 + 1.0 / (gains_.integral_time_s * s));
  const Complex pitch = actuator * pi_law * filtered;
  const bool constant_power =
      feedback_.torque.above_rated == TorqueControl::AboveRated::ConstantPower;
  const Complex falling = constant_power ? point_.generator_torque_Nm / (i * omega) * filtered /
                                               (1.0 + turbine_.generator_lag.time_constant_s * s)
                                         : Complex(0.0);
  const TowerMode& tower = turbine_.tower;
  // [a b; c d] [Omega x] = [per wind, per pitch] right-hand sides.
  const Complex a = turbine_.inertia_kgm2 * s - torque_.per_speed - torque_.per_pitch * pitch -
                    i / turbine_.gearbox_efficiency * falling;
  const Complex b = torque_.per_wind * s;
  const Complex c = -thrust_.per_speed - thrust_.per_pitch * pitch;
  const Complex d =
      tower.mass_kg * s * s + (tower.damping_Nspm + thrust_.per_wind) * s + tower.stiffness_Npm;
  const Complex determinant = a * d - b * c;
  return {(torque_.per_wind * d - b * thrust_.per_wind) / determinant,
          actuator * (torque_.per_pitch * d - b * thrust_.per_pitch) / determinant};
}

}  // namespace lac::sim
