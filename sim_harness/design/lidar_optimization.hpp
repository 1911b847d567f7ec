// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim_harness/design/design_case.hpp"
#include "sim_harness/design/lidar_layout.hpp"

namespace lac::sim {

/// One layout, judged. Margins: below 0 the constraint is broken.
struct LayoutFigures {
  double k05_radpm = 0.0;  // 0: nowhere as coherent as that
  double lead_margin_s = 0.0;
  double angle_margin_rad = 0.0;
  double height_margin_m = 0.0;
  bool is_allowed() const {
    return lead_margin_s >= 0.0 && angle_margin_rad >= 0.0 && height_margin_m >= 0.0;
  }
};

/// Judges layouts by the turbulence, rotor, lidar (whose beams and gates are replaced) and timing
/// of a design. k0.5 to 1e-7: what a search compares must be smooth.
class LayoutJudge {
 public:
  LayoutJudge(const DesignCase& design, const OptimizeSettings& settings)
      : design_(design), settings_(settings) {}

  /// Throws lac::Error if a gate lies behind the rotor.
  LayoutFigures figures(const LidarLayout& layout) const;
  LayoutFigures figures(const LidarParams& lidar) const;

 private:
  double lead_margin_s(const CorrelationModel& model, const LidarVolumes& lidar,
                       double scan_time_s) const;

  const DesignCase& design_;
  const OptimizeSettings& settings_;
};

/// k0.5 over the angles, at the gates of the best layout.
struct LayoutMap {
  std::vector<double> azimuth_rad, elevation_rad;
  std::vector<LayoutFigures> figures;  // elevation after elevation
  const LayoutFigures& at(std::size_t azimuth, std::size_t elevation) const {
    return figures[elevation * azimuth_rad.size() + azimuth];
  }
};

struct OptimizedLidar {
  LidarLayout best;
  LayoutFigures figures;
  LidarLayout best_of_grid;
  LayoutFigures grid_figures;
  int judged = 0;  // layouts
  LayoutMap map;
};

/// For each number of beams: brute force over a grid of the angles, a free first gate at its
/// nearest (at its farthest if lead_at_mps is given), a free last one in the middle; from its best
/// point NLopt, COBYLA (Powell 1994), with all that is free, within bounds
/// and constraints; then the map at the gates that were found. Throws lac::Error if no point of the
/// grid keeps the constraints, if nothing is free, if the beams of the lidar take different times,
/// or as the judge does.
std::vector<OptimizedLidar> optimize_lidar(const DesignCase& design,
                                           const OptimizeSettings& settings);

}  // namespace lac::sim
