// SPDX-License-Identifier: Apache-2.0
// Spectra and coherence of one or many stretches of two series, with confidence bands.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "sim_harness/analysis/block_transform.hpp"

namespace lac::sim {

/// All of one length, at rising frequencies, without those that detrending has emptied.
struct CrossSpectrum {
  std::vector<double> frequency_hz;
  std::vector<double> density_x;            // one-sided [x^2/Hz]
  std::vector<double> density_y;            // [y^2/Hz]
  std::vector<std::complex<double>> cross;  // mean of conj(X) Y [x y/Hz]
  std::vector<double> coherence;            // magnitude squared, |cross|^2 / (Sx Sy)
  double independent_blocks = 0.0;          // what the overlapping blocks are worth
};

/// Of a block [samples]: below, no frequency is left.
inline constexpr std::size_t kLeastBlock = 7;

struct Band {
  std::vector<double> low;
  std::vector<double> high;
};

/// Means over all blocks of all stretches: Welch, 50 % overlap, Hamming window, mean and linear
/// trend of each block removed (methods section 0).
class CrossSpectrumEstimator {
 public:
  /// Throws lac::Error if block_samples < kLeastBlock.
  CrossSpectrumEstimator(double time_step_s, std::size_t block_samples);

  /// A stretch without gaps, x and y of equal length. One shorter than a block is left out: false.
  /// Throws lac::Error if the lengths differ or a value is not finite.
  bool add(std::span<const double> x, std::span<const double> y);

  std::size_t blocks() const { return blocks_; }
  /// Throws lac::Error if no stretch was long enough.
  CrossSpectrum result() const;

 private:
  double time_step_s_;
  std::size_t block_samples_;
  std::size_t blocks_ = 0;
  double squared_variance_sum_ = 0.0;  // of stretches: (blocks)^2 times variance of their mean
  std::vector<double> sum_x_, sum_y_;
  std::vector<std::complex<double>> sum_cross_;
};

/// Where the density lies with this confidence, each frequency by itself: chi-square with twice the
/// independent blocks as degrees of freedom.
Band density_band(std::span<const double> density, double independent_blocks, double confidence);

/// Where the magnitude-squared coherence lies: atanh of its root is normal with variance
/// 1/(2 (n - 1)) about its true value plus as much (Enochson and Goodman 1965), n the independent
/// blocks; good from n = 20 on. Not below 0. Throws lac::Error unless n > 1.
Band coherence_band(std::span<const double> coherence, double independent_blocks,
                    double confidence);

/// What independent series stay below with this confidence: 1 - (1 - confidence)^(1/(n - 1)).
double coherence_by_chance(double independent_blocks, double confidence);

/// The first frequency at which values fall through the level, linear between; NaN if they start
/// below or never do.
double first_fall_hz(std::span<const double> frequency_hz, std::span<const double> values,
                     double level);

}  // namespace lac::sim
