// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "sim_harness/wind/uniform_history.hpp"
#include "sim_harness/wind/wind_field.hpp"

namespace lac::sim {

struct UniformWindParams {
  UniformHistory history = SteadySpeed{};
  /// Power-law profile (z / z_hub)^shear_exponent on the mean speed; IEC leaves the gust itself
  /// the same at all heights. 0: no shear. A table has its own.
  double shear_exponent = 0.0;
  double hub_height_m = 90.0;
  /// L of the linear shears: the rotor diameter in IEC's events, RefLength of InflowWind in files.
  double reference_length_m = 126.0;
  /// Speed U at which the history travels; if not given the speed before the event.
  std::optional<double> advection_speed_mps;
};

/// Wind that one state describes at a time (uniform_history.hpp), carried along x with Taylor's
/// hypothesis: velocity(x, y, z, t) = f(y, z, t - x / U). Defined for all times; with a power law
/// for z >= 0 only. (InflowWind lets a uniform wind act at all x at the same time.)
class UniformWind final : public WindField {
 public:
  /// Throws lac::Error if a speed, height, duration or table is not usable.
  explicit UniformWind(const UniformWindParams& params);

  Vec3 velocity(const Vec3& position_I_m, double time_s) const override;
  double mean_speed_mps() const override { return advection_speed_mps_; }
  WindExtent extent() const override;
  /// Without shear the hub alone.
  std::vector<DiskPoint> disk_points(double hub_height_m, double radius_m) const override;

  UniformState state(double arrival_s) const;
  const UniformWindParams& params() const { return params_; }

 private:
  UniformWindParams params_;
  double advection_speed_mps_;
  UniformShear shear_;
};

/// The states at begin, begin + step, ... end (within half a step), for a uniform wind file. Rows
/// that equal both neighbours are left out. Throws lac::Error unless begin < end and step > 0.
UniformTable tabulate(const UniformWind& wind, double begin_s, double end_s, double step_s);

}  // namespace lac::sim
