// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/wind_command.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "core/error.hpp"
#include "sim_harness/cli/wind_theory.hpp"
#include "sim_harness/wind_check/check_report.hpp"
#include "sim_harness/wind_check/wind_statistics.hpp"

namespace lac::sim {
namespace {

constexpr double kUniformStep_s = 0.1;
constexpr double kRimRounding = 1.0 + 5e-7;  // sizes in files are single precision

/// The greatest radius about the hub that the field holds; 0 where it has no bounds.
double greatest_radius_m(const WindExtent& e, double hub_height_m) {
  const double radius_m = std::min(
      {-e.y_min_m, e.y_max_m, hub_height_m - std::max(e.z_min_m, 0.0), e.z_max_m - hub_height_m});
  return std::isfinite(e.y_max_m) ? radius_m * kRimRounding : 0.0;
}

RotorWindParams rotor_of(const LoadedWind& wind, const WindStatsOptions& o) {
  const WindExtent extent = wind.field->extent();
  RotorWindParams rotor;
  rotor.hub_height_m = wind.hub_height_m;
  rotor.radius_m = wind.rotor_diameter_m > 0.0 ? 0.5 * wind.rotor_diameter_m
                                               : greatest_radius_m(extent, wind.hub_height_m);
  if (!(rotor.radius_m > 0.0)) {
    throw Error(wind.name + ": the hub at " + std::to_string(wind.hub_height_m) +
                " m is not inside of this wind; give --hub-height and --rotor-diameter");
  }
  const GriddedWind* gridded = wind.gridded();
  rotor.dt_s = o.time_step_s > 0.0  ? o.time_step_s
               : gridded != nullptr ? gridded->grid().spec().dt_s
                                    : kUniformStep_s;
  const double end_s = gridded != nullptr ? gridded->duration_s() : o.duration_s;
  const bool repeats = gridded != nullptr && gridded->grid().spec().periodic;
  rotor.t_end_s = std::min(repeats ? end_s - rotor.dt_s : end_s, extent.t_max_s);
  return rotor;
}

}  // namespace

void wind_convert_command(const WindConvertOptions& o, std::ostream& out) {
  if (o.planes) {
    const WindSection read = read_wind_case(o.input, o.file.overrides);
    return write_planes(o.output, read.wind, o.file.box_order, out);
  }
  write_wind(o.output, load_wind(o.input, o.file), o.sampling, o.file.box_order, out);
}

void wind_stats_command(const WindStatsOptions& o, std::ostream& out) {
  const LoadedWind wind = load_wind(o.input, o.file);
  const RotorWindParams rotor = rotor_of(wind, o);
  const WindStatistics statistics = wind_statistics(*wind.field, rotor, o.window_s);
  out << wind.name << '\n' << statistics_table(statistics);
  if (o.channels.empty()) return;
  wind_channels(*wind.field, statistics.signals, rotor.hub_height_m)
      .write(o.channels, "lac wind stats " + wind.name);
  out << "wrote " << o.channels.string() << '\n';
}

bool wind_check_command(const WindCheckOptions& o, std::ostream& out) {
  const LoadedWind wind = load_wind(o.input, o.file);
  const GriddedWind* gridded = wind.gridded();
  if (gridded == nullptr)
    throw Error(wind.name + ": expected turbulence on a grid; there is no theory of this wind");
  const std::unique_ptr<TurbulenceTheory> theory = theory_of(o, wind);
  const TheoryCheck check = check_field(*gridded, *theory, o.settings);
  const CheckTitle title{wind.name, theory->name(), gridded->mean_speed_mps()};
  out << check_table(check, title, o.settings);
  if (!o.page.empty()) {
    write_html_report(o.page, check_page(check, title, o.settings));
    out << "wrote " << o.page.string() << '\n';
  }
  return check.passed();
}

}  // namespace lac::sim
