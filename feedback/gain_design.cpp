// SPDX-License-Identifier: Apache-2.0
#include "feedback/gain_design.hpp"

#include <cstdio>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac {
namespace {

constexpr double kHighestWind_mps = 50.0;
constexpr double kWindStep_mps = 0.1;

std::string printed(const char* format, double a, double b = 0.0) {
  char text[200];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

/// Root between `below`, where f < 0 holds or should, and `above`; f has one change of sign there.
template <class Function>
double bisect(Function f, double below, double above) {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (below + above);
    (f(middle) < 0.0 ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

OperatingPoint linearised(const DesignPlant& plant, double wind_mps, double pitch_rad) {
  const RotorAero::TorqueSlopes slopes =
      plant.aero.torque_slopes(wind_mps, plant.rated_rotor_speed_radps(), pitch_rad);
  return {wind_mps, pitch_rad, slopes.per_rotor_speed / plant.inertia_kgm2,
          slopes.per_pitch / plant.inertia_kgm2};
}

/// Torque left over at rated speed.
double surplus_Nm(const DesignPlant& plant, double wind_mps, double pitch_rad) {
  return plant.aero.torque_Nm(wind_mps, plant.rated_rotor_speed_radps(), pitch_rad) -
         plant.rated_rotor_torque_Nm();
}

LimitedPi::Gains pitch_gains(const DesignPlant& plant, const OperatingPoint& point,
                             const LoopTarget& target, bool constant_power) {
  const double destabilising =
      constant_power
          ? plant.rated_rotor_torque_Nm() / (plant.inertia_kgm2 * plant.rated_rotor_speed_radps())
          : 0.0;
  const double w = target.frequency_radps;
  const double k_p = -(2.0 * target.damping * w + point.speed_pole_per_s + destabilising) /
                     (point.pitch_effect_per_s2 * plant.gearbox_ratio);
  const double k_i = -w * w / (point.pitch_effect_per_s2 * plant.gearbox_ratio);
  if (k_p <= 0.0) {
    throw Error(
        printed("at %.4g m/s the rotor alone is damped more than the target asks for "
                "(A_eff = %.4g 1/s); expected a higher damping or frequency",
                point.wind_mps, point.speed_pole_per_s + destabilising));
  }
  return {k_p, k_p / k_i};
}

}  // namespace

OperatingPoint point_above_rated(const DesignPlant& plant, double wind_mps) {
  double low = plant.fine_pitch_rad;
  if (surplus_Nm(plant, wind_mps, low) < 0.0) {
    throw Error(
        printed("%.4g m/s is below rated: at fine pitch and rated speed the rotor gives "
                "%.4g MNm less than rated torque",
                wind_mps, -1e-6 * surplus_Nm(plant, wind_mps, low)));
  }
  for (const double high : plant.aero.table.pitch_rad()) {
    if (high <= low) continue;
    if (surplus_Nm(plant, wind_mps, high) < 0.0) {
      const auto shortage = [&](double pitch) { return -surplus_Nm(plant, wind_mps, pitch); };
      const OperatingPoint point = linearised(plant, wind_mps, bisect(shortage, low, high));
      if (point.pitch_effect_per_s2 < 0.0) return point;
      throw Error(printed("at %.4g m/s and %.4g deg the torque does not fall with pitch", wind_mps,
                          deg_from_rad(point.pitch_rad)));
    }
    low = high;
  }
  throw Error(
      printed("at %.4g m/s the rotor gives more than rated torque at every pitch of its "
              "table (up to %.4g deg)",
              wind_mps, deg_from_rad(low)));
}

OperatingPoint rated_point(const DesignPlant& plant) {
  const auto surplus = [&](double wind) { return surplus_Nm(plant, wind, plant.fine_pitch_rad); };
  double low =
      plant.rated_rotor_speed_radps() * plant.aero.radius_m / plant.aero.table.tsr().back();
  const double first = low;
  const int steps = static_cast<int>((kHighestWind_mps - first) / kWindStep_mps);
  for (int i = 1; i <= steps; ++i) {
    const double high = first + i * kWindStep_mps;
    if (surplus(high) >= 0.0) {
      return linearised(plant, bisect(surplus, low, high), plant.fine_pitch_rad);
    }
    low = high;
  }
  throw Error(
      printed("the rotor does not reach rated torque (%.4g MNm on its side) at rated speed "
              "up to %.4g m/s",
              1e-6 * plant.rated_rotor_torque_Nm(), kHighestWind_mps));
}

PitchGainSchedule design_pitch_gains(const DesignPlant& plant, const std::vector<double>& winds_mps,
                                     const LoopTarget& target, bool constant_power) {
  std::vector<double> pitch_rad;
  std::vector<double> proportional_s;
  std::vector<double> integral_time_s;
  for (const double wind : winds_mps) {
    const OperatingPoint point = point_above_rated(plant, wind);
    const LimitedPi::Gains gains = pitch_gains(plant, point, target, constant_power);
    pitch_rad.push_back(point.pitch_rad);
    proportional_s.push_back(gains.proportional);
    integral_time_s.push_back(gains.integral_time_s);
  }
  return {{pitch_rad, proportional_s}, {pitch_rad, integral_time_s}};
}

LimitedPi::Gains design_torque_gains(const DesignPlant& plant, const LoopTarget& target) {
  const OperatingPoint point = rated_point(plant);
  const double w = target.frequency_radps;
  const double damping_sum = 2.0 * target.damping * w + point.speed_pole_per_s;
  if (damping_sum <= 0.0) {
    throw Error(
        printed("at rated wind %.4g m/s the rotor alone is damped more than the torque "
                "loop's target asks for (A = %.4g 1/s); expected a higher damping or "
                "frequency",
                point.wind_mps, point.speed_pole_per_s));
  }
  const double inertia =
      plant.inertia_kgm2 * plant.gearbox_efficiency / (plant.gearbox_ratio * plant.gearbox_ratio);
  return {damping_sum * inertia, damping_sum / (w * w)};
}

double design_optimal_gain(const DesignPlant& plant) {
  const double i = plant.gearbox_ratio;
  return plant.aero.optimal_torque_gain_Nms2prad2(plant.fine_pitch_rad) * plant.gearbox_efficiency /
         (i * i * i);
}

}  // namespace lac
