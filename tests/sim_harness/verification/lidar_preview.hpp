// SPDX-License-Identifier: Apache-2.0
// Rotor-effective wind speed and its lidar estimate from a simulated field, as series that repeat
// with it.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/units.hpp"
#include "sim_harness/lidar/lidar_sim.hpp"
#include "sim_harness/wind/rotor_wind.hpp"

namespace lac::sim {

/// GUO's four beams taken at once, the volume sampled finely, gates along the viewing axis.
inline LidarParams preview_lidar(const std::vector<double>& gates_m, double step_s) {
  LidarParams lidar;
  for (const double azimuth_deg : {14.4, -14.4}) {
    for (const double elevation_deg : {14.0, -14.0}) {
      LidarBeam& beam = lidar.scan.beams.emplace_back();
      beam.azimuth_rad = rad_from_deg(azimuth_deg);
      beam.elevation_rad = rad_from_deg(elevation_deg);
    }
  }
  lidar.scan.simultaneous = true;
  lidar.scan.beam_time_s = step_s;
  lidar.gates_m = gates_m;
  lidar.gates_along_beam = false;
  lidar.weighting.points = 41;
  return lidar;
}

/// Mean over beams and gates of v_los / n_x at every scan of the period, placed at its arrival at
/// the rotor. The lead of every gate must be a number of scans.
inline std::vector<double> lidar_estimate(const WindField& field, const LidarParams& lidar,
                                          double hub_height_m, std::size_t samples) {
  constexpr int kCallsPerScan = 4;  // beams are handed over one at a time
  const double step_s = lidar.scan.beam_time_s;
  LidarSim sim(lidar, field,
               {hub_height_m, step_s / kCallsPerScan, static_cast<double>(samples) * step_s});
  const auto volumes = static_cast<double>(lidar.scan.beams.size() * lidar.gates_m.size());
  std::vector<double> estimate(samples, 0.0);
  LidarMeasurement m;
  for (std::size_t taken = 0, call = 0; taken < samples * lidar.scan.beams.size(); ++call) {
    if (!sim.step(static_cast<std::int64_t>(call), {}, m)) continue;
    ++taken;
    const double n_x = m.beam_dir_I().x;
    for (int g = 0; g < m.gate_count; ++g) {
      const double arrival_s = m.time_s - m.gates[g].range_m * n_x / field.mean_speed_mps();
      const auto step = static_cast<std::size_t>(std::lround(arrival_s / step_s));
      estimate[step % samples] += m.gates[g].speed_mps / (-n_x * volumes);
    }
  }
  return estimate;
}

inline std::vector<double> rotor_speed(const WindField& field, double radius_m, double hub_height_m,
                                       double step_s, std::size_t samples) {
  RotorWindParams params;
  params.radius_m = radius_m;
  params.hub_height_m = hub_height_m;
  params.dt_s = step_s;
  params.t_end_s = static_cast<double>(samples) * step_s;
  const RotorWind rotor(field, params);
  return {rotor.samples_mps().begin(), rotor.samples_mps().begin() + samples};
}

}  // namespace lac::sim
