// SPDX-License-Identifier: Apache-2.0
#include "feedback/feedback_params.hpp"

#include <array>
#include <string>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac {
namespace {

// The notch follows the speed from cut-in to this multiple of the rated one.
constexpr double kHighestSpeedOverRated = 2.0;
// Damping [-] and frequency [rad/s] of a rotor speed loop: around 1 and below.
constexpr Range kLoopRange{0.0, 10.0, false};

constexpr std::array kDesignKeys = {
    "PitchLoopDamping",  "PitchLoopFrequency",  "TorqueLoopDamping", "TorqueLoopFrequency",
    "DesignWindSpeed",   "RotorTable",          "RotorRadius",       "AirDensity",
    "GearboxEfficiency", "InertiaLowSpeedShaft"};
constexpr std::array kGivenKeys = {"GainSchedulePitch", "ProportionalGain", "IntegralTime",
                                   "TorqueProportionalGain", "TorqueIntegralTime"};

double speed(InputFile& in, const char* key) {
  return radps_from_rpm(in.number(key, Range::positive()));
}

double degrees(InputFile& in, const char* key, Range range) {
  return rad_from_deg(in.number(key, range));
}

/// Compares two keys that have the same unit in the file.
void require_order(InputFile& in, const char* key, const char* other_key, bool above) {
  const double value = in.number(key);
  const double other = in.number(other_key);
  if (above ? value > other : value >= other) return;
  in.fail(key, "found " + shortest(value) + ", expected " +
                   (above ? "more than " : "no less than ") + other_key + ", " + shortest(other));
}

void read_torque(InputFile& in, TorqueControl::Params& p) {
  p.rated_speed_radps = speed(in, "RatedGeneratorSpeed");
  p.rated_torque_Nm = in.number("RatedTorque", Range::positive());
  p.max_torque_Nm = in.number("MaximumTorque", Range::positive());
  p.max_rate_Nmps = in.number("MaximumTorqueRate", Range::positive());
  p.cut_in_speed_radps = speed(in, "CutInSpeed");
  p.low_speed_radps = speed(in, "LowSpeedSetPoint");
  p.above_rated =
      static_cast<TorqueControl::AboveRated>(in.choice("AboveRated", {"power", "torque"}));
  require_order(in, "MaximumTorque", "RatedTorque", false);
  require_order(in, "LowSpeedSetPoint", "CutInSpeed", true);
  require_order(in, "RatedGeneratorSpeed", "LowSpeedSetPoint", true);
}

void read_pitch(InputFile& in, double rated_speed_radps, PitchControl::Params& p) {
  p.rated_speed_radps = rated_speed_radps;
  p.fine_pitch_rad = degrees(in, "FinePitch", Range::between(-20.0, 90.0));
  p.max_pitch_rad = degrees(in, "MaximumPitch", Range::between(-20.0, 120.0));
  p.max_rate_radps = degrees(in, "MaximumPitchRate", Range::positive());
  require_order(in, "MaximumPitch", "FinePitch", true);
}

void read_speed_filter(InputFile& in, const TorqueControl::Params& torque, SpeedFilter::Params& p) {
  p.gearbox_ratio = in.number("GearboxRatio", Range::positive());
  p.blades = in.integer("NumberOfBlades", p.blades, Range::between(1, 9));
  p.low_pass_hz = in.number("SpeedLowPass", Range::positive());
  p.notch_bandwidth_hz = in.number("NotchBandwidth", Range::not_negative());
  p.notch_depth = in.number("NotchDepth", p.notch_depth, Range::between(0.0, 1.0));
  p.notch_tracking_hz = in.number("NotchTracking", p.notch_tracking_hz, Range::positive());
  p.min_speed_radps = torque.cut_in_speed_radps;
  p.max_speed_radps = kHighestSpeedOverRated * torque.rated_speed_radps;
}

void read_fading(InputFile& in, const TorqueControl::Params& torque, SetPointFading::Params& p) {
  p.speed_range_radps = radps_from_rpm(in.number("FadingSpeed", Range::not_negative()));
  p.pitch_range_rad = degrees(in, "FadingPitch", Range::positive());
  p.power_range_W = 1000.0 * in.number("FadingPower", Range::positive());
  p.low_pass_hz = in.number("FadingLowPass", p.low_pass_hz, Range::positive());
  const double reach_radps = 0.5 * (torque.rated_speed_radps - torque.low_speed_radps);
  if (p.speed_range_radps >= reach_radps) {
    in.fail("FadingSpeed", "found " + shortest(rpm_from_radps(p.speed_range_radps)) +
                               " rpm, expected less than half of what lies between "
                               "LowSpeedSetPoint and RatedGeneratorSpeed, " +
                               shortest(rpm_from_radps(reach_radps)) +
                               " rpm: the torque loop would step between its set points");
  }
}

void read_actuator(InputFile& in, FeedbackParams& p) {
  p.use_actuator = in.flag("UsePitchActuator", false);
  p.actuator.min_rad = p.pitch.fine_pitch_rad;
  p.actuator.max_rad = p.pitch.max_pitch_rad;
  p.actuator.max_rate_radps = p.pitch.max_rate_radps;
  p.actuator.frequency_radps =
      radps_from_hz(in.number("PitchActuatorFrequency",
                              p.actuator.frequency_radps / radps_from_hz(1.0), Range::positive()));
  p.actuator.damping =
      in.number("PitchActuatorDamping", p.actuator.damping, Range::between(0.01, 0.999));
}

void read_set_points_of_others(InputFile& in, FeedbackParams& p) {
  p.use_feedforward = in.flag("UseFeedforward", false);
  p.use_power_level = in.flag("UsePowerLevel", false);
  p.max_power_level = in.number("MaximumPowerLevel", p.max_power_level, Range::between(1.0, 2.0));
  p.power_level_rate_per_s =
      in.number("PowerLevelRate", p.power_level_rate_per_s, Range::positive());
}

template <class Keys>
void refuse(InputFile& in, const Keys& keys, const char* mode) {
  for (const char* key : keys) {
    if (in.has(key)) in.fail(key, std::string("found, expected only if Gains is ") + mode);
  }
}

/// Runs what may throw Error without knowing the file, and puts file, line and key in front.
template <class Function>
auto at_key(const InputFile& in, const char* key, Function function) {
  try {
    return function();
  } catch (const Error& error) {
    in.fail(key, error.what());
  }
}

DesignPlant read_plant(InputFile& in, const FeedbackParams& p) {
  const std::string table = in.text("RotorTable");
  const double radius_m = in.number("RotorRadius", Range::positive());
  const double air_density_kgpm3 = in.number("AirDensity", 1.225, Range::positive());
  DesignPlant plant{{at_key(in, "RotorTable", [&] { return RotorTable::load(in.resolve(table)); }),
                     radius_m, air_density_kgpm3}};
  plant.inertia_kgm2 = in.number("InertiaLowSpeedShaft", Range::positive());
  plant.gearbox_ratio = p.speed.gearbox_ratio;
  plant.gearbox_efficiency = in.number("GearboxEfficiency", 1.0, Range::between(0.5, 1.0));
  plant.rated_generator_speed_radps = p.torque.rated_speed_radps;
  plant.rated_generator_torque_Nm = p.torque.rated_torque_Nm;
  plant.fine_pitch_rad = p.pitch.fine_pitch_rad;
  return plant;
}

std::vector<double> read_design_winds(InputFile& in) {
  std::vector<double> winds = in.numbers("DesignWindSpeed", Range::positive());
  for (std::size_t i = 1; i < winds.size(); ++i) {
    if (winds[i] <= winds[i - 1]) in.fail("DesignWindSpeed", "values do not rise, expected rising");
  }
  return winds;
}

LoopTarget read_target(InputFile& in, const char* damping_key, const char* frequency_key) {
  return {in.number(damping_key, kLoopRange), in.number(frequency_key, kLoopRange)};
}

void design_gains(InputFile& in, FeedbackParams& p) {
  refuse(in, kGivenKeys, "given");
  const DesignPlant plant = read_plant(in, p);
  const std::vector<double> winds = read_design_winds(in);
  const LoopTarget pitch = read_target(in, "PitchLoopDamping", "PitchLoopFrequency");
  const LoopTarget torque = read_target(in, "TorqueLoopDamping", "TorqueLoopFrequency");
  const bool constant_power = p.torque.above_rated == TorqueControl::AboveRated::ConstantPower;
  p.pitch.gains = at_key(in, "DesignWindSpeed",
                         [&] { return design_pitch_gains(plant, winds, pitch, constant_power); });
  p.torque.gains =
      at_key(in, "TorqueLoopDamping", [&] { return design_torque_gains(plant, torque); });
  p.torque.optimal_gain_Nms2prad2 =
      in.number("OptimalTorqueGain", design_optimal_gain(plant), Range::positive());
}

void read_gains(InputFile& in, FeedbackParams& p) {
  refuse(in, kDesignKeys, "design");
  const LookupTable proportional =
      read_table(in, "GainSchedulePitch", "ProportionalGain", 1.0, Range::positive());
  const LookupTable time =
      read_table(in, "GainSchedulePitch", "IntegralTime", 1.0, Range::positive());
  std::vector<double> pitch_rad = proportional.x();
  for (double& v : pitch_rad) v = rad_from_deg(v);
  p.pitch.gains = {{pitch_rad, proportional.y()}, {pitch_rad, time.y()}};
  p.torque.gains = {in.number("TorqueProportionalGain", Range::positive()),
                    in.number("TorqueIntegralTime", Range::positive())};
  p.torque.optimal_gain_Nms2prad2 = in.number("OptimalTorqueGain", Range::positive());
}

}  // namespace

