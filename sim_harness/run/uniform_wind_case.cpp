// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/uniform_wind_case.hpp"

#include <ostream>

#include "core/units.hpp"

namespace lac::sim {
namespace {

UniformWindParams read_common(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p;
  p.hub_height_m = around.hub_height_m;
  p.reference_length_m = 2.0 * around.rotor_radius_m;
  p.shear_exponent = in.number("shear_exponent", 0.0, Range::between(-1.0, 1.0));
  if (in.has("advection_speed_mps")) {
    p.advection_speed_mps = in.number("advection_speed_mps", Range::positive());
  }
  return p;
}

/// The keys of every event of the standard.
struct EventKeys {
  double mean_speed_mps;
  double start_s;
  IecClass iec;
};

EventKeys read_event(YamlReader& in) {
  return {in.number("mean_speed_mps", Range::positive()),
          in.number("start_s", Range::not_negative()), read_iec_class(in)};
}

/// The standard asks for both signs of an event.
double read_sign(YamlReader& in) {
  return in.choice("sign", 0, {"positive", "negative"}) == 0 ? 1.0 : -1.0;
}

struct Describer {
  std::ostream& out;

  void operator()(const SteadySpeed& s) const { out << "steady, " << s.speed_mps << " m/s"; }
  void operator()(const StepSpeed& s) const {
    out << "step from " << s.from_mps << " to " << s.to_mps << " m/s at " << s.time_s << " s";
  }
  void operator()(const GustSpeed& s) const {
    out << "extreme operating gust of " << s.magnitude_mps << " m/s";
    event(s);
  }
  void operator()(const DirectionChange& s) const {
    out << "extreme direction change of " << deg_from_rad(s.angle_rad) << " deg";
    event(s);
  }
  void operator()(const CoherentGust& s) const {
    out << "extreme coherent gust of " << s.gust_mps << " m/s with a direction change of "
        << deg_from_rad(s.angle_rad) << " deg";
    event(s);
  }
  void operator()(const ShearEvent& s) const {
    out << "extreme " << (s.axis == ShearEvent::Axis::kVertical ? "vertical" : "horizontal")
        << " shear, amplitude " << s.amplitude_mps << " m/s";
    event(s);
  }
  void operator()(const UniformTable& table) const {
    out << "uniform wind table of " << table.rows.size() << " rows up to "
        << table.rows.back().time_s << " s";
  }

 private:
  template <class Event>
  void event(const Event& s) const {
    out << " on " << s.mean_speed_mps << " m/s at " << s.start_s << " s";
  }
};

}  // namespace

IecClass read_iec_class(YamlReader& in) {
  IecClass iec;
  iec.wind = static_cast<WindClass>(in.choice("wind_class", 0, {"I", "II", "III"}));
  iec.turbulence =
      static_cast<TurbulenceCategory>(in.choice("turbulence_category", 0, {"A", "B", "C", "A+"}));
  return iec;
}

UniformWindParams read_steady(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p = read_common(in, around);
  p.history = SteadySpeed{in.number("speed_mps", Range::positive())};
  return p;
}

UniformWindParams read_step(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p = read_common(in, around);
  StepSpeed step;
  step.from_mps = in.number("from_mps", Range::positive());
  step.to_mps = in.number("to_mps", Range::positive());
  step.time_s = in.number("time_s", Range::not_negative());
  step.ramp_s = in.number("ramp_s", 0.0, Range::not_negative());
  p.history = step;
  return p;
}

UniformWindParams read_eog(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p = read_common(in, around);
  const EventKeys e = read_event(in);
  const double standard_mps =
      eog_magnitude_mps(e.iec, e.mean_speed_mps, p.hub_height_m, p.reference_length_m);
  p.history = GustSpeed{e.mean_speed_mps, in.number("magnitude_mps", standard_mps, Range::any()),
                        e.start_s};
  return p;
}

UniformWindParams read_edc(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p = read_common(in, around);
  const EventKeys e = read_event(in);
  const double standard_rad =
      edc_angle_rad(e.iec.turbulence, e.mean_speed_mps, p.hub_height_m, p.reference_length_m);
  const double angle_deg =
      in.number("angle_deg", deg_from_rad(standard_rad), Range::between(0.0, 180.0));
  p.history = DirectionChange{e.mean_speed_mps, read_sign(in) * rad_from_deg(angle_deg), e.start_s};
  return p;
}

UniformWindParams read_ecd(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p = read_common(in, around);
  CoherentGust gust;
  gust.mean_speed_mps = in.number("mean_speed_mps", Range::positive());
  gust.start_s = in.number("start_s", Range::not_negative());
  gust.gust_mps = in.number("magnitude_mps", kEcdGust_mps, Range::not_negative());
  const double standard_deg = deg_from_rad(ecd_angle_rad(gust.mean_speed_mps));
  const double angle_deg = in.number("angle_deg", standard_deg, Range::between(0.0, 180.0));
  gust.angle_rad = read_sign(in) * rad_from_deg(angle_deg);
  p.history = gust;
  return p;
}

UniformWindParams read_ews(YamlReader& in, const WindSurroundings& around) {
  UniformWindParams p = read_common(in, around);
  const EventKeys e = read_event(in);
  const double standard_mps =
      ews_amplitude_mps(e.iec.turbulence, e.mean_speed_mps, p.hub_height_m, p.reference_length_m);
  const double amplitude_mps = in.number("magnitude_mps", standard_mps, Range::not_negative());
  const auto axis =
      static_cast<ShearEvent::Axis>(in.choice("shear", 0, {"vertical", "horizontal"}));
  p.history = ShearEvent{e.mean_speed_mps, read_sign(in) * amplitude_mps, axis, e.start_s};
  return p;
}

void describe(const UniformWindParams& wind, std::ostream& out) {
  std::visit(Describer{out}, wind.history);
  if (wind.shear_exponent != 0.0) out << ", shear exponent " << wind.shear_exponent;
}

}  // namespace lac::sim
