// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/wind_input.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>

#include "core/error.hpp"
#include "sim_harness/lidar/beam_extent.hpp"
#include "sim_harness/run/case_file.hpp"
#include "sim_harness/turbine/turbine_params.hpp"
#include "sim_harness/wind/evolving_wind.hpp"
#include "sim_harness/wind/uniform_file.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

void read_rotor(YamlReader& in, WindSurroundings& around) {
  if (!in.has("turbine")) {
    around.hub_height_m = in.number("hub_height_m", Range::positive());
    around.rotor_radius_m = in.number("rotor_radius_m", Range::positive());
    return;
  }
  const TurbineParams turbine = load_turbine(in.existing_file("turbine"));
  around.hub_height_m = turbine.hub_height_m;
  around.rotor_radius_m = turbine.rotor.radius_m;
}

WindSurroundings read_surroundings(YamlReader& in) {
  WindSurroundings around;
  around.seed = static_cast<std::uint64_t>(in.integer("seed", 1, Range::between(0, 2147483647)));
  read_rotor(in, around);
  if (in.has("lidar"))
    around.lidar = wind_demand(read_case_lidar(in.map("lidar")).params, around.hub_height_m);
  return around;
}

/// Of wind that evolves the rotor plane is enough, unless turning moves it.
std::unique_ptr<WindField> make_rotor_wind(const WindCase& wind) {
  const WindDemand nothing_upwind;
  return make_wind(wind, wind.direction.turns() ? nullptr : &nothing_upwind);
}

LoadedWind load_case_wind(const fs::path& file, const WindFileOptions& options) {
  WindSection read = read_wind_case(file, options.overrides);
  LoadedWind loaded;
  loaded.name = file.filename().string() + ": " + describe(read.wind);
  loaded.field = make_rotor_wind(read.wind);
  loaded.made_of = std::move(read.wind);
  loaded.hub_height_m =
      options.hub_height_m > 0.0 ? options.hub_height_m : read.around.hub_height_m;
  loaded.rotor_diameter_m =
      options.rotor_diameter_m > 0.0 ? options.rotor_diameter_m : 2.0 * read.around.rotor_radius_m;
  return loaded;
}

void require_given(bool given, const fs::path& file, const char* what) {
  if (!given) throw Error(file.string() + ": the file does not say " + what);
}

FieldFile box_of(const fs::path& file, const WindFileOptions& o) {
  require_given(o.points.size() == 3, file, "how many points it has; give --points NX NY NZ");
  require_given(o.spacing_m.size() == 3, file, "how far apart they are; give --spacing DX DY DZ");
  require_given(o.mean_speed_mps > 0.0, file, "its mean speed; give --mean-speed U");
  require_given(o.hub_height_m > 0.0, file, "the height of its centre; give --hub-height H");
  FieldFile box{FieldFormat::kBox, file, {}, o.box_order};
  GridSpec& g = box.box_spec;
  g.nt = o.points[0];
  g.ny = o.points[1];
  g.nz = o.points[2];
  g.dy_m = o.spacing_m[1];
  g.dz_m = o.spacing_m[2];
  g.dt_s = o.spacing_m[0] / o.mean_speed_mps;
  g.z_bottom_m = o.hub_height_m - 0.5 * (g.nz - 1) * g.dz_m;
  g.hub_height_m = o.hub_height_m;
  g.mean_speed_mps = o.mean_speed_mps;
  g.periodic = true;
  return box;
}

std::unique_ptr<WindField> uniform_of(const fs::path& file, const WindFileOptions& o) {
  require_given(o.hub_height_m > 0.0, file, "its height; give --hub-height H");
  require_given(o.rotor_diameter_m > 0.0, file,
                "the length of its shears; give --rotor-diameter D");
  UniformWindParams p;
  p.history = read_uniform_file(file);
  p.hub_height_m = o.hub_height_m;
  p.reference_length_m = o.rotor_diameter_m;
  return std::make_unique<UniformWind>(p);
}

std::unique_ptr<WindField> field_of(WindFileKind kind, const fs::path& file,
                                    const WindFileOptions& o) {
  switch (kind) {
    case WindFileKind::kUniform:
      return uniform_of(file, o);
    case WindFileKind::kBts:
      return std::make_unique<GriddedWind>(read_field({FieldFormat::kBts, file}));
    case WindFileKind::kBladed:
      return std::make_unique<GriddedWind>(read_field({FieldFormat::kBladed, file}));
    default:
      return std::make_unique<GriddedWind>(read_field(box_of(file, o)));
  }
}

bool begins_with_negative_number(const fs::path& file) {
  std::int16_t id = 0;
  std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(&id), sizeof id);
  return id < 0;
}

}  // namespace

const GriddedWind* LoadedWind::gridded() const {
  if (const auto* evolving = dynamic_cast<const EvolvingWind*>(field.get()))
    return &evolving->rotor_plane();
  return dynamic_cast<const GriddedWind*>(field.get());
}

const UniformWind* LoadedWind::uniform() const {
  return dynamic_cast<const UniformWind*>(field.get());
}

WindSection read_wind_case(const fs::path& file, const std::vector<std::string>& overrides) {
  YamlReader in = YamlReader::load(file, overrides);
  const WindSurroundings around = read_surroundings(in);
  YamlReader wind = in.map("wind");
  WindSection read{read_wind(wind, around), around};
  wind.finish();
  if (!in.has("turbine")) in.finish();  // the rest of a whole case is the business of lac run
  return read;
}

WindFileKind wind_file_kind(const fs::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".yaml" || ending == ".yml") return WindFileKind::kCase;
  if (ending == ".bts") return WindFileKind::kBts;
  if (ending == ".hh" || ending == ".dat") return WindFileKind::kUniform;
  if (ending == ".bin" || ending == ".turb" || ending == ".u") return WindFileKind::kBox;
  if (ending == ".wnd")
    return begins_with_negative_number(file) ? WindFileKind::kBladed : WindFileKind::kUniform;
  throw Error(file.string() + ": found the ending '" + ending +
              "', expected .yaml, .bts, .wnd, .hh, .dat, .bin, .turb or .u");
}

LoadedWind load_wind(const fs::path& file, const WindFileOptions& options) {
  const WindFileKind kind = wind_file_kind(file);
  if (kind == WindFileKind::kCase) return load_case_wind(file, options);
  LoadedWind loaded;
  loaded.name = file.filename().string();
  loaded.field = field_of(kind, file, options);
  const GriddedWind* gridded = loaded.gridded();
  const bool own_height = options.hub_height_m == 0.0 && gridded != nullptr;
  loaded.hub_height_m = own_height ? gridded->grid().spec().hub_height_m : options.hub_height_m;
  loaded.rotor_diameter_m = options.rotor_diameter_m;
  return loaded;
}

}  // namespace lac::sim
