// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/beam_samples.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/lidar_block.hpp"

namespace lac::sim {
namespace {

constexpr double kGridRounding = 1e-9;  // of a step

void add_point(double range_m, BeamSamples& beam) {
  beam.gates.push_back({range_m, beam.points_m.size(), {1.0}});
  beam.points_m.push_back(range_m);
}

void scale_to_one(std::vector<double>& weights) {
  double sum = 0.0;
  for (const double w : weights) sum += w;
  for (double& w : weights) w /= sum;
}

/// On the grid that begins with the first point of the beam.
void add_on_grid(const RangeWeighting& weighting, double range_m, BeamSamples& beam) {
  const double reach_m = weighting.reach_m();
  const double step_m = 2.0 * reach_m / (weighting.points - 1);
  if (beam.points_m.empty()) beam.points_m.push_back(range_m - reach_m);
  const double origin_m = beam.points_m.front();
  const auto grid_m = [&](int j) { return origin_m + j * step_m; };
  const auto steps_to = [&](double r_m) { return (r_m - origin_m) / step_m; };
  const int low = static_cast<int>(std::ceil(steps_to(range_m - reach_m) - kGridRounding));
  const int high = static_cast<int>(std::floor(steps_to(range_m + reach_m) + kGridRounding));
  const int last = static_cast<int>(std::lround(steps_to(beam.points_m.back())));
  for (int j = std::max(low, last + 1); j <= high; ++j) beam.points_m.push_back(grid_m(j));
  GateSamples gate{range_m, beam.points_m.size() - static_cast<std::size_t>(high - low) - 1, {}};
  for (int j = low; j <= high; ++j) gate.weights.push_back(weighting.shape(grid_m(j) - range_m));
  scale_to_one(gate.weights);
  beam.gates.push_back(std::move(gate));
}

/// Trapezoidal rule over t = asinh(s/z_R), in which phi ds is 1/(pi cosh t) dt.
void add_lorentzian(const RangeWeighting& weighting, double range_m, BeamSamples& beam) {
  const double rayleigh_m = weighting.rayleigh_m(range_m);
  const double reach = std::min(weighting.reach_rayleigh, range_m / rayleigh_m);
  const int half = weighting.points / 2;
  GateSamples gate{range_m, beam.points_m.size(), {}};
  for (int j = -half; j <= half; ++j) {
    const double t = std::asinh(reach) * j / half;
    beam.points_m.push_back(range_m + rayleigh_m * std::sinh(t));
    gate.weights.push_back((std::abs(j) == half ? 0.5 : 1.0) / std::cosh(t));
  }
  scale_to_one(gate.weights);
  beam.gates.push_back(std::move(gate));
}

void add_gate(const RangeWeighting& weighting, double range_m, BeamSamples& beam) {
  if (weighting.is_point()) {
    add_point(range_m, beam);
  } else if (weighting.kind == ProbeKind::kLorentzian) {
    add_lorentzian(weighting, range_m, beam);
  } else {
    add_on_grid(weighting, range_m, beam);
  }
}

}  // namespace

double BeamSamples::nearest_m() const {
  return *std::min_element(points_m.begin(), points_m.end());
}

double BeamSamples::farthest_m() const {
  return *std::max_element(points_m.begin(), points_m.end());
}

BeamSamples make_beam_samples(const LidarParams& lidar, const LidarBeam& beam) {
  BeamSamples samples;
  samples.dir_L = beam_direction(beam.azimuth_rad, beam.elevation_rad);
  for (const double distance_m : beam.gates_m.empty() ? lidar.gates_m : beam.gates_m) {
    const double range_m = lidar.gates_along_beam ? distance_m : distance_m / samples.dir_L.x;
    add_gate(lidar.weighting, range_m, samples);
  }
  return samples;
}

std::vector<BeamSamples> make_beam_samples(const LidarParams& lidar) {
  std::vector<BeamSamples> beams;
  for (const LidarBeam& beam : lidar.scan.beams) {
    beams.push_back(make_beam_samples(lidar, beam));
    const std::size_t gates = beams.back().gates.size();
    if (gates >= 1 && gates <= native_lidar::kMaxGates) continue;
    throw Error("lidar: beam " + std::to_string(beams.size()) + " has " + std::to_string(gates) +
                " gates, expected 1 to " + std::to_string(native_lidar::kMaxGates) +
                ", as the lidar block of the swap array carries");
  }
  return beams;
}

}  // namespace lac::sim
