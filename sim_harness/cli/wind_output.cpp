// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/wind_output.hpp"

#include <cmath>
#include <ostream>
#include <sstream>

#include "core/error.hpp"
#include "sim_harness/run/evolution_case.hpp"
#include "sim_harness/wind/sampled_field.hpp"
#include "sim_harness/wind/uniform_file.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

bool asks_for_grid(const WindSamplingOptions& s) {
  return s.points_across > 0 || s.points_up > 0 || s.width_m > 0.0 || s.height_m > 0.0;
}

/// What an ending stands for when it is written.
WindFileKind kind_to_write(const fs::path& file, bool as_uniform) {
  if (file.extension() == ".wnd")
    return as_uniform ? WindFileKind::kUniform : WindFileKind::kBladed;
  const WindFileKind kind = wind_file_kind(file);
  if (kind != WindFileKind::kCase) return kind;
  throw Error(file.string() +
              ": is the name of a case file, expected that of a wind file: .bts, "
              ".wnd, .hh, .dat, .bin, .turb or .u");
}

GridSpec grid_of(const WindSamplingOptions& s, double hub_height_m, const fs::path& file) {
  if (s.points_across < 2 || s.points_up < 2 || !(s.width_m > 0.0) || !(s.height_m > 0.0)) {
    throw Error(file.string() +
                ": this wind has no grid of its own; give --grid NY NZ WIDTH HEIGHT "
                "with at least two points either way");
  }
  GridSpec g;
  g.ny = s.points_across;
  g.nz = s.points_up;
  g.nt = static_cast<int>(std::lround(s.duration_s / s.time_step_s)) + 1;
  g.dy_m = s.width_m / (g.ny - 1);
  g.dz_m = s.height_m / (g.nz - 1);
  g.dt_s = s.time_step_s;
  g.z_bottom_m = hub_height_m - 0.5 * s.height_m;
  g.hub_height_m = hub_height_m;
  return g;
}

void tell_of_grid(const GridSpec& g, std::ostream& out) {
  out << g.nt << " x " << g.ny << " x " << g.nz << " points, " << g.dt_s << " s, " << g.dy_m
      << " m, " << g.dz_m << " m apart, " << g.z_bottom_m << " to " << g.z_m(g.nz - 1)
      << " m above ground, mean speed " << g.mean_speed_mps << " m/s"
      << (g.periodic ? ", periodic" : "") << '\n';
}

void tell_of_box(const GridSpec& g, BoxOrder order, std::ostream& out) {
  std::ostringstream text;
  text.precision(9);
  text << "its readers need: --points " << g.nt << ' ' << g.ny << ' ' << g.nz << " --spacing "
       << g.dt_s * g.mean_speed_mps << ' ' << g.dy_m << ' ' << g.dz_m << " --mean-speed "
       << g.mean_speed_mps << " --hub-height " << g.z_bottom_m + 0.5 * (g.nz - 1) * g.dz_m
       << (order.first_plane_first ? "" : " --last-plane-first")
       << (order.rows_from_left ? "" : " --rows-from-right")
       << "\n(u without the mean speed; InflowWind: WindType 5, PLExp 0, ScaleMethod 0)\n";
  out << text.str();
}

void write_gridded(const fs::path& file, WindFileKind kind, const GriddedWind& wind,
                   const std::string& name, BoxOrder order, std::ostream& out) {
  const FieldFormat format = kind == WindFileKind::kBts      ? FieldFormat::kBts
                             : kind == WindFileKind::kBladed ? FieldFormat::kBladed
                                                             : FieldFormat::kBox;
  write_field({format, file, {}, order}, wind, name);
  const bool box = format == FieldFormat::kBox;
  out << "wrote " << (box ? box_files(file)[0] : file).string() << ": ";
  tell_of_grid(wind.grid().spec(), out);
  if (box) tell_of_box(wind.grid().spec(), order, out);
}

void write_rows(const fs::path& file, const LoadedWind& wind, const WindSamplingOptions& s,
                std::ostream& out) {
  const UniformWind* uniform = wind.uniform();
  if (uniform == nullptr) {
    throw Error(file.string() + ": a uniform wind file holds one state at a time; " + wind.name +
                " has more: expected the ending .bts, .wnd or .bin");
  }
  const auto* own = std::get_if<UniformTable>(&uniform->params().history);
  const UniformTable table =
      own != nullptr ? *own : tabulate(*uniform, 0.0, s.duration_s, s.time_step_s);
  write_uniform_file(file, table, wind.name);
  out << "wrote " << file.string() << ": " << table.rows.size() << " rows\n"
      << "its readers need: --hub-height " << uniform->params().hub_height_m << " --rotor-diameter "
      << uniform->params().reference_length_m << " (InflowWind: RefHt_Uni, RefLength)\n";
}

}  // namespace

void write_wind(const fs::path& file, const LoadedWind& wind, const WindSamplingOptions& sampling,
                BoxOrder box_order, std::ostream& out) {
  const bool grid_wanted = asks_for_grid(sampling);
  const WindFileKind kind = kind_to_write(file, wind.uniform() != nullptr && !grid_wanted);
  if (kind == WindFileKind::kUniform) return write_rows(file, wind, sampling, out);
  if (wind.gridded() != nullptr && !grid_wanted)
    return write_gridded(file, kind, *wind.gridded(), wind.name, box_order, out);
  const GridSpec grid = grid_of(sampling, wind.hub_height_m, file);
  write_gridded(file, kind, sampled_field(*wind.field, grid), wind.name, box_order, out);
}

void write_planes(const fs::path& file, const WindCase& wind, BoxOrder box_order,
                  std::ostream& out) {
  const WindFileKind kind = kind_to_write(file, false);
  if (kind == WindFileKind::kUniform)
    throw Error(file.string() + ": planes have a grid: expected the ending .bts, .wnd or .bin");
  make_planes(wind, [&](double distance_m, const GriddedWind& plane) {
    std::ostringstream distance;
    distance << '_' << distance_m << 'm';
    const fs::path name = file.stem().string() + distance.str() + file.extension().string();
    const std::string description =
        describe(wind) + ", plane " + distance.str().substr(1) + " up-wind";
    write_gridded(file.parent_path() / name, kind, plane, description, box_order, out);
  });
}

}  // namespace lac::sim
