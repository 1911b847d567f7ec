// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/flight.hpp"

#include <array>
#include <cmath>

#include "core/units.hpp"
#include "sim_harness/host/controller_host.hpp"
#include "sim_harness/run/lidar_on_board.hpp"
#include "sim_harness/turbine/simulated_turbine.hpp"

namespace lac::sim {
namespace {

constexpr double kFullTurn_rad = 2.0 * kPi;

/// The library alone.
HostSetup library_setup(const CaseController& controller) {
  HostSetup s;
  if (!controller.library.empty()) s.library = controller.library;
  s.library_folders = folders_beside_program();
  s.entry = controller.entry;
  return s;
}

HostSetup host_setup(const Case& c, const CaseController& controller, const OperatingPoint& start,
                     double mean_wind_mps, const std::filesystem::path& output_root) {
  const TurbineParams& t = c.turbine;
  HostSetup s = library_setup(controller);
  s.input_file = controller.input_file.string();
  s.output_root = output_root.string();
  s.time_step_s = c.time.step_s;
  s.number_of_blades = t.number_of_blades;
  s.initial_pitch_rad = start.pitch_rad;
  s.fine_pitch_rad = t.fine_pitch_rad;
  s.min_pitch_rad = t.min_pitch_rad;
  s.max_pitch_rad = t.max_pitch_rad;
  s.pitch_rate_limit_radps = t.pitch_actuator.rate_limit_radps;
  s.rated_generator_speed_radps = t.rated_rotor_speed_radps * t.gearbox_ratio;
  s.rated_torque_Nm = t.rated_torque_Nm;
  s.rated_power_W = t.rated_power_W;
  s.generator_efficiency = t.generator_efficiency;
  s.air_density_kgpm3 = t.rotor.air_density_kgpm3;
  s.mean_wind_mps = mean_wind_mps;
  return s;
}

HostInputs measured(const SlowOutputs& o, const TurbineParams& t, double hub_wind_mps,
                    double azimuth_rad) {
  HostInputs in;
  in.pitch_rad = o.pitch_rad;
  in.rotor_speed_radps = o.rotor_speed_radps;
  in.generator_speed_radps = o.generator_speed_radps;
  in.shaft_torque_Nm = t.gearbox_ratio * o.generator_torque_Nm / t.gearbox_efficiency;
  in.thrust_N = o.thrust_N;
  in.hub_wind_mps = hub_wind_mps;
  in.tower_acceleration_mps2 = o.tower_a_mps2;
  in.azimuth_rad = azimuth_rad;
  return in;
}

void record(const SlowOutputs& o, const HostDemands& d, double rews_mps, double hub_wind_mps,
            Recording& recording) {
  const std::array<double, 14> row{rews_mps,
                                   hub_wind_mps,
                                   rpm_from_radps(o.rotor_speed_radps),
                                   rpm_from_radps(o.generator_speed_radps),
                                   deg_from_rad(o.pitch_rad),
                                   deg_from_rad(d.pitch_rad),
                                   deg_from_rad(o.pitch_rate_radps),
                                   1e-3 * o.generator_torque_Nm,
                                   1e-3 * d.torque_Nm,
                                   1e-3 * o.electrical_power_W,
                                   o.tower_x_m,
                                   o.tower_a_mps2,
                                   1e-3 * o.tower_base_moment_Nm,
                                   1e-3 * o.thrust_N};
  std::array<float, row.size()> values{};
  for (std::size_t i = 0; i < row.size(); ++i) values[i] = static_cast<float>(row[i]);
  recording.append(values.data());
}

double hub_wind_at(const WindField& wind, double hub_height_m, double time_s) {
  const Vec3 u = wind.velocity({0.0, 0.0, hub_height_m}, time_s);
  return std::hypot(u.x, u.y);
}

}  // namespace

std::vector<TableChannel> flight_channels() {
  return {{"RtVAvgxh", "m/s"},       {"WindHubVelH", "m/s"}, {"RotSpeed", "rpm"},
          {"GenSpeed", "rpm"},       {"BldPitch1", "deg"},   {"BldPitchDem", "deg"},
          {"BldPitchRate", "deg/s"}, {"GenTq", "kNm"},       {"GenTqDem", "kNm"},
          {"GenPwr", "kW"},          {"TTDspFA", "m"},       {"YawBrTAxp", "m/s^2"},
          {"TwrBsMyt", "kNm"},       {"RotThrust", "kN"}};
}

TurbineState turbine_state(const SlowOutputs& o, const TurbineParams& t, double rotor_wind_mps,
                           double azimuth_rad) {
  const double wind_mps = rotor_wind_mps - o.tower_v_mps;
  const double wind_force_N = t.rotor.disk_factor_kgpm() * wind_mps * wind_mps;
  return {.tower_x_m = o.tower_x_m,
          .tower_v_mps = o.tower_v_mps,
          .azimuth_rad = azimuth_rad,
          .rotor_speed_radps = o.rotor_speed_radps,
          .pitch_rad = o.pitch_rad,
          .thrust_coefficient = wind_mps > 0.0 ? o.thrust_N / wind_force_N : 0.0};
}

bool can_fly_in_threads(const CaseController& controller) {
  const HostSetup s = library_setup(controller);
  return DisconLibrary::open(s.library, s.entry, s.library_folders).is_reentrant();
}

Recording fly(const Case& c, const CaseController& controller, const WindField& wind,
              const RotorWind& rotor_wind, const std::filesystem::path& output_root,
              const FlightReport& report) {
  const double dt_s = c.time.step_s;
  const std::int64_t steps = c.time.steps();
  const OperatingPoint start = steady_state(c.turbine, rotor_wind.at(0.0));
  SimulatedTurbine turbine(c.turbine);
  turbine.start(start);
  LidarOnBoard lidar(c, wind);
  NacelleAnemometer anemometer(c.anemometer, c.seed, dt_s);
  ControllerHost host(host_setup(c, controller, start, wind.mean_speed_mps(), output_root),
                      report.on_warning);
  Recording recording(flight_channels(), 0.0, dt_s, static_cast<std::size_t>(steps) + 1);

  double azimuth_rad = 0.0;
  double rews_mps = rotor_wind.at(0.0);
  for (std::int64_t n = 0; n <= steps; ++n) {
    const double time_s = static_cast<double>(n) * dt_s;
    const SlowOutputs now = turbine.outputs();
    const double hub_wind_mps = hub_wind_at(wind, c.turbine.hub_height_m, time_s);
    const TurbineState state = turbine_state(now, c.turbine, rews_mps, azimuth_rad);
    lidar.sense(n, state, host);

    const double nacelle_wind_mps = anemometer.measure(hub_wind_mps, state.thrust_coefficient);
    const HostDemands demands = host.call(measured(now, c.turbine, nacelle_wind_mps, azimuth_rad));
    record(now, demands, rews_mps, hub_wind_mps, recording);
    report.on_progress(static_cast<double>(n) / static_cast<double>(steps));
    if (n == steps) break;

    const double next_rews_mps = rotor_wind.at(static_cast<double>(n + 1) * dt_s);
    turbine.advance(
        dt_s, {rews_mps, (next_rews_mps - rews_mps) / dt_s, demands.pitch_rad, demands.torque_Nm});
    rews_mps = next_rews_mps;
    azimuth_rad = std::fmod(azimuth_rad + now.rotor_speed_radps * dt_s, kFullTurn_rad);
  }
  host.finish();
  return recording;
}

}  // namespace lac::sim
