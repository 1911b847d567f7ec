// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/feedback_design.hpp"

#include <cmath>

#include "core/units.hpp"
#include "sim_harness/design/input_template.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

constexpr Range kLoopRange{0.0, 10.0, false};
constexpr double kAboveRated_mps = 0.5;  // nearer, dM_a/dtheta is small and the gains are large
constexpr double kSameTurbine = 0.005;

void require_turbine(const YamlReader& in, const char* what, double found, double expected) {
  if (std::abs(found / expected - 1.0) <= kSameTurbine) return;
  in.fail("template", std::string(what) + " " + shortest(found) + " of the file, expected " +
                          shortest(expected) + " as the turbine has it");
}

std::vector<double> gain_winds(YamlReader& in, const DesignPlant& plant,
                               const std::vector<double>& winds_mps) {
  if (in.has("gain_wind_speeds_mps")) return in.numbers("gain_wind_speeds_mps", Range::positive());
  const double lowest_mps = rated_point(plant).wind_mps + kAboveRated_mps;
  std::vector<double> above;
  for (const double v : winds_mps)
    if (v > lowest_mps) above.push_back(v);
  if (above.empty()) {
    in.fail("gain_wind_speeds_mps",
            "missing, and none of wind_speeds_mps lies above " + shortest(lowest_mps) + " m/s");
  }
  return above;
}

void design_gains(const TurbineParams& turbine, FeedbackDesign& d) {
  const DesignPlant plant = design_plant(turbine);
  FeedbackParams& p = d.params;
  const bool constant_power = p.torque.above_rated == TorqueControl::AboveRated::ConstantPower;
  p.pitch.gains = design_pitch_gains(plant, d.winds_mps, d.pitch, constant_power);
  p.torque.gains = design_torque_gains(plant, d.torque);
  p.torque.optimal_gain_Nms2prad2 = turbine.region2_gain_Nms2prad2;
}

std::string target_text(const LoopTarget& t) {
  return "damping " + shortest(t.damping) + ", " + shortest(t.frequency_radps) + " rad/s";
}

}  // namespace

DesignPlant design_plant(const TurbineParams& t) {
  return {t.rotor,
          t.inertia_kgm2,
          t.gearbox_ratio,
          t.gearbox_efficiency,
          t.rated_rotor_speed_radps * t.gearbox_ratio,
          t.rated_torque_Nm,
          t.fine_pitch_rad};
}

FeedbackDesign read_feedback_design(YamlReader in, const TurbineParams& turbine,
                                    const std::vector<double>& winds_mps) {
  FeedbackDesign d;
  d.file = in.existing_file("template");
  InputFile file = InputFile::load(d.file);
  d.params = FeedbackParams::read(file);
  const DesignPlant plant = design_plant(turbine);
  require_turbine(in, "RatedGeneratorSpeed [rad/s]", d.params.torque.rated_speed_radps,
                  plant.rated_generator_speed_radps);
  require_turbine(in, "RatedTorque", d.params.torque.rated_torque_Nm,
                  plant.rated_generator_torque_Nm);
  require_turbine(in, "GearboxRatio", d.params.speed.gearbox_ratio, plant.gearbox_ratio);
  d.winds_mps = gain_winds(in, plant, winds_mps);
  d.pitch.damping = in.number("damping", d.pitch.damping, kLoopRange);
  d.pitch.frequency_radps = in.number("frequency_radps", d.pitch.frequency_radps, kLoopRange);
  d.torque.damping = in.number("torque_damping", d.torque.damping, kLoopRange);
  d.torque.frequency_radps =
      in.number("torque_frequency_radps", d.torque.frequency_radps, kLoopRange);
  in.finish();
  design_gains(turbine, d);
  return d;
}

std::string designed_feedback_input(std::string_view template_text, const FeedbackDesign& d,
                                    const TurbineParams& turbine) {
  const PitchGainSchedule& gains = d.params.pitch.gains;
  const bool constant_power =
      d.params.torque.above_rated == TorqueControl::AboveRated::ConstantPower;
  std::vector<double> pitch_deg;
  std::string winds;
  for (const double rad : gains.proportional_s.x()) pitch_deg.push_back(deg_from_rad(rad));
  for (const double v : d.winds_mps) winds += " " + shortest(v);
  const std::string origin = "Gains: poles of the rotor speed of " + turbine.name +
                             " placed with its rotor table,\n" + "pitch loop " +
                             target_text(d.pitch) + " at" + winds + " m/s and constant " +
                             (constant_power ? "power" : "torque") + ",\ntorque loop " +
                             target_text(d.torque) + " at rated wind.\n";
  const LimitedPi::Gains& torque = d.params.torque.gains;
  const std::string block =
      commented(origin) + "given ! Gains - design or given (as arrays) [-]\n" +
      key_row(pitch_deg, 3, "GainSchedulePitch - measured pitch of the schedule [deg]") +
      key_row(gains.proportional_s.y(), 6, "ProportionalGain - of the generator speed [s]") +
      key_row(gains.integral_time_s.y(), 4, "IntegralTime - [s]") +
      key_row({torque.proportional}, 2, "TorqueProportionalGain - [Nm/(rad/s)]") +
      key_row({torque.integral_time_s}, 4, "TorqueIntegralTime - [s]") +
      key_row({d.params.torque.optimal_gain_Nms2prad2}, 4,
              "OptimalTorqueGain - region 2 [Nm/(rad/s)^2]");
  return with_keys_replaced(
      template_text,
      {"gains", "rotortable", "rotorradius", "airdensity", "gearboxefficiency",
       "inertialowspeedshaft", "designwindspeed", "pitchloopdamping", "pitchloopfrequency",
       "torqueloopdamping", "torqueloopfrequency", "gainschedulepitch", "proportionalgain",
       "integraltime", "torqueproportionalgain", "torqueintegraltime", "optimaltorquegain"},
      block);
}

}  // namespace lac::sim
