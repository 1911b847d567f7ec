// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/wind/kaimal_field.hpp"
#include "sim_harness/wind/uniform_wind.hpp"

namespace lac::sim {

/// A TurbSim file.
struct BtsWind {
  std::filesystem::path file;
};

/// The wind of a case before it is made.
using WindCase = std::variant<UniformWindParams, KaimalFieldParams, BtsWind>;

/// What of the turbine the standard's wind conditions depend on, and what else decides.
struct WindSurroundings {
  double hub_height_m = 90.0;
  double rotor_radius_m = 63.0;
  std::uint64_t seed = 1;
};

/// Key kind: steady, step, eog, kaimal or bts, and the keys of that kind (listed
/// in config/README.md). Throws lac::Error.
WindCase read_wind(YamlReader& in, const WindSurroundings& around);

/// Builds or reads the field. Throws lac::Error.
std::unique_ptr<WindField> make_wind(const WindCase& wind);

/// One line for reports: "Kaimal field, 18 m/s, sigma 3.06 m/s, seed 1".
std::string describe(const WindCase& wind);

}  // namespace lac::sim
