// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/wind_case.hpp"

#include <sstream>

#include "sim_harness/run/file_wind_case.hpp"
#include "sim_harness/run/flow_case.hpp"
#include "sim_harness/run/mann_case.hpp"
#include "sim_harness/run/turbulence_case.hpp"
#include "sim_harness/run/uniform_wind_case.hpp"

namespace lac::sim {
namespace {

KaimalFieldParams read_kaimal(YamlReader& in, const WindSurroundings& around) {
  KaimalFieldParams p;
  p.mean_speed_mps = in.number("mean_speed_mps", Range::positive());
  p.model = iec_kaimal(read_sigma_u(in, p.mean_speed_mps), around.hub_height_m);
  read_grid(in, around, p);
  p.lateral_coherence = static_cast<LateralCoherence>(
      in.choice("lateral_coherence", 0, {"independent", "same_as_u"}));
  return p;
}

struct Kind {
  const char* name;
  WindSource (*read)(YamlReader& in, const WindSurroundings& around);
};

constexpr Kind kKinds[] = {
    {"steady", [](auto& in, auto& around) -> WindSource { return read_steady(in, around); }},
    {"step", [](auto& in, auto& around) -> WindSource { return read_step(in, around); }},
    {"eog", [](auto& in, auto& around) -> WindSource { return read_eog(in, around); }},
    {"edc", [](auto& in, auto& around) -> WindSource { return read_edc(in, around); }},
    {"ecd", [](auto& in, auto& around) -> WindSource { return read_ecd(in, around); }},
    {"ews", [](auto& in, auto& around) -> WindSource { return read_ews(in, around); }},
    {"kaimal", [](auto& in, auto& around) -> WindSource { return read_kaimal(in, around); }},
    {"mann", [](auto& in, auto& around) -> WindSource { return read_mann(in, around); }},
    {"bts", [](auto& in, auto&) -> WindSource { return read_bts_kind(in); }},
    {"bladed", [](auto& in, auto&) -> WindSource { return read_bladed_kind(in); }},
    {"hawc2", [](auto& in, auto& around) -> WindSource { return read_box_kind(in, around); }},
    {"uniform_file",
     [](auto& in, auto& around) -> WindSource { return read_uniform_file_kind(in, around); }},
};

WindSource read_source(YamlReader& in, const WindSurroundings& around) {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return kKinds[in.choice("kind", names)].read(in, around);
}

struct Maker {
  const FlowShape& shape;

  std::unique_ptr<WindField> operator()(const UniformWindParams& p) const {
    return std::make_unique<UniformWind>(p);
  }
  std::unique_ptr<WindField> operator()(const KaimalFieldParams& p) const {
    return shaped(make_kaimal_field(p));
  }
  std::unique_ptr<WindField> operator()(const MannWind& wind) const {
    return make_mann_wind(wind, shape);
  }
  std::unique_ptr<WindField> operator()(const FieldFile& file) const {
    return shaped(read_field(file));
  }

 private:
  std::unique_ptr<WindField> shaped(GriddedWind wind) const {
    VelocityGrid grid = std::move(wind).take_grid();
    apply(shape, grid);
    return std::make_unique<GriddedWind>(std::move(grid));
  }
};

struct Describer {
  std::ostringstream& out;

  void operator()(const UniformWindParams& p) const { describe(p, out); }
  void operator()(const KaimalFieldParams& p) const {
    out << "Kaimal turbulence, " << p.mean_speed_mps << " m/s, standard deviation "
        << p.model.u.sigma_mps << " m/s, " << p.ny << " x " << p.nz << " points, v and w "
        << (p.lateral_coherence == LateralCoherence::kSameAsU ? "coherent as u" : "independent")
        << ", seed " << p.seed;
    if (p.shear_exponent != 0.0) out << ", shear exponent " << p.shear_exponent;
  }
  void operator()(const MannWind& wind) const { describe(wind, out); }
  void operator()(const FieldFile& file) const { describe(file, out); }
};

}  // namespace

WindCase read_wind(YamlReader& in, const WindSurroundings& around) {
  WindCase wind{.source = read_source(in, around), .hub_height_m = around.hub_height_m};
  if (!std::holds_alternative<UniformWindParams>(wind.source))
    wind.shape = read_shape(in, std::holds_alternative<FieldFile>(wind.source));
  wind.direction = read_direction(in);
  return wind;
}

std::unique_ptr<WindField> make_wind(const WindCase& wind) {
  std::unique_ptr<WindField> field = std::visit(Maker{wind.shape}, wind.source);
  if (!wind.direction.turns()) return field;
  return std::make_unique<TurnedWind>(std::move(field), wind.hub_height_m, wind.direction);
}

std::string describe(const WindCase& wind) {
  std::ostringstream out;
  out.precision(4);
  std::visit(Describer{out}, wind.source);
  describe(wind.shape, out);
  describe(wind.direction, out);
  return out.str();
}

}  // namespace lac::sim
