// SPDX-License-Identifier: Apache-2.0
#include "core/rotor_aero.hpp"

#include <algorithm>

#include "core/units.hpp"

namespace lac {

double RotorAero::disk_factor_kgpm() const noexcept {
  return 0.5 * air_density_kgpm3 * kPi * radius_m * radius_m;
}

RotorAero::Loads RotorAero::loads(double wind_mps, double rotor_speed_radps,
                                  double pitch_rad) const noexcept {
  if (wind_mps <= 0.0) return {};
  const double tsr =
      std::clamp(rotor_speed_radps * radius_m / wind_mps, table.tsr().front(), table.tsr().back());
  const RotorTable::Coefficients c = table.at(tsr, pitch_rad);
  const double force_N = disk_factor_kgpm() * wind_mps * wind_mps;
  return {force_N * radius_m * c.cp / tsr, force_N * c.ct};
}

RotorAero::TorqueSlopes RotorAero::torque_slopes(double wind_mps, double rotor_speed_radps,
                                                 double pitch_rad) const noexcept {
  const double tsr = rotor_speed_radps * radius_m / wind_mps;
  const double torque_per_cp =
      disk_factor_kgpm() * wind_mps * wind_mps * wind_mps / rotor_speed_radps;
  const double cp = table.cp(tsr, pitch_rad);
  const double tsr_slope = table.dcp_dtsr(tsr, pitch_rad);
  return {torque_per_cp * (3.0 * cp - tsr_slope * tsr) / wind_mps,
          torque_per_cp * (tsr_slope * tsr - cp) / rotor_speed_radps,
          torque_per_cp * table.dcp_dpitch_per_rad(tsr, pitch_rad)};
}

double RotorAero::optimal_torque_gain_Nms2prad2(double min_pitch_rad) const noexcept {
  const RotorTable::Optimum best = table.optimum(min_pitch_rad);
  const double radius_cubed = radius_m * radius_m * radius_m;
  return disk_factor_kgpm() * radius_cubed * best.cp / (best.tsr * best.tsr * best.tsr);
}

}  // namespace lac
