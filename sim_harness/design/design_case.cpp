// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/design_case.hpp"

#include <cmath>
#include <limits>
#include <sstream>

#include "core/units.hpp"
#include "sim_harness/turbine/turbine_params.hpp"
#include "sim_harness/wind/iec_wind.hpp"
#include "sim_harness/wind/stability.hpp"

namespace lac::sim {
namespace {

// The range of the curves in rotor radii: 16 octaves about where |G_RL| falls.
constexpr double kFirstK1R = 0.06;
constexpr double kLastK1R = 9.5;

Stability stability_of(int choice) {
  return choice == 0 ? Stability::kNeutral : static_cast<Stability>(choice - 1);
}

MannParams read_mann_turbulence(YamlReader& in, double hub_height_m, int stability) {
  MannParams p = stability_mann(stability_of(stability));
  if (stability == 0) {  // IEC 61400-1; the evolution is that of the neutral class
    p.lifetime = EddyLifetime::kMann;
    p.gamma = 3.9;
    p.length_m = 0.8 * turbulence_scale_m(hub_height_m);
  }
  const int lifetime = p.lifetime == EddyLifetime::kMann ? 0 : 1;
  p.lifetime = static_cast<EddyLifetime>(in.choice("eddy_lifetime", lifetime, {"mann", "guo"}));
  p.length_m = in.number("length_scale_m", p.length_m, Range::positive());
  p.gamma = in.number("anisotropy", p.gamma, Range::not_negative());
  p.evolution_s = in.number("evolution_time_s", p.evolution_s, Range::positive());
  if (!in.flag("evolution", true)) p.evolution_s = std::numeric_limits<double>::infinity();
  return p;
}

KaimalTurbulence read_kaimal_turbulence(YamlReader& in, double hub_height_m, int stability) {
  KaimalTurbulence t;
  t.model = stability == 0 ? iec_kaimal(kStabilitySigmaU_mps, hub_height_m)
                           : stability_kaimal(stability_of(stability), kStabilitySigmaU_mps);
  t.evolution = stability_evolution(stability_of(stability));
  t.evolution.decay = in.number("evolution_decay", t.evolution.decay, Range::not_negative());
  t.evolution.offset_per_m =
      in.number("evolution_offset_per_m", t.evolution.offset_per_m, Range::not_negative());
  if (!in.flag("evolution", true)) t.evolution = {};
  t.lateral = static_cast<LateralCoherence>(
      in.choice("lateral_coherence", 1, {"independent", "same_as_u"}));
  return t;
}

void read_turbulence(YamlReader in, DesignCase& d) {
  const int kind = in.choice("kind", {"mann", "kaimal"});
  const int stability = in.choice("stability", 0, {"iec", "unstable", "neutral", "stable"});
  if (kind == 0) {
    d.turbulence = read_mann_turbulence(in, d.hub_height_m, stability);
  } else {
    d.turbulence = read_kaimal_turbulence(in, d.hub_height_m, stability);
  }
  in.finish();
}

void read_rotor(YamlReader& in, DesignCase& d) {
  if (in.has("turbine")) {
    const TurbineParams turbine = load_turbine(in.existing_file("turbine"));
    d.rotor_radius_m = turbine.rotor.radius_m;
    d.hub_height_m = turbine.hub_height_m;
    return;
  }
  d.rotor_radius_m = in.number("rotor_radius_m", Range::positive());
  d.hub_height_m = in.number("hub_height_m", Range::positive());
}

LidarParams read_design_lidar(YamlReader in) {
  LidarParams lidar = in.has("file") ? load_lidar(in.existing_file("file")) : read_lidar(in);
  in.finish();
  return lidar;
}

void read_model(YamlReader& in, DesignCase& d) {
  d.volumes.model =
      static_cast<VolumeModel>(in.choice("probe_volume", 0, {"continuous", "three_point"}));
  d.volumes.range_points = in.integer("range_points", d.volumes.range_points, {3.0, 401.0});
  d.volumes.yaw_error_rad = rad_from_deg(in.number("yaw_error_deg", 0.0, {-60.0, 60.0}));
  d.quadrature.nodes = in.integer("quadrature_nodes", d.quadrature.nodes, {11.0, 2001.0});
  d.quadrature.reach = in.number("quadrature_reach", d.quadrature.reach, {5.0, 1e4});
  if (d.volumes.range_points % 2 == 0) in.fail("range_points", "expected an odd number");
  if (d.quadrature.nodes % 2 == 0) in.fail("quadrature_nodes", "expected an odd number");
  d.curves.points = in.integer("points", d.curves.points, {11.0, 10000.0});
  d.curves.threads = in.integer("threads", d.curves.threads, {1.0, 64.0});
  d.curves.first_k1_radpm = kFirstK1R / d.rotor_radius_m;
  d.curves.last_k1_radpm = kLastK1R / d.rotor_radius_m;
  if (in.flag("scan_averaging", false)) d.curves.scan_time_s = d.lidar.scan.scan_time_s();
}

void read_feedforward(YamlReader in, DesignCase& d) {
  d.ffp_template = in.existing_file("template");
  InputFile file = InputFile::load(d.ffp_template);
  const FfpParams ffp = FfpParams::read(file);
  if (ffp.fixed_buffer_s) {
    file.fail("FixedBuffer", "a template of a design has a computed buffer; take the line out");
  }
  d.rule = static_cast<CutoffRule>(in.choice("cutoff", 0, {"minus_3_db", "closest_fit"}));
  d.timing.delay_frequency_hz = ffp.delay_frequency_hz;
  d.timing.actuator_frequency_hz = ffp.actuator_frequency_hz;
  d.timing.actuator_damping = ffp.actuator_damping;
  d.timing.buffer_trim_s = ffp.buffer_trim_s;
  d.timing.filter_order = in.integer("filter_order", 1, {1.0, 2.0});
  d.timing.trim_lateness = in.flag("trim_lateness", false);
  d.timing.scan_time_s = d.lidar.scan.scan_time_s();
  d.timing.lead_margin_s =
      in.number("lead_margin_s", d.timing.lead_margin_s, Range::not_negative());
  in.finish();
}

std::vector<double> read_speeds(YamlReader& in) {
  const std::vector<double> speeds_mps = in.numbers("wind_speeds_mps", Range::positive());
  for (std::size_t i = 1; i < speeds_mps.size(); ++i)
    if (!(speeds_mps[i] > speeds_mps[i - 1]))
      in.fail("wind_speeds_mps", "expected speeds that rise");
  return speeds_mps;
}

struct TurbulenceText {
  std::ostream& out;

