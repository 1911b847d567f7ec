// SPDX-License-Identifier: Apache-2.0
// Input of `lac design` (docs/design.md lists the keys).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ffp/ffp_params.hpp"
#include "sim_harness/design/design_turbulence.hpp"
#include "sim_harness/design/feedback_design.hpp"
#include "sim_harness/design/feedforward_design.hpp"
#include "sim_harness/design/flown_lidar.hpp"
#include "sim_harness/design/flown_rotor_speed.hpp"
#include "sim_harness/design/mann_correlation.hpp"
#include "sim_harness/design/optimize_settings.hpp"

namespace lac::sim {

struct DesignCase {
  std::filesystem::path file;
  std::string name;
  double rotor_radius_m = 0.0;
  double hub_height_m = 0.0;
  std::optional<TurbineParams> turbine;  // if the file names one
  LidarParams lidar;
  LidarVolumeSettings volumes;
  DesignTurbulence turbulence;
  MannQuadrature quadrature;
  std::vector<double> speeds_mps;
  CurveSettings curves;  // its scan time 0 unless scan averaging is asked for
  TurbulenceCategory category = TurbulenceCategory::kA;  // level of the closed loop's spectra
  std::filesystem::path ffp_template;
  FfpParams ffp;  // of the template
  CutoffRule rule = CutoffRule::kAtMinus3dB;
  FeedforwardTiming timing;          // of the template and the lidar
  bool designs_pitch_curve = false;  // else that of the template stays
  std::optional<FeedbackDesign> feedback;
  std::vector<FlownRuns> flown;
  std::optional<FlownCampaign> flown_lidar;
  std::optional<OptimizeSettings> optimize;  // of `lac optimize`
  std::filesystem::path output_folder;
};

/// Reads a design file; overrides as in YamlReader::load. Throws lac::Error: file, line, key,
/// found, expected, hint.
DesignCase load_design(const std::filesystem::path& file,
                       const std::vector<std::string>& overrides = {});

std::unique_ptr<CorrelationModel> make_correlation(const DesignCase& design,
                                                   const LidarVolumes& lidar);

/// One line, for reports.
std::string describe_model(const DesignCase& design);

}  // namespace lac::sim
