// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace lac::sim {

enum class Taper {
  kNone,     // the series repeats after its end: one block, its frequencies independent
  kHamming,  // blocks of any series with 50 % overlap, mean and linear trend of each removed
};

/// Fourier transforms of the blocks of series that all have one length: what spectra and cross
/// spectra are means of products of. X is scaled such that the mean of |X|^2 is the one-sided
/// density [unit^2/Hz], at frequencies k / (block_samples dt), k = 0 ... block_samples / 2.
class BlockTransform {
 public:
  /// kNone takes the whole series as its block. Throws lac::Error if block_samples < 4 or the
  /// series is shorter than a block.
  BlockTransform(std::size_t samples, double time_step_s, std::size_t block_samples, Taper taper);

  std::size_t blocks() const { return blocks_; }
  std::size_t bins() const { return block_samples_ / 2 + 1; }
  double frequency_hz(std::size_t bin) const { return static_cast<double>(bin) * df_hz_; }
  /// The lowest bin that says something: 1, or 3 where detrending has taken from those below.
  std::size_t first_bin() const { return taper_ == Taper::kNone ? 1 : 3; }
  /// Behind the last one; the Nyquist frequency of an even block, its own mirror, left out.
  std::size_t end_bin() const { return (block_samples_ + 1) / 2; }

  /// [block][bin].
  std::vector<std::complex<double>> operator()(std::span<const double> series) const;

  /// Expected |X|^2 of a bin in a process of this density: its mean over the bin (kNone; Simpson's
  /// rule), or what the window gathers around it (kHamming; over 6 bins to either side).
  double expected(std::size_t bin, const std::function<double(double)>& density_of_hz) const;

  /// Variance of the mean of |X|^2 / expected over all blocks and the bins [first, end) for a
  /// Gaussian process: 1 / (end - first) with kNone; with kHamming overlap and window are allowed
  /// for. Times 2: the degrees of freedom are 2 over it.
  double variance_of_mean(std::size_t first, std::size_t end) const;
  /// The same of a sum over neighbouring bins, each the mean over blocks times its weight.
  double variance_of_sum(std::span<const double> weights) const;

 private:
  void prepare_window();

  std::size_t block_samples_;
  std::size_t blocks_;
  double time_step_s_;
  double df_hz_;
  Taper taper_;
  std::vector<double> window_;
  double scale_ = 0.0;
  std::vector<double> correlation_[2];  // |.|^2 of bins k apart, in one block and in neighbours
  std::vector<double> kernel_;          // share of a quarter of a bin, from -6 bins to 6
};

}  // namespace lac::sim
