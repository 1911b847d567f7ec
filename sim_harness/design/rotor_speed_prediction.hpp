// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "sim_harness/design/feedforward_design.hpp"
#include "sim_harness/design/filter_fit.hpp"
#include "sim_harness/design/linear_turbine.hpp"

namespace lac::sim {

/// How the feedforward is set up; a wrong buffer time counts as a trim.
struct FeedforwardTuning {
  LowPassDesign low_pass;
  double trim_s = 0.0;  // positive: acts later
};

/// Spectrum of the rotor speed at one mean wind speed with the lidar's signal in the pitch
/// (methods section 13). With <R* L> = S_RL and G_L the way from the estimate L to the rotor speed,
///
///   S_Omega = |G_R|^2 S_RR + |G_L|^2 S_LL + 2 Re(G_R conj(G_L) S_RL),
///   G_L = G_theta theta_ss'(v) sinc(f T_w) H(f) e^(+i 2 pi f (T_filter + T_actuator -
///   trim))
///
/// as what leaves FFP is lead - buffer - T_w/2 = T_filter + T_actuator - trim ahead of the wind.
/// (The spectra have e^(-i 2 pi f t) as time, hence S_RL as it is.)
/// Linear: the feedforward is always on, the pitch curve a straight line.
class RotorSpeedPrediction {
 public:
  /// window_s: of LDP's average; 0 if the curve has it already. slope: of the pitch curve there
  /// [rad/(m/s)]. scale: of the spectra.
  RotorSpeedPrediction(const LinearTurbine& turbine, const CorrelationCurve& curve,
                       const FeedforwardTiming& timing, double slope_radspm, double window_s,
                       double scale);

  const std::vector<double>& frequency_hz() const { return frequency_hz_; }
  /// [(rad/s)^2/Hz]
  std::vector<double> feedback_only() const;
  std::vector<double> assisted(const FeedforwardTuning& tuning) const;
  /// What no filter of the lidar's signal can go below: |G_R|^2 S_RR (1 - gamma^2).
  std::vector<double> least() const;
  /// Standard deviation [rad/s]: trapezoids over the frequencies of the curve.
  double deviation_radps(const std::vector<double>& density) const;
  /// Variance between two frequencies [(rad/s)^2].
  double variance(const std::vector<double>& density, double from_hz, double to_hz) const;

  /// The trim within +-3 s with the least standard deviation.
  double best_trim_s(const LowPassDesign& low_pass) const;
  /// Standard deviation of the estimate behind LDP's window and the low-pass [m/s].
  double filtered_deviation_mps(const LowPassDesign& low_pass) const;

 private:
  std::vector<double> frequency_hz_, s_rr_, s_ll_, window_gain_;
  std::vector<std::complex<double>> s_rl_, per_wind_, per_estimate_;  // G_L without low-pass, delay
  FeedforwardTiming timing_;
};

}  // namespace lac::sim
