// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "sim_harness/wind/gridded_wind.hpp"
#include "sim_harness/wind_check/turbulence_theory.hpp"

namespace lac::sim {

struct CheckSettings {
  /// Probability that a field of this theory passes all tests together: each band is tested at
  /// (1 + confidence^(1 / tests)) / 2. Bands that are shown have 95 % each.
  double confidence = 0.99;
  /// What is let pass beyond the statistical limits, since with many points these get narrower than
  /// anyone needs: relative in spectra (variances), absolute in root coherence.
  double spectrum_allowance = 0.03;
  double coherence_allowance = 0.02;
  double max_frequency_hz = std::numeric_limits<double>::infinity();
  /// Blocks of a field that does not repeat; 0: a quarter of it. A periodic one is taken whole.
  double block_s = 0.0;
};

/// Means over one band of frequencies, all points and all blocks.
struct CheckPoint {
  double frequency_hz = 0.0;  // mean of the band
  double found = 0.0;
  double expected = 0.0;
  double low = 0.0;  // 95 % of fields of the theory are between low and high
  double high = 0.0;
  bool inside = false;  // of the limits of the test
};

struct CheckCurve {
  int component = 0;
  double dy_m = 0.0;  // separation; spectra have none
  double dz_m = 0.0;
  std::vector<CheckPoint> points;
};

struct TheoryCheck {
  std::vector<CheckCurve> spectra;     // u, v, w
  std::vector<CheckCurve> coherences;  // real part of the root coherency, u, v, w
  std::vector<CheckPoint> sigmas;  // u, v, w over the frequencies of the spectra, f their lowest
  double lowest_hz = 0.0;
  double highest_hz = 0.0;
  int lattice_points = 0;  // that were used, of large grids every k-th
  int tests = 0;
  int outside = 0;

  bool passed() const { return outside == 0; }
};

/// Compares a field with a theory at its grid points. Limits count with the correlation of points
/// (lattice_moments.hpp), with overlap and window (BlockTransform): chi-square for spectra and
/// variances, normal after Fisher's transformation for coherence. Coherence is tested where at
/// least ten independent values are behind a band.
/// Throws lac::Error if the field is too short for one block or the settings cannot be.
TheoryCheck check_field(const GriddedWind& wind, const TurbulenceTheory& theory,
                        const CheckSettings& settings = {});

}  // namespace lac::sim