FeedbackParams FeedbackParams::read(InputFile& in) {
  FeedbackParams p;
  read_torque(in, p.torque);
  read_pitch(in, p.torque.rated_speed_radps, p.pitch);
  read_speed_filter(in, p.torque, p.speed);
  read_fading(in, p.torque, p.fading);
  read_actuator(in, p);
  read_set_points_of_others(in, p);
  if (in.choice("Gains", {"design", "given"}) == 0) {
    design_gains(in, p);
  } else {
    read_gains(in, p);
  }
  in.finish();
  return p;
}

void FeedbackParams::check_time_step(const InputFile& in, double time_step_s) const {
  const auto require_below_nyquist = [&](const char* key, const char* what, double frequency_hz) {
    if (frequency_hz < 0.5 / time_step_s) return;
    in.fail(key, what + shortest(frequency_hz) + " Hz, expected less than " +
                     shortest(0.5 / time_step_s) + " Hz, half the rate at which the host calls");
  };
  require_below_nyquist("SpeedLowPass", "found ", speed.low_pass_hz);
  require_below_nyquist("NotchBandwidth", "found ", speed.notch_bandwidth_hz);
  require_below_nyquist("NotchTracking", "found ", speed.notch_tracking_hz);
  require_below_nyquist("FadingLowPass", "found ", fading.low_pass_hz);
  require_below_nyquist("RatedGeneratorSpeed", "at twice this speed the notch lies at ",
                        SpeedFilter::notch_centre_hz(speed, speed.max_speed_radps));
}

}  // namespace lac