  void operator()(const MannParams& p) const {
    out << "Mann tensor, L " << p.length_m << " m, Gamma " << p.gamma
        << (p.lifetime == EddyLifetime::kMann ? "" : " (lifetime of Guo)");
    if (std::isfinite(p.evolution_s)) {
      out << ", evolving with " << p.evolution_s << " s";
    } else {
      out << ", frozen";
    }
  }
  void operator()(const KaimalTurbulence& t) const {
    const KaimalModel& m = t.model;
    out << "Kaimal spectra, L_u " << m.u.length_scale_m << " m, coherence decay "
        << m.coherence_decay << ", L_c " << m.coherence_length_m << " m, v and w "
        << (t.lateral == LateralCoherence::kSameAsU ? "as coherent as u" : "independent");
    if (t.evolution.decay == 0.0) {
      out << ", frozen";
    } else {
      out << ", evolving with a_x " << t.evolution.decay << ", b_x " << t.evolution.offset_per_m
          << " 1/m";
    }
  }
};

}  // namespace

DesignCase load_design(const std::filesystem::path& file,
                       const std::vector<std::string>& overrides) {
  YamlReader in = YamlReader::load(file, overrides);
  DesignCase d;
  d.file = file;
  d.name = in.text("name", file.stem().string());
  read_rotor(in, d);
  d.lidar = read_design_lidar(in.map("lidar"));
  read_turbulence(in.map("turbulence"), d);
  d.speeds_mps = read_speeds(in);
  read_model(in, d);
  read_feedforward(in.map("feedforward"), d);
  d.output_folder = std::filesystem::path("results") / d.name;
  in.finish();
  return d;
}

std::unique_ptr<CorrelationModel> make_correlation(const DesignCase& d, const LidarVolumes& lidar) {
  if (const auto* mann = std::get_if<MannParams>(&d.turbulence))
    return std::make_unique<MannCorrelation>(*mann, lidar, d.rotor_radius_m, d.quadrature);
  return std::make_unique<KaimalCorrelation>(std::get<KaimalTurbulence>(d.turbulence), lidar,
                                             d.rotor_radius_m);
}

std::string describe_turbulence(const DesignCase& d) {
  std::ostringstream out;
  std::visit(TurbulenceText{out}, d.turbulence);
  return out.str();
}

std::string describe_model(const DesignCase& d) {
  std::ostringstream out;
  out << "rotor of " << 2.0 * d.rotor_radius_m << " m; probe volume "
      << (d.volumes.model == VolumeModel::kContinuous ? "continuous" : "in three points")
      << ", scan averaging " << (d.curves.scan_time_s > 0.0 ? "on" : "off");
  if (d.volumes.yaw_error_rad != 0.0)
    out << ", yaw misalignment " << deg_from_rad(d.volumes.yaw_error_rad) << " deg";
  out << ", cut-off "
      << (d.rule == CutoffRule::kAtMinus3dB ? "at -3 dB of |G_RL|" : "of the closest low-pass");
  return out.str();
}

}  // namespace lac::sim
