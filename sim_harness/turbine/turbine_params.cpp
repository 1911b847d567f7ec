// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/turbine/turbine_params.hpp"

#include "core/units.hpp"
#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

namespace {

const Range kFraction{0.0, 1.0, false};

RotorAero read_rotor(YamlReader& file, int& number_of_blades) {
  YamlReader map = file.map("rotor");
  number_of_blades = map.integer("number_of_blades", Range::between(1.0, 6.0));
  const double radius_m = map.number("radius_m", Range::positive());
  const double air_density_kgpm3 = map.number("air_density_kgpm3", Range::positive());
  const std::filesystem::path table = map.existing_file("performance_table");
  map.finish();
  return {RotorTable::load(table), radius_m, air_density_kgpm3};
}

void read_drive_train(YamlReader map, TurbineParams& p) {
  p.gearbox_ratio = map.number("gearbox_ratio", Range::positive());
  p.gearbox_efficiency = map.number("gearbox_efficiency", kFraction);
  p.inertia_kgm2 = map.number("inertia_low_speed_shaft_kgm2", Range::positive());
  map.finish();
}

void read_generator(YamlReader map, TurbineParams& p) {
  p.generator_efficiency = map.number("efficiency", kFraction);
  p.rated_power_W = 1e3 * map.number("rated_power_kW", Range::positive());
  p.rated_torque_Nm = 1e3 * map.number("rated_torque_kNm", Range::positive());
  p.max_torque_Nm = 1e3 * map.number("max_torque_kNm", Range::positive());
  if (p.max_torque_Nm < p.rated_torque_Nm) {
    map.fail("max_torque_kNm", "found less than rated_torque_kNm, expected that or more");
  }
  p.generator_lag.torque_rate_limit_Nmps =
      1e3 * map.number("torque_rate_limit_kNmps", Range::positive());
  p.generator_lag.time_constant_s = map.number("lag_time_constant_s", Range::not_negative());
  map.finish();
}

void read_operation(YamlReader map, TurbineParams& p) {
  p.rated_rotor_speed_radps =
      radps_from_rpm(map.number("rated_rotor_speed_rpm", Range::positive()));
  p.region2_gain_Nms2prad2 = map.number("region2_gain_Nms2prad2", Range::positive());
  p.cut_in_wind_mps = map.number("cut_in_wind_mps", Range::positive());
  p.cut_out_wind_mps = map.number("cut_out_wind_mps", Range::positive());
  if (p.cut_out_wind_mps <= p.cut_in_wind_mps) {
    map.fail("cut_out_wind_mps",
             "found no more than cut_in_wind_mps, expected a larger wind speed");
  }
  p.fine_pitch_rad = rad_from_deg(map.number("fine_pitch_deg"));
  map.finish();
}

void read_pitch(YamlReader map, TurbineParams& p) {
  p.min_pitch_rad = rad_from_deg(map.number("min_pitch_deg"));
  p.max_pitch_rad = rad_from_deg(map.number("max_pitch_deg"));
  if (p.max_pitch_rad <= p.min_pitch_rad) {
    map.fail("max_pitch_deg", "found no more than min_pitch_deg, expected a larger angle");
  }
  p.pitch_actuator.enabled = map.flag("actuator_enabled");
  p.pitch_actuator.frequency_radps = map.number("actuator_frequency_radps", Range::positive());
  p.pitch_actuator.damping_ratio = map.number("actuator_damping_ratio", Range::positive());
  p.pitch_actuator.rate_limit_radps =
      rad_from_deg(map.number("rate_limit_degps", Range::positive()));
  map.finish();
}

void read_tower(YamlReader map, TurbineParams& p) {
  const double omega_radps = radps_from_hz(map.number("frequency_Hz", Range::positive()));
  p.hub_height_m = map.number("hub_height_m", Range::positive());
  if (p.hub_height_m <= p.rotor.radius_m) {
    map.fail("hub_height_m",
             "found no more than rotor.radius_m, expected a rotor above the ground");
  }
  p.tower.mass_kg = map.number("mass_kg", Range::positive());
  p.tower.stiffness_Npm = p.tower.mass_kg * omega_radps * omega_radps;
  p.tower.damping_Nspm =
      2.0 * map.number("damping_ratio", Range::not_negative()) * p.tower.mass_kg * omega_radps;
  p.tower.rest_offset_m = map.number("rest_offset_m");
  map.finish();
}

}  // namespace

TurbineParams load_turbine(const std::filesystem::path& path) {
  YamlReader file = YamlReader::load(path);
  int number_of_blades = 0;
  TurbineParams p{.rotor = read_rotor(file, number_of_blades)};
  p.number_of_blades = number_of_blades;
  p.name = file.text("name");
  read_drive_train(file.map("drive_train"), p);
  read_generator(file.map("generator"), p);
  read_operation(file.map("operation"), p);
  read_pitch(file.map("pitch"), p);
  read_tower(file.map("tower"), p);
  file.finish();
  return p;
}

}  // namespace lac::sim
