// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/kaimal.hpp"
#include "sim_harness/wind/kaimal_evolution.hpp"
#include "sim_harness/wind/velocity_grid.hpp"

namespace lac::sim {

/// What connects v, and w, of points in one plane. IEC gives a coherence for u only; the choice
/// moves the cut-off frequency of a multi-beam lidar by up to 10 % (methods section 1): say which
/// one was used with every result.
enum class LateralCoherence {
  kIndependent,  // no connection: the text of IEC, TurbSim's default
  kSameAsU,      // the coherence of u: what the frequency-domain correlation codes assume
};

struct KaimalFieldParams {
  KaimalModel model = iec_kaimal(3.056, 90.0);  // class A at 18 m/s
  ExponentialEvolution evolution;               // frozen
  double mean_speed_mps = 18.0;                 // U at hub height
  double hub_height_m = 90.0;                   // centre of the grid
  double shear_exponent = 0.0;                  // U (z / z_hub)^exponent; IEC has 0.2
  double width_m = 140.0;
  double height_m = 140.0;
  int ny = 27;
  int nz = 27;
  double dt_s = 0.1;
  double duration_s = 660.0;  // the period: the field repeats after it
  std::uint64_t seed = 1;
  LateralCoherence lateral_coherence = LateralCoherence::kIndependent;
  int threads = 2;  // changes the time taken, not one bit of the field
};

/// What all planes of a Kaimal field have in common: parameters, grid, spectra. Harmonics m of the
/// period T in time.
class KaimalSource {
 public:
  /// Throws lac::Error on parameters out of range.
  explicit KaimalSource(const KaimalFieldParams& params);

  const KaimalFieldParams& params() const { return params_; }
  const GridSpec& grid() const { return grid_; }
  /// Of u, at each height of the grid.
  const std::vector<float>& mean_profile_mps() const { return mean_mps_; }

  int harmonics() const { return grid_.nt / 2; }
  double frequency_hz(int m) const { return m * df_hz_; }
  /// The c of exp(-c r) across the wind [1/m].
  double coherence_rate(int m) const;
  /// Root coherence along the wind.
  double root_coherence(double dx_m, int m) const;
  bool coherent(int component) const;
  /// Of complex normal amplitudes as amplitudes_to_series() takes them: |A_m| / 2, or |A_m| of the
  /// Nyquist frequency, whose real part acts alone; E|A_m|^2 / 2 is the spectrum integrated over
  /// (m -+ 1/2) / T.
  double scale_mps(int component, int m) const;

 private:
  KaimalFieldParams params_;
  GridSpec grid_;
  double df_hz_;
  std::vector<float> mean_mps_;
};

}  // namespace lac::sim
