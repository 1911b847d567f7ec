// SPDX-License-Identifier: Apache-2.0
// Coherence and delay of a flown lidar beside those of the model (HM sections 4.1 to 4.3).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim_harness/design/correlation_curve.hpp"
#include "sim_harness/design/design_case.hpp"

namespace lac::sim {

/// One mean wind speed. Coherence is compared at frequencies where the model's is 0.1 and more:
/// below, the estimate is dominated by its bias.
struct LidarComparison {
  double mean_speed_mps = 0.0;
  std::size_t runs = 0;
  double independent_blocks = 0.0;
  int inside = 0, compared = 0;  // frequencies whose 95 % band holds the model
  double mean_difference = 0.0;  // over the compared, flown less model
  double flown_k05_radpm = 0.0;  // NaN: does not fall through 1/2
  double model_k05_radpm = 0.0;
  double flown_delay_s = 0.0;
  double lead_s = 0.0;         // that LDP stated, less half a window
  double expected_s = 0.0;     // distance of the nearest gate over U, less half a scan (HM eq. 25)
  double model_delay_s = 0.0;  // expected, less what S_RL says the estimate is late by
  double filter_s = 0.0;       // low-pass with its cut-off at k0.5 U (HM eq. 26)
  bool is_enough() const { return expected_s >= filter_s; }
};

/// speeds that the design does not have are refused (lac::Error).
std::vector<LidarComparison> compare_flown_lidar(const DesignCase& design,
                                                 const LidarVolumes& lidar,
                                                 const CorrelationCurves& curves,
                                                 const std::vector<FlownLidar>& flown);

std::string flown_lidar_table(const std::vector<LidarComparison>& rows);

/// speed, frequency, coherence of model and flight, and the band.
std::string flown_coherence_csv(const CorrelationCurves& curves,
                                const std::vector<FlownLidar>& flown);

}  // namespace lac::sim
