// SPDX-License-Identifier: Apache-2.0
#include "core/turbine_rews.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac {
namespace {

constexpr double kSettledTimeConstants = 3.0;

RotorTable read_rotor_table(InputFile& in) {
  const std::string path = in.text("RotorTable");
  try {
    RotorTable table = RotorTable::load(in.resolve(path));
    static_cast<void>(TsrLookup(table));
    return table;
  } catch (const Error& error) {
    in.fail("RotorTable", error.what());
  }
}

}  // namespace

TurbineRewsParams TurbineRewsParams::read(InputFile& in) {
  RotorTable table = read_rotor_table(in);
  const double radius_m = in.number("RotorRadius", Range::positive());
  const double air_density_kgpm3 = in.number("AirDensity", 1.225, Range::positive());
  TurbineRewsParams p{{std::move(table), radius_m, air_density_kgpm3}};
  p.inertia_kgm2 = in.number("InertiaLowSpeedShaft", Range::positive());
  p.gearbox_ratio = in.number("GearboxRatio", Range::positive());
  p.gearbox_efficiency =
      in.number("GearboxEfficiency", p.gearbox_efficiency, Range::between(0.5, 1.0));
  p.low_pass_hz = in.number("TurbineLowPass", p.low_pass_hz, Range::positive());
  return p;
}

void TurbineRewsParams::check_time_step(const InputFile& in, double time_step_s) const {
  const double nyquist_hz = 0.5 / time_step_s;
  if (low_pass_hz < nyquist_hz) return;
  in.fail("TurbineLowPass", "found " + shortest(low_pass_hz) + " Hz, expected less than " +
                                shortest(nyquist_hz) +
                                " Hz, half the rate at which the host calls");
}

TurbineRews::TurbineRews(const TurbineRewsParams& p, double time_step_s)
    : time_step_s_(time_step_s),
      factor_(LowPass1::factor(p.low_pass_hz, time_step_s)),
      delay_s_(0.5 * time_step_s * (1.0 - factor_) / factor_ + 0.5 * time_step_s),
      settling_s_(kSettledTimeConstants / radps_from_hz(p.low_pass_hz)),
      gearbox_ratio_(p.gearbox_ratio),
      slow_torque_per_generator_torque_(p.gearbox_ratio / p.gearbox_efficiency),
      inertia_kgm2_(p.inertia_kgm2),
      radius_m_(p.rotor.radius_m),
      per_torque_and_speed_(1.0 / (p.rotor.disk_factor_kgpm() * std::pow(p.rotor.radius_m, 3))),
      lookup_(p.rotor.table) {}

double TurbineRews::step(const Inputs& in, State& s) const noexcept {
  const double sum = in.generator_speed_radps + in.generator_torque_Nm + in.pitch_rad;
  if (!in.usable || !std::isfinite(sum) || in.generator_torque_Nm <= 0.0 ||
      in.generator_speed_radps <= 0.0) {
    s = {};
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!s.speed.started()) {
    s.speed.reset(in.generator_speed_radps / gearbox_ratio_);
    s.torque.reset(in.generator_torque_Nm);
    s.pitch.reset(in.pitch_rad);
  }
  const double speed_before = s.speed.output();
  const double torque_before = s.torque.output();
  const double pitch_before = s.pitch.output();
  const double speed_now = s.speed.step(in.generator_speed_radps / gearbox_ratio_, factor_);
  const double torque_now = s.torque.step(in.generator_torque_Nm, factor_);
  const double pitch_now = s.pitch.step(in.pitch_rad, factor_);
  s.running_s = s.running_s < settling_s_ ? s.running_s + time_step_s_ : s.running_s;
  if (s.running_s < settling_s_) return std::numeric_limits<double>::quiet_NaN();

  // All at the middle of the step, where the difference of the speed is its slope.
  const double speed_radps = 0.5 * (speed_now + speed_before);
  const double slow_torque_Nm =
      slow_torque_per_generator_torque_ * 0.5 * (torque_now + torque_before) +
      inertia_kgm2_ * (speed_now - speed_before) / time_step_s_;
  const double tsr =
      lookup_.tsr(per_torque_and_speed_ * slow_torque_Nm / (speed_radps * speed_radps),
                  0.5 * (pitch_now + pitch_before));
  return speed_radps * radius_m_ / tsr;
}

}  // namespace lac
