// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "sim_harness/host/controller_host.hpp"
#include "sim_harness/lidar/induced_wind.hpp"
#include "sim_harness/lidar/lidar_fault.hpp"
#include "sim_harness/lidar/lidar_sim.hpp"
#include "sim_harness/lidar/lidar_weaknesses.hpp"
#include "sim_harness/run/case_file.hpp"

namespace lac::sim {

/// The lidar of a case with its weaknesses and its fault, or none.
class LidarOnBoard {
 public:
  /// The wind must outlive this object. Throws lac::Error for a lidar that cannot measure in it.
  LidarOnBoard(const Case& c, const WindField& wind);

  /// To be called for steps 0, 1, 2, ...: what the controller would get. True if it is new, and
  /// then in measurement().
  bool measure(std::int64_t step, const TurbineState& turbine);
  const LidarMeasurement& measurement() const { return measurement_; }

  /// The same, handed to the host.
  void sense(std::int64_t step, const TurbineState& turbine, ControllerHost& host);

 private:
  double step_s_;
  std::optional<InducedWind> induced_wind_;  // if there is induction
  std::optional<LidarSim> lidar_;
  std::optional<LidarWeaknesses> weaknesses_;
  std::optional<LidarFaultInjector> fault_;
  LidarMeasurement measurement_;
};

}  // namespace lac::sim
