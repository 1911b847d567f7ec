// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/blade_blockage.hpp"

#include <cmath>
#include <utility>

#include "core/units.hpp"

namespace lac::sim {
namespace {

std::vector<double> per_radius(YamlReader& in, const std::string& key, std::size_t count,
                               Range range) {
  std::vector<double> values = in.numbers(key, range);
  if (values.size() != count) {
    in.fail(key, "found " + std::to_string(values.size()) + " values, expected " +
                     std::to_string(count) + ", one per value of radius_m");
  }
  return values;
}

}  // namespace

BladeShape load_blade(const std::filesystem::path& file) {
  YamlReader in = YamlReader::load(file);
  const std::vector<double> radius_m = in.numbers("radius_m", Range::not_negative());
  if (radius_m.size() < 2) in.fail("radius_m", "found one value, expected two or more");
  for (std::size_t i = 1; i < radius_m.size(); ++i) {
    if (radius_m[i] <= radius_m[i - 1]) in.fail("radius_m", "expected radii that rise");
  }
  const std::size_t count = radius_m.size();
  const std::vector<double> chord_m = per_radius(in, "chord_m", count, Range::positive());
  std::vector<double> thickness_m =
      per_radius(in, "relative_thickness", count, Range::between(0.0, 1.0));
  std::vector<double> twist_rad = per_radius(in, "twist_deg", count, Range::between(-90.0, 90.0));
  in.finish();
  for (std::size_t i = 0; i < count; ++i) {
    thickness_m[i] *= chord_m[i];
    twist_rad[i] = rad_from_deg(twist_rad[i]);
  }
  return {{radius_m, chord_m}, {radius_m, thickness_m}, {radius_m, twist_rad}};
}

BladeBlockageParams read_blade_blockage(YamlReader& in) {
  BladeBlockageParams p;
  p.enabled = true;
  p.blade = load_blade(in.existing_file("blade"));
  p.beam_radius_m = in.number("beam_radius_m", p.beam_radius_m, Range::between(0.0, 1.0));
  return p;
}

BladeBlockage::BladeBlockage(BladeBlockageParams params, int number_of_blades)
    : params_(std::move(params)), number_of_blades_(number_of_blades) {}

bool BladeBlockage::blocked(const LidarRay& ray, double rotor_azimuth_rad,
                            double pitch_rad) const noexcept {
  if (!params_.enabled || ray.origin_N_m.x <= 0.0 || ray.direction_N.x >= 0.0) return false;
  for (int k = 0; k < number_of_blades_; ++k) {
    const double azimuth_rad = rotor_azimuth_rad + 2.0 * kPi * k / number_of_blades_;
    if (blocked_by_blade(ray, azimuth_rad, pitch_rad)) return true;
  }
  return false;
}

bool BladeBlockage::blocked_by_blade(const LidarRay& ray, double azimuth_rad,
                                     double pitch_rad) const noexcept {
  const Vec3 along{0.0, -std::sin(azimuth_rad), std::cos(azimuth_rad)};
  const Vec3 forward{0.0, -std::cos(azimuth_rad), -std::sin(azimuth_rad)};  // way of rotation
  const double start_t_m = dot(ray.origin_N_m, forward), start_x_m = ray.origin_N_m.x;
  const double way_t = dot(ray.direction_N, forward), way_x = ray.direction_N.x;
  const double square = way_t * way_t + way_x * way_x;
  const double nearest_m = -(start_t_m * way_t + start_x_m * way_x) / square;
  const double radius_m = dot(ray.origin_N_m + nearest_m * ray.direction_N, along);
  const BladeShape& blade = params_.blade;
  if (radius_m < blade.root_m() || radius_m > blade.tip_m()) return false;
  const double turn_rad = blade.twist_rad.at(radius_m) + pitch_rad;
  const double across_t = -way_x / std::sqrt(square), across_x = way_t / std::sqrt(square);
  const double chordwise = across_t * std::cos(turn_rad) - across_x * std::sin(turn_rad);
  const double thickwise = across_t * std::sin(turn_rad) + across_x * std::cos(turn_rad);
  const double half_width_m = 0.5 * std::hypot(blade.chord_m.at(radius_m) * chordwise,
                                               blade.thickness_m.at(radius_m) * thickwise);
  const double distance_m = std::abs(across_t * start_t_m + across_x * start_x_m);
  return distance_m <= half_width_m + params_.beam_radius_m;
}

}  // namespace lac::sim
