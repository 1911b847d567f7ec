// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>

#include "sim_harness/wind/iec_wind.hpp"
#include "sim_harness/wind/wind_field.hpp"

namespace lac::sim {

struct SteadySpeed {
  double speed_mps = 10.0;
};

/// from_mps before time_s, to_mps once ramp_s has passed, a straight line between.
struct StepSpeed {
  double from_mps = 10.0;
  double to_mps = 11.0;
  double time_s = 60.0;
  double ramp_s = 0.0;
};

/// Extreme operating gust (IEC 61400-1 ed. 3, methods section 14) arriving at start_s.
struct GustSpeed {
  double mean_speed_mps = 18.0;
  double magnitude_mps = 0.0;  // V_gust; eog_magnitude_mps() gives IEC's
  double start_s = 60.0;
};

/// Hub-height speed over time of arrival at the rotor plane.
using SpeedHistory = std::variant<SteadySpeed, StepSpeed, GustSpeed>;

struct UniformWindParams {
  SpeedHistory speed = SteadySpeed{};
  /// Power-law profile (z / z_hub)^shear_exponent on the mean speed; IEC leaves the gust itself
  /// the same at all heights. 0: no shear.
  double shear_exponent = 0.0;
  double hub_height_m = 90.0;
  /// Speed U at which the history travels; if not given the speed before the event.
  std::optional<double> advection_speed_mps;
};

/// Wind along x only, the same over y (and z without shear), carried with Taylor's hypothesis:
/// u(x, y, z, t) = f(t - x / U). Defined for all times; with shear for z >= 0 only.
class UniformWind final : public WindField {
 public:
  /// Throws lac::Error if a speed, height or duration is not usable.
  explicit UniformWind(const UniformWindParams& params);

  Vec3 velocity(const Vec3& position_I_m, double time_s) const override;
  double mean_speed_mps() const override { return advection_speed_mps_; }
  WindExtent extent() const override;
  /// Without shear the hub alone.
  std::vector<DiskPoint> disk_points(double hub_height_m, double radius_m) const override;

 private:
  UniformWindParams params_;
  double advection_speed_mps_;
};

}  // namespace lac::sim
