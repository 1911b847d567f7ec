// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "sim_harness/design/correlation_model.hpp"

namespace lac::sim {

/// Spectra over frequency at one mean wind speed, of one set of planes.
struct CorrelationCurve {
  double mean_speed_mps = 0.0;
  std::vector<double> k1_radpm;  // rising
  std::vector<double> s_rr;      // [m^2/s^2/Hz], one-sided in f
  std::vector<double> s_ll;
  std::vector<std::complex<double>> s_rl;

  double frequency_hz(std::size_t i) const;
  /// gamma^2 = |S_RL|^2 / (S_RR S_LL) (GUO eq. 34, HM eq. 5).
  std::vector<double> coherence() const;
  /// |G_RL| = |S_RL| / S_LL (GUO eq. 35).
  std::vector<double> gain() const;
  /// Phase of S_RL over 2 pi f: how late the estimate is after its delay [s]. In turbulence without
  /// divergence v and w turn into it: beams that spread see wind nearer to the rotor than their
  /// gates, about half of (n_y^2 + n_z^2)/n_x^2 of the distance.
  std::vector<double> lateness_s() const;
};

struct CurveSettings {
  double first_k1_radpm = 1e-3;
  double last_k1_radpm = 0.15;
  int points = 61;
  int threads = 2;
  /// Every beam's speed is held for one scan: S_LL times sinc^2, S_RL times sinc (f T_scan); its
  /// delay of half a scan belongs to the buffer. 0: not part of the model.
  double scan_time_s = 0.0;
};

/// Curves of a model for all wind speeds, and all sets of planes that leave out the nearest ones.
class CorrelationCurves {
 public:
  /// Throws lac::Error on settings out of range.
  CorrelationCurves(const CorrelationModel& model, std::vector<double> speeds_mps,
                    const CurveSettings& settings);

  const std::vector<double>& speeds_mps() const { return speeds_mps_; }
  /// first_plane as in RotorLidarSpectra.
  CorrelationCurve curve(std::size_t speed, std::size_t first_plane = 0) const;

 private:
  std::vector<double> speeds_mps_;
  double scan_time_s_;
  std::vector<double> k1_radpm_;
  std::vector<std::vector<RotorLidarSpectra>> spectra_;  // [k1][speed]
};

}  // namespace lac::sim
