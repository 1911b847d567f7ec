// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/spectrum.hpp"

#include <cmath>
#include <complex>
#include <string>
#include <unsupported/Eigen/FFT>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

std::vector<double> hamming_window(std::size_t size) {
  std::vector<double> window(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double phase_rad = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(size);
    window[i] = 0.54 - 0.46 * std::cos(phase_rad);
  }
  return window;
}

std::vector<double> without_trend(std::span<const double> block) {
  const auto count = static_cast<double>(block.size());
  const double middle = 0.5 * (count - 1.0);
  double mean = 0.0;
  for (const double x : block) mean += x / count;
  double slope = 0.0;
  for (std::size_t i = 0; i < block.size(); ++i) {
    slope += (static_cast<double>(i) - middle) * (block[i] - mean);
  }
  slope *= 12.0 / (count * (count * count - 1.0));
  std::vector<double> rest(block.size());
  for (std::size_t i = 0; i < block.size(); ++i) {
    rest[i] = block[i] - mean - slope * (static_cast<double>(i) - middle);
  }
  return rest;
}

void require_usable(std::size_t samples, std::size_t block_samples) {
  if (block_samples >= 4 && samples >= block_samples) return;
  throw Error("spectrum: block of " + std::to_string(block_samples) + " samples for a series of " +
              std::to_string(samples) + ", expected at least 4 and no more than the series has");
}

}  // namespace

Spectrum welch(std::span<const double> series, double time_step_s, std::size_t block_samples) {
  require_usable(series.size(), block_samples);
  const std::vector<double> window = hamming_window(block_samples);
  double window_power = 0.0;
  for (const double w : window) window_power += w * w;

  const std::size_t bins = block_samples / 2 + 1;
  std::vector<double> sum(bins, 0.0);
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> transform;
  double blocks = 0.0;
  for (std::size_t at = 0; at + block_samples <= series.size(); at += block_samples / 2) {
    std::vector<double> block = without_trend(series.subspan(at, block_samples));
    for (std::size_t i = 0; i < block_samples; ++i) block[i] *= window[i];
    fft.fwd(transform, block);
    for (std::size_t k = 0; k < bins; ++k) sum[k] += std::norm(transform[k]);
    blocks += 1.0;
  }

  Spectrum spectrum;
  for (std::size_t k = 0; k < bins; ++k) {
    const bool own_mirror = k == 0 || 2 * k == block_samples;
    const double sides = own_mirror ? 1.0 : 2.0;
    spectrum.frequency_hz.push_back(static_cast<double>(k) /
                                    (static_cast<double>(block_samples) * time_step_s));
    spectrum.density.push_back(sides * sum[k] * time_step_s / (window_power * blocks));
  }
  return spectrum;
}

Spectrum log_binned(const Spectrum& spectrum, std::size_t bins_per_decade) {
  Spectrum binned;
  double count = 0.0;
  long current = 0;
  for (std::size_t k = 0; k < spectrum.frequency_hz.size(); ++k) {
    const double f_hz = spectrum.frequency_hz[k];
    if (f_hz <= 0.0) continue;
    const auto bin =
        std::lround(std::floor(std::log10(f_hz) * static_cast<double>(bins_per_decade)));
    if (count == 0.0 || bin != current) {
      binned.frequency_hz.push_back(0.0);
      binned.density.push_back(0.0);
      current = bin;
      count = 0.0;
    }
    count += 1.0;
    binned.frequency_hz.back() += (f_hz - binned.frequency_hz.back()) / count;
    binned.density.back() += (spectrum.density[k] - binned.density.back()) / count;
  }
  return binned;
}

}  // namespace lac::sim
