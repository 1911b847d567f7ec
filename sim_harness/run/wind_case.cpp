// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/wind_case.hpp"

#include <cmath>
#include <sstream>

#include "sim_harness/run/evolution_case.hpp"
#include "sim_harness/run/file_wind_case.hpp"
#include "sim_harness/run/flow_case.hpp"
#include "sim_harness/run/kaimal_case.hpp"
#include "sim_harness/run/mann_case.hpp"
#include "sim_harness/run/turbulence_case.hpp"
#include "sim_harness/run/uniform_wind_case.hpp"

namespace lac::sim {
namespace {

constexpr double kUnsaidShare = 0.02;  // of sigma_u

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
  const WindDemand* demand;

  std::unique_ptr<WindField> operator()(const UniformWindParams& p) const {
    return std::make_unique<UniformWind>(p);
  }
  std::unique_ptr<WindField> operator()(const KaimalWind& wind) const {
    return make_kaimal_wind(wind, shape, demand);
  }
  std::unique_ptr<WindField> operator()(const MannWind& wind) const {
    return make_mann_wind(wind, shape, demand);
  }
  std::unique_ptr<WindField> operator()(const FieldFile& file) const {
    return shaped_field(read_field(file), shape);
  }
};

struct Describer {
  std::ostringstream& out;

  void operator()(const UniformWindParams& p) const { describe(p, out); }
  void operator()(const KaimalWind& wind) const { describe(wind, out); }
  void operator()(const MannWind& wind) const { describe(wind, out); }
  void operator()(const FieldFile& file) const { describe(file, out); }
};

}  // namespace

WindCase read_wind(YamlReader& in, const WindSurroundings& around) {
  WindCase wind{.source = read_source(in, around),
                .hub_height_m = around.hub_height_m,
                .rotor_radius_m = around.rotor_radius_m};
  if (!std::holds_alternative<UniformWindParams>(wind.source))
    wind.shape = read_shape(in, std::holds_alternative<FieldFile>(wind.source));
  wind.direction = read_direction(in, around.lidar ? &*around.lidar : nullptr);
  return wind;
}

std::unique_ptr<WindField> make_wind(const WindCase& wind, const WindDemand* demand) {
  if (!wind.direction.turns()) return std::visit(Maker{wind.shape, demand}, wind.source);
  std::optional<WindDemand> in_field;
  if (demand != nullptr) in_field = turned(*demand, wind);
  return std::make_unique<TurnedWind>(
      std::visit(Maker{wind.shape, in_field ? &*in_field : nullptr}, wind.source),
      wind.hub_height_m, wind.direction);
}

bool evolves(const WindCase& wind) {
  const auto* kaimal = std::get_if<KaimalWind>(&wind.source);
  const auto* mann = std::get_if<MannWind>(&wind.source);
  return (kaimal != nullptr && !kaimal->planes_m.empty()) ||
         (mann != nullptr && !mann->planes_m.empty());
}

std::string held_turbulence(const WindCase& wind) {
  std::optional<SigmaU> sigma;
  if (const auto* kaimal = std::get_if<KaimalWind>(&wind.source)) sigma = sigma_u(*kaimal);
  if (const auto* mann = std::get_if<MannWind>(&wind.source)) sigma = sigma_u(*mann);
  if (!sigma || std::abs(sigma->held_mps / sigma->asked_mps - 1.0) <= kUnsaidShare) return {};
  std::ostringstream out;
  out.precision(3);
  out << "note: the wind is expected to hold sigma_u = " << sigma->held_mps << " m/s, asked for "
      << sigma->asked_mps << " m/s: what is slower than its period or faster than its time step is "
      << "left out\n";
  return out.str();
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
