// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/flow_case.hpp"

#include <algorithm>
#include <ostream>

#include "core/units.hpp"

namespace lac::sim {

FlowShape read_shape(YamlReader& in, bool with_shear) {
  FlowShape shape;
  if (in.has("fluctuation_scale")) {
    const std::vector<double> scale = in.numbers("fluctuation_scale", Range::not_negative());
    if (scale.size() != 3) in.fail("fluctuation_scale", "expected three numbers, for u, v and w");
    std::copy(scale.begin(), scale.end(), shape.fluctuation_scale.begin());
  }
  if (with_shear)
    shape.shear_exponent = in.number("shear_exponent", 0.0, Range::between(-1.0, 1.0));
  shape.veer_radpm = rad_from_deg(in.number("veer_deg_per_m", 0.0, Range::between(-1.0, 1.0)));
  return shape;
}

namespace {

/// From the rotor to the farthest point that the lidar may ask for.
double wanted_reach_m(const WindDemand& lidar) {
  double farthest_m = 0.0;
  for (const Vec3& point : lidar.points_I_m) farthest_m = std::max(farthest_m, -point.x);
  return farthest_m + lidar.margin_m;
}

}  // namespace

FlowDirection read_direction(YamlReader& in, const WindDemand* lidar) {
  FlowDirection d;
  d.yaw_rad = rad_from_deg(in.number("yaw_deg", 0.0, Range::between(-79.0, 79.0)));
  d.upflow_rad = rad_from_deg(in.number("upflow_deg", 0.0, Range::between(-79.0, 79.0)));
  const double wanted_m = d.turns() && lidar != nullptr ? wanted_reach_m(*lidar) : 0.0;
  d.reach_m = in.number("reach_m", std::max(d.reach_m, wanted_m), Range::not_negative());
  if (d.reach_m < wanted_m) {
    in.fail("reach_m", "found " + shortest(d.reach_m) + ", expected at least " +
                           shortest(wanted_m) +
                           ": so far up-wind the lidar measures, motion included (or leave the key "
                           "out)");
  }
  return d;
}

void describe(const FlowShape& shape, std::ostream& out) {
  if (shape.fluctuation_scale != FlowShape{}.fluctuation_scale) {
    const auto& s = shape.fluctuation_scale;
    out << ", fluctuations times " << s[0] << ", " << s[1] << ", " << s[2];
  }
  if (shape.shear_exponent != 0.0) out << ", shear exponent " << shape.shear_exponent;
  if (shape.veer_radpm != 0.0) out << ", veer " << deg_from_rad(shape.veer_radpm) << " deg/m";
}

void describe(const FlowDirection& direction, std::ostream& out) {
  if (direction.yaw_rad != 0.0) out << ", yaw " << deg_from_rad(direction.yaw_rad) << " deg";
  if (direction.upflow_rad != 0.0)
    out << ", upflow " << deg_from_rad(direction.upflow_rad) << " deg";
}

}  // namespace lac::sim
