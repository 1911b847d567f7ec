// SPDX-License-Identifier: Apache-2.0
// Case files: the kinds of wind that one state describes at a time.
#pragma once

#include <iosfwd>

#include "sim_harness/run/wind_case.hpp"
#include "sim_harness/wind/iec_wind.hpp"

namespace lac::sim {

/// Keys wind_class (I) and turbulence_category (A).
IecClass read_iec_class(YamlReader& in);

UniformWindParams read_steady(YamlReader& in, const WindSurroundings& around);
UniformWindParams read_step(YamlReader& in, const WindSurroundings& around);
/// IEC 61400-1: operating gust, direction change, coherent gust with direction change, shear.
UniformWindParams read_eog(YamlReader& in, const WindSurroundings& around);
UniformWindParams read_edc(YamlReader& in, const WindSurroundings& around);
UniformWindParams read_ecd(YamlReader& in, const WindSurroundings& around);
UniformWindParams read_ews(YamlReader& in, const WindSurroundings& around);

/// For reports, without a line feed.
void describe(const UniformWindParams& wind, std::ostream& out);

}  // namespace lac::sim
