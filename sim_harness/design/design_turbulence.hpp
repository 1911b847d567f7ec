// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "core/mann_tensor.hpp"
#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/design/kaimal_correlation.hpp"
#include "sim_harness/wind/iec_wind.hpp"

namespace lac::sim {

using DesignTurbulence = std::variant<MannParams, KaimalTurbulence>;

/// The keys under `turbulence` of a design file (docs/design.md). Throws lac::Error.
DesignTurbulence read_turbulence(YamlReader in, double hub_height_m, TurbulenceCategory& category);

/// One line, for reports.
std::string describe_turbulence(const DesignTurbulence& turbulence);

/// Standard deviation of u that these numbers have [m/s].
double sigma_u_mps(const DesignTurbulence& turbulence);

}  // namespace lac::sim
