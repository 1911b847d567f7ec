// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/lookup_table.hpp"
#include "core/vec3.hpp"
#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {

/// Sections of a blade over the distance from the rotor axis; straight lines between.
struct BladeShape {
  LookupTable chord_m;
  LookupTable thickness_m;
  LookupTable twist_rad;

  double root_m() const { return chord_m.x().front(); }
  double tip_m() const { return chord_m.x().back(); }
};

/// Blade file (config/turbines/<name>/blade.yaml): lists radius_m (rising, from the rotor axis),
/// chord_m, relative_thickness (0 ... 1), twist_deg. Throws lac::Error.
BladeShape load_blade(const std::filesystem::path& file);

struct BladeBlockageParams {
  bool enabled = false;
  BladeShape blade;
  double beam_radius_m = 0.0;  // at the rotor plane
};

/// Map `blade_blockage`: blade (file), beam_radius_m (0). Throws lac::Error.
BladeBlockageParams read_blade_blockage(YamlReader& in);

/// One ray from the lidar: where it starts, from the rotor centre, and where it points. Frame N.
struct LidarRay {
  Vec3 origin_N_m;
  Vec3 direction_N;
};

/// Whether a blade stands in the beam of a lidar behind the rotor.
///
/// A blade is straight along its pitch axis in the rotor plane, blade 1 upwards at azimuth 0 and
/// turning clockwise seen from up-wind; its sections are ellipses (chord, thickness) about that
/// axis, turned by twist + pitch out of the rotor plane, leading edge up-wind. Seen along the
/// blade, the beam is a straight line: it is blocked if it passes the axis within the half width
/// of the ellipse across the line plus the beam's radius, between root and tip.
///
/// For a lidar on the rotor axis and flat sections in the rotor plane the share of time blocked at
/// the radius r is (blades / pi) asin((c/2)/r), which for c << r is blades c / (2 pi r). A lidar in
/// the rotor plane or ahead of it (spinner) is never blocked. Judged at one instant per
/// measurement; tower, nacelle, cone and bending are left out.
class BladeBlockage {
 public:
  BladeBlockage(BladeBlockageParams params, int number_of_blades);

  bool blocked(const LidarRay& ray, double rotor_azimuth_rad, double pitch_rad) const noexcept;

 private:
  bool blocked_by_blade(const LidarRay& ray, double azimuth_rad, double pitch_rad) const noexcept;

  BladeBlockageParams params_;
  int number_of_blades_;
};

}  // namespace lac::sim
