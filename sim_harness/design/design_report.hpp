// SPDX-License-Identifier: Apache-2.0
// What `lac design` says and writes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim_harness/design/closed_loop.hpp"
#include "sim_harness/design/pitch_curve.hpp"

namespace lac::sim {

struct DesignResult {
  const DesignCase& design;
  LidarVolumes lidar;
  CorrelationCurves curves;
  std::vector<FeedforwardPoint> points;
  double quadrature_error = 0.0;
  std::optional<PitchCurve> pitch_curve = {};  // if the design makes one
  std::vector<FlownLidar> flown = {};          // if the design names a campaign
  std::optional<ClosedLoop> closed_loop = {};  // if it knows the feedback controller
};

/// For the terminal, one row per wind speed.
std::string design_table(const DesignResult& result);

/// The template with the schedule in the place of CutOffWindSpeed and CutOffFrequency, and above
/// it, in comments, what it was made from; comments right above these keys, which tell of other
/// numbers, are left out. Everything else stays as it is. Precondition: the template was read.
std::string designed_ffp_input(std::string_view template_text, const DesignResult& result);

/// The table and all curves as comma-separated text.
std::string schedule_csv(const DesignResult& result);
std::string curves_csv(const DesignResult& result);

}  // namespace lac::sim
