// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/optimize_settings.hpp"

#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr double kMostBeams = 50.0;

/// [from, to], or one number that stays.
Interval read_interval(YamlReader& in, const std::string& key, Range range, double scale) {
  const std::vector<double> ends = in.numbers(key, range);
  if (ends.size() > 2 || ends.back() < ends.front())
    in.fail(key, "expected one number, or two that rise: [from, to]");
  return {scale * ends.front(), scale * ends.back()};
}

}  // namespace

OptimizeSettings read_optimize_settings(YamlReader in) {
  constexpr Range kAngle = Range::between(0.0, 60.0);
  OptimizeSettings s;
  s.wind_speed_mps = in.number("wind_speed_mps", Range::positive());
  s.beams.clear();
  for (const double n : in.numbers("beams", Range::between(1.0, kMostBeams))) {
    s.beams.push_back(static_cast<int>(n));
    if (s.beams.back() != n) in.fail("beams", "found " + shortest(n) + ", expected whole numbers");
  }
  s.azimuth_rad = read_interval(in, "azimuth_deg", kAngle, rad_from_deg(1.0));
  s.elevation_rad = read_interval(in, "elevation_deg", kAngle, rad_from_deg(1.0));
  s.first_gate_m = read_interval(in, "first_gate_m", Range::positive(), 1.0);
  s.last_gate_m = read_interval(in, "last_gate_m", Range::positive(), 1.0);
  s.gates = in.integer("gates", Range::between(1.0, 100.0));
  if (s.gates > 1 && s.last_gate_m.low <= s.first_gate_m.high)
    in.fail("last_gate_m", "expected more than first_gate_m, over all of its range");
  s.grid = in.integer("grid", s.grid, Range::between(2.0, 201.0));
  if (in.has("lead_at_mps")) s.lead_at_mps = in.number("lead_at_mps", Range::positive());
  if (in.has("largest_half_angle_deg"))
    s.largest_half_angle_rad = rad_from_deg(in.number("largest_half_angle_deg", kAngle));
  if (in.has("lowest_gate_m")) s.lowest_gate_m = in.number("lowest_gate_m", Range::any());
  in.finish();
  return s;
}

}  // namespace lac::sim
