// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/lidar_block.hpp"
#include "sim_harness/lidar/blade_blockage.hpp"
#include "sim_harness/lidar/carrier_to_noise.hpp"
#include "sim_harness/lidar/hard_target.hpp"
#include "sim_harness/lidar/induction_zone.hpp"
#include "sim_harness/lidar/lidar_clock.hpp"
#include "sim_harness/lidar/lidar_outages.hpp"
#include "sim_harness/lidar/speed_noise.hpp"
#include "sim_harness/lidar/turbine_state.hpp"

namespace lac::sim {

/// What keeps a real lidar from seeing perfectly. All of it is off by default.
struct LidarWeaknessParams {
  InductionParams
      induction;  // acts on the wind it sees (induced_wind.hpp), the rest on what it says
  CarrierToNoiseParams carrier_to_noise;
  std::vector<HardTarget> hard_targets;
  SpeedNoiseParams speed_noise;
  BladeBlockageParams blade_blockage;
  OutageParams outages;
  LidarClockParams clock;

  bool spoils_measurements() const;
};

/// Maps induction, carrier_to_noise, speed_noise, blade_blockage, outages, clock and the list
/// hard_targets; one that is missing is off. Throws lac::Error.
LidarWeaknessParams read_lidar_weaknesses(YamlReader& in);

/// What the weaknesses must know of the lidar and its surroundings.
struct LidarWeaknessSetting {
  std::uint64_t seed = 1;  // of the case
  int number_of_blades = 3;
  double rotor_radius_m = 63.0;
  int beams = 1;
  double interval_s = 0.25;  // from one measurement to the next
  RangeWeighting weighting = {};
  Vec3 position_N_m = {};  // from the rotor centre
  Rotation R_NL = rotation_from_roll_pitch_yaw(0.0, 0.0, kPi);
  bool turns_with_rotor = false;  // on the spinner, where no blade passes
};

/// Spoils finished measurements, in this order: carrier-to-noise ratio of the air; echoes of hard
/// targets; speed noise; blades; the threshold of the carrier-to-noise ratio; outages; time stamp
/// and delivery. A gate that ends up invalid has no speed (not a number). Without a model of the
/// carrier-to-noise ratio air has 0 dB and a gate behind a hard target is lost below -20 dB. Of the
/// opaque hard targets that a beam meets the nearest one counts: nothing behind it is seen.
/// Random numbers of one effect do not depend on the others.
class LidarWeaknesses {
 public:
  /// Throws lac::Error for what does not fit the lidar: blades that it does not look through or
  /// that end more than 5 % off the rotor's radius, a hard target in a beam that it does not have,
  /// impossible bursts.
  LidarWeaknesses(const LidarWeaknessParams& params, const LidarWeaknessSetting& setting);

  /// To be called in every controller step, with what the lidar has; gives the new is_new, and a
  /// measurement whenever that is true. Allocates nothing.
  bool pass(double now_s, const TurbineState& turbine, LidarMeasurement& measurement,
            bool is_new) noexcept;

 private:
  void spoil(double now_s, const TurbineState& turbine, LidarMeasurement& m) noexcept;
  bool blocked(double now_s, const TurbineState& turbine, const LidarMeasurement& m) const noexcept;
  void set_air_echo(LidarMeasurement& m) noexcept;
  void mix_in_targets(LidarMeasurement& m) const noexcept;
  void judge_echoes(bool blocked, LidarMeasurement& m) const noexcept;

  bool active_;
  RangeWeighting weighting_;
  Vec3 position_N_m_;
  Rotation R_NL_;
  std::vector<HardTarget> hard_targets_;  // the farthest first
  CarrierToNoise carrier_to_noise_;
  SpeedNoise noise_;
  BladeBlockage blades_;
  Outages outages_;
  LidarClock clock_;
};

}  // namespace lac::sim
