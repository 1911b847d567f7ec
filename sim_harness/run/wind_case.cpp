// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/wind_case.hpp"

#include <sstream>

#include "sim_harness/wind/bts_file.hpp"
#include "sim_harness/wind/iec_wind.hpp"

namespace lac::sim {
namespace {

IecClass read_iec_class(YamlReader& in) {
  IecClass iec;
  iec.wind = static_cast<WindClass>(in.choice("wind_class", 0, {"I", "II", "III"}));
  iec.turbulence =
      static_cast<TurbulenceCategory>(in.choice("turbulence_category", 0, {"A", "B", "C"}));
  return iec;
}

UniformWindParams read_uniform(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p;
  p.hub_height_m = around.hub_height_m;
  p.shear_exponent = in.number("shear_exponent", 0.0, Range::between(-1.0, 1.0));
  if (in.has("advection_speed_mps")) {
    p.advection_speed_mps = in.number("advection_speed_mps", Range::positive());
  }
  return p;
}

WindCase read_steady(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p = read_uniform(in, around);
  p.speed = SteadySpeed{in.number("speed_mps", Range::positive())};
  return p;
}

WindCase read_step(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p = read_uniform(in, around);
  StepSpeed step;
  step.from_mps = in.number("from_mps", Range::positive());
  step.to_mps = in.number("to_mps", Range::positive());
  step.time_s = in.number("time_s", Range::not_negative());
  step.ramp_s = in.number("ramp_s", 0.0, Range::not_negative());
  p.speed = step;
  return p;
}

WindCase read_gust(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p = read_uniform(in, around);
  GustSpeed gust;
  gust.mean_speed_mps = in.number("mean_speed_mps", Range::positive());
  gust.start_s = in.number("start_s", Range::not_negative());
  const double standard_mps = eog_magnitude_mps(read_iec_class(in), gust.mean_speed_mps,
                                                around.hub_height_m, 2.0 * around.rotor_radius_m);
  gust.magnitude_mps = in.number("magnitude_mps", standard_mps, Range::any());
  p.speed = gust;
  return p;
}

WindCase read_kaimal(YamlReader& in, const WindSurroundings& around) {
  KaimalFieldParams p;
  p.mean_speed_mps = in.number("mean_speed_mps", Range::positive());
  p.hub_height_m = around.hub_height_m;
  p.seed = around.seed;
  const IecClass iec = read_iec_class(in);
  const bool extreme = in.choice("turbulence_model", 0, {"normal", "extreme"}) == 1;
  const double standard_mps = extreme ? etm_sigma_mps(iec, p.mean_speed_mps)
                                      : ntm_sigma_mps(iec.turbulence, p.mean_speed_mps);
  p.model = iec_kaimal(in.number("sigma_u_mps", standard_mps, Range::positive()), p.hub_height_m);
  p.shear_exponent = in.number("shear_exponent", p.shear_exponent, Range::between(-1.0, 1.0));
  p.width_m = in.number("width_m", p.width_m, Range::positive());
  p.height_m = in.number("height_m", p.height_m, Range::positive());
  p.ny = in.integer("points_across", p.ny, Range::between(2, 1000));
  p.nz = in.integer("points_up", p.nz, Range::between(2, 1000));
  p.dt_s = in.number("time_step_s", p.dt_s, Range::positive());
  p.duration_s = in.number("period_s", p.duration_s, Range::positive());
  p.lateral_coherence = static_cast<LateralCoherence>(
      in.choice("lateral_coherence", 0, {"independent", "same_as_u"}));
  p.threads = in.integer("threads", p.threads, Range::between(1, 64));
  return p;
}

struct Maker {
  std::unique_ptr<WindField> operator()(const UniformWindParams& p) const {
    return std::make_unique<UniformWind>(p);
  }
  std::unique_ptr<WindField> operator()(const KaimalFieldParams& p) const {
    return std::make_unique<GriddedWind>(make_kaimal_field(p));
  }
  std::unique_ptr<WindField> operator()(const BtsWind& p) const {
    return std::make_unique<GriddedWind>(read_bts(p.file));
  }
};

struct Describer {
  std::ostringstream& out;

  void operator()(const SteadySpeed& s) const { out << "steady, " << s.speed_mps << " m/s"; }
  void operator()(const StepSpeed& s) const {
    out << "step from " << s.from_mps << " to " << s.to_mps << " m/s at " << s.time_s << " s";
  }
  void operator()(const GustSpeed& s) const {
    out << "extreme operating gust of " << s.magnitude_mps << " m/s on " << s.mean_speed_mps
        << " m/s at " << s.start_s << " s";
  }
  void operator()(const UniformWindParams& p) const {
    std::visit(*this, p.speed);
    if (p.shear_exponent != 0.0) out << ", shear exponent " << p.shear_exponent;
  }
  void operator()(const KaimalFieldParams& p) const {
    out << "Kaimal turbulence, " << p.mean_speed_mps << " m/s, standard deviation "
        << p.model.u.sigma_mps << " m/s, " << p.ny << " x " << p.nz << " points, v and w "
        << (p.lateral_coherence == LateralCoherence::kSameAsU ? "coherent as u" : "independent")
        << ", seed " << p.seed;
    if (p.shear_exponent != 0.0) out << ", shear exponent " << p.shear_exponent;
  }
  void operator()(const BtsWind& p) const { out << "file " << p.file.filename().string(); }
};

}  // namespace

WindCase read_wind(YamlReader& in, const WindSurroundings& around) {
  switch (in.choice("kind", {"steady", "step", "eog", "kaimal", "bts"})) {
    case 0:
      return read_steady(in, around);
    case 1:
      return read_step(in, around);
    case 2:
      return read_gust(in, around);
    case 3:
      return read_kaimal(in, around);
    default:
      return BtsWind{in.existing_file("file")};
  }
}

std::unique_ptr<WindField> make_wind(const WindCase& wind) {
  return std::visit(Maker{}, wind);
}

std::string describe(const WindCase& wind) {
  std::ostringstream out;
  out.precision(4);
  std::visit(Describer{out}, wind);
  return out.str();
}

}  // namespace lac::sim
