// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lac::sim {

/// One-sided power spectral density: sum(density) * df is the variance.
struct Spectrum {
  std::vector<double> frequency_hz;  // rising
  std::vector<double> density;       // [unit^2/Hz], same length
};

/// Welch's estimate: blocks of block_samples with 50 % overlap, mean and linear trend of each
/// block removed, periodic Hamming window, densities averaged. Frequencies 0 ... 1/(2 dt) in
/// steps of 1/(block_samples dt); samples that do not fill a last block are not used. The values at
/// frequency 0 and 1 hold what the detrending leaves and mean little. Throws lac::Error if
/// block_samples < 4 or the series is shorter than a block.
Spectrum welch(std::span<const double> series, double time_step_s, std::size_t block_samples);

/// For log-log plots: means of frequency and density over bins of equal width in log(f); empty
/// bins and f = 0 left out, so that low frequencies stay as they are.
Spectrum log_binned(const Spectrum& spectrum, std::size_t bins_per_decade);

}  // namespace lac::sim
