// SPDX-License-Identifier: Apache-2.0
// Case files: what is done to a wind once it is there.
#pragma once

#include <iosfwd>

#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/wind/flow_shape.hpp"
#include "sim_harness/wind/turned_wind.hpp"
#include "sim_harness/wind/wind_demand.hpp"

namespace lac::sim {

/// Keys fluctuation_scale, veer_deg_per_m and, if with_shear (the source has no key of that name),
/// shear_exponent.
FlowShape read_shape(YamlReader& in, bool with_shear);

/// Keys yaw_deg, upflow_deg, reach_m (250, or what the lidar needs if that is more). Throws
/// lac::Error if the wind turns and the lidar (nullptr: none) measures farther up-wind than
/// reach_m.
FlowDirection read_direction(YamlReader& in, const WindDemand* lidar);

/// For reports, each part led by a comma; nothing where nothing is done.
void describe(const FlowShape& shape, std::ostream& out);
void describe(const FlowDirection& direction, std::ostream& out);

}  // namespace lac::sim
