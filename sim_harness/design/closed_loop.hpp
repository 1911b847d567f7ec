// SPDX-License-Identifier: Apache-2.0
// The rotor speed that a design promises, and what becomes of it with another tuning.
#pragma once

#include <string>
#include <vector>

#include "sim_harness/design/design_case.hpp"
#include "sim_harness/design/rotor_speed_prediction.hpp"

namespace lac::sim {

/// Standard deviations of the rotor speed at one mean wind speed [rad/s].
struct ClosedLoopPoint {
  std::size_t speed = 0;  // of the design's wind speeds
  double mean_speed_mps = 0.0;
  FeedforwardTuning designed, of_template;  // of_template: the schedule it came with
  double feedback_only = 0.0;
  double assisted = 0.0;                           // as designed
  double least = 0.0;                              // no filter does better
  double late = 0.0, early = 0.0;                  // by kBufferError_s
  double half_cutoff = 0.0, twice_cutoff = 0.0;    // the buffer computed anew
  double best_trim_s = 0.0, with_best_trim = 0.0;  // BufferTrim that would be best here
  double with_template = 0.0;
  std::string template_verdict;  // why it is worse, if it is
  /// Of the time, were the filtered estimate normal; NaN if the entry has no threshold.
  double share_above_threshold = 0.0;
};
inline constexpr double kBufferError_s = 1.0;

struct ClosedLoop {
  std::vector<ClosedLoopPoint> points;
  std::vector<RotorSpeedPrediction> predictions;  // of the same
};

/// For the wind speeds 0.5 m/s above rated where the feedforward can be used. Spectra have the
/// level of the normal turbulence model. Precondition: the design has turbine and feedback.
/// pitch_curve: the one that is flown.
ClosedLoop predict_closed_loop(const DesignCase& design, const CorrelationCurves& curves,
                               const std::vector<FeedforwardPoint>& points,
                               const LookupTable& pitch_curve);

/// For the terminal: changes against feedback only.
std::string closed_loop_table(const ClosedLoop& loop);
std::string closed_loop_csv(const ClosedLoop& loop);
/// Predicted spectra, all wind speeds [rpm^2/Hz].
std::string rotor_speed_csv(const ClosedLoop& loop);

/// Variance of the rotor speed by band [rpm^2], predicted beside flown; empty without flown runs.
/// Names the runs at speeds that the loop does not have.
std::string flown_table(const ClosedLoop& loop, const DesignCase& design);

}  // namespace lac::sim
