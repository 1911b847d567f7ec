// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/wind/field_file.hpp"
#include "sim_harness/wind/flow_shape.hpp"
#include "sim_harness/wind/kaimal_field.hpp"
#include "sim_harness/wind/mann_field.hpp"
#include "sim_harness/wind/turned_wind.hpp"
#include "sim_harness/wind/uniform_wind.hpp"
#include "sim_harness/wind/wind_demand.hpp"

namespace lac::sim {

/// Frozen without planes, else evolving: planes at these distances up-wind and at the rotor.
struct KaimalWind {
  KaimalFieldParams field;
  std::vector<double> planes_m;
};
struct MannWind {
  MannFieldParams field;
  std::vector<double> planes_m;
};

/// Where the wind comes from.
using WindSource = std::variant<UniformWindParams, KaimalWind, MannWind, FieldFile>;

/// The wind of a case before it is made: a source, and what is done to it.
struct WindCase {
  WindSource source;
  FlowShape shape = {};  // of gridded sources
  FlowDirection direction = {};
  double hub_height_m = 90.0;    // centre of the turn
  double rotor_radius_m = 63.0;  // of what is wanted of turned planes
};

/// What of the turbine the standard's wind conditions depend on, and what else decides.
struct WindSurroundings {
  double hub_height_m = 90.0;
  double rotor_radius_m = 63.0;
  std::uint64_t seed = 1;
  std::optional<WindDemand> lidar = {};  // of the case's lidar, if it has one
};

/// Key kind and the keys of that kind (listed in config/README.md). Throws lac::Error.
WindCase read_wind(YamlReader& in, const WindSurroundings& around);

/// Builds or reads the field. Evolving wind keeps its rotor plane and, of the others, what the
/// demand asks for; nullptr: all of it. Throws lac::Error.
std::unique_ptr<WindField> make_wind(const WindCase& wind, const WindDemand* demand = nullptr);

/// Whether the wind has planes up-wind of which a demand says what is kept; any other wind is the
/// same whatever is demanded.
bool evolves(const WindCase& wind);

/// A line that says the standard deviation of u that generated wind is expected to have, if it
/// differs by more than 2 % from the one asked for; else nothing. The grid of frequencies leaves
/// out what is slower than the period or faster than the time step. (Mann: tabulates the box
/// again.)
std::string held_turbulence(const WindCase& wind);

/// One line for reports: "Kaimal field, 18 m/s, sigma 3.06 m/s, seed 1".
std::string describe(const WindCase& wind);

}  // namespace lac::sim
