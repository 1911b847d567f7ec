// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/design_case.hpp"

#include <cmath>
#include <sstream>

#include "core/units.hpp"

namespace lac::sim {
namespace {

// The range of the curves in rotor radii: 16 octaves about where |G_RL| falls.
constexpr double kFirstK1R = 0.06;
constexpr double kLastK1R = 9.5;

void read_rotor(YamlReader& in, DesignCase& d) {
  if (in.has("turbine")) {
    d.turbine = load_turbine(in.existing_file("turbine"));
    d.rotor_radius_m = d.turbine->rotor.radius_m;
    d.hub_height_m = d.turbine->hub_height_m;
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
  d.ffp = FfpParams::read(file);
  if (d.ffp.fixed_buffer_s) {
    file.fail("FixedBuffer", "a template of a design has a computed buffer; take the line out");
  }
  d.rule =
      static_cast<CutoffRule>(in.choice("cutoff", 0, {"minus_3_db", "closest_fit", "least_left"}));
  d.timing.delay_frequency_hz = d.ffp.delay_frequency_hz;
  d.timing.actuator_frequency_hz = d.ffp.actuator_frequency_hz;
  d.timing.actuator_damping = d.ffp.actuator_damping;
  d.timing.buffer_trim_s = d.ffp.buffer_trim_s;
  d.timing.filter_order = in.integer("filter_order", 1, {1.0, 2.0});
  d.timing.trim_lateness = in.flag("trim_lateness", false);
  d.timing.scan_time_s = d.lidar.scan.scan_time_s();
  d.timing.lead_margin_s =
      in.number("lead_margin_s", d.timing.lead_margin_s, Range::not_negative());
  d.designs_pitch_curve = in.choice("pitch_curve", 0, {"template", "rotor_table"}) == 1;
  if (d.designs_pitch_curve && !d.turbine)
    in.fail("pitch_curve", "found rotor_table, expected a turbine file that names one (turbine)");
  in.finish();
}

void read_feedback(YamlReader& in, DesignCase& d) {
  if (!in.has("feedback")) return;
  if (!d.turbine) in.fail("feedback", "found, expected a turbine file with it (turbine)");
  d.feedback = read_feedback_design(in.map("feedback"), *d.turbine, d.speeds_mps);
  if (in.has("flown"))
    for (YamlReader& runs : in.maps("flown"))
      d.flown.push_back(read_flown_runs(runs, d.speeds_mps));
}

std::vector<double> read_speeds(YamlReader& in) {
  const std::vector<double> speeds_mps = in.numbers("wind_speeds_mps", Range::positive());
  for (std::size_t i = 1; i < speeds_mps.size(); ++i)
    if (!(speeds_mps[i] > speeds_mps[i - 1]))
      in.fail("wind_speeds_mps", "expected speeds that rise");
  return speeds_mps;
}

}  // namespace

DesignCase load_design(const std::filesystem::path& file,
                       const std::vector<std::string>& overrides) {
  YamlReader in = YamlReader::load(file, overrides);
  DesignCase d;
  d.file = file;
  d.name = in.text("name", file.stem().string());
  read_rotor(in, d);
  d.lidar = read_design_lidar(in.map("lidar"));
  d.turbulence = read_turbulence(in.map("turbulence"), d.hub_height_m, d.category);
  d.speeds_mps = read_speeds(in);
  read_model(in, d);
  read_feedforward(in.map("feedforward"), d);
  read_feedback(in, d);
  if (in.has("flown_lidar")) d.flown_lidar = read_flown_campaign(in.map("flown_lidar"));
  if (in.has("optimize")) d.optimize = read_optimize_settings(in.map("optimize"));
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

std::string describe_model(const DesignCase& d) {
  std::ostringstream out;
  constexpr const char* kRules[] = {"at -3 dB of |G_RL|", "of the closest low-pass",
                                    "that leaves least of the wind"};
  out << "rotor of " << 2.0 * d.rotor_radius_m << " m; probe volume "
      << (d.volumes.model == VolumeModel::kContinuous ? "continuous" : "in three points")
      << ", scan averaging " << (d.curves.scan_time_s > 0.0 ? "on" : "off");
  if (d.volumes.yaw_error_rad != 0.0)
    out << ", yaw misalignment " << deg_from_rad(d.volumes.yaw_error_rad) << " deg";
  out << ", cut-off " << kRules[static_cast<int>(d.rule)];
  if (d.timing.filter_order == 2) out << ", second-order low-pass that leaves least of the wind";
  return out.str();
}

}  // namespace lac::sim
