// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/block_transform.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <unsupported/Eigen/FFT>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr int kCorrelatedBins = 4;  // further apart the Hamming window leaves below 1e-4
constexpr int kKernelBins = 6;
constexpr int kKernelSteps = 4;  // per bin

void require_usable(std::size_t samples, std::size_t block_samples) {
  if (block_samples >= 4 && samples >= block_samples) return;
  throw Error("spectrum: block of " + std::to_string(block_samples) + " samples for a series of " +
              std::to_string(samples) + ", expected at least 4 and no more than the series has");
}

std::vector<double> window_of(std::size_t size, Taper taper) {
  std::vector<double> window(size, 1.0);
  if (taper == Taper::kNone) return window;
  for (std::size_t i = 0; i < size; ++i) {
    const double phase_rad = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(size);
    window[i] = 0.54 - 0.46 * std::cos(phase_rad);
  }
  return window;
}

void remove_trend(std::vector<double>& block) {
  const auto count = static_cast<double>(block.size());
  const double middle = 0.5 * (count - 1.0);
  double mean = 0.0;
  for (const double x : block) mean += x / count;
  double slope = 0.0;
  for (std::size_t i = 0; i < block.size(); ++i)
    slope += (static_cast<double>(i) - middle) * (block[i] - mean);
  slope *= 12.0 / (count * (count * count - 1.0));
  for (std::size_t i = 0; i < block.size(); ++i)
    block[i] -= mean + slope * (static_cast<double>(i) - middle);
}

/// |sum of weights e^(-i 2 pi cycles n / N)|^2.
double power_at(std::span<const double> weights, double cycles, std::size_t size) {
  std::complex<double> sum;
  for (std::size_t n = 0; n < weights.size(); ++n) {
    const double phase_rad =
        2.0 * kPi * cycles * static_cast<double>(n) / static_cast<double>(size);
    sum += weights[n] * std::polar(1.0, -phase_rad);
  }
  return std::norm(sum);
}

}  // namespace

BlockTransform::BlockTransform(std::size_t samples, double time_step_s, std::size_t block_samples,
                               Taper taper)
    : block_samples_(taper == Taper::kNone ? samples : block_samples),
      time_step_s_(time_step_s),
      taper_(taper) {
  require_usable(samples, block_samples_);
  blocks_ = 1 + (samples - block_samples_) / (block_samples_ / 2);
  df_hz_ = 1.0 / (static_cast<double>(block_samples_) * time_step_s_);
  prepare_window();
}

void BlockTransform::prepare_window() {
  window_ = window_of(block_samples_, taper_);
  double power = 0.0;
  for (const double w : window_) power += w * w;
  scale_ = std::sqrt(time_step_s_ / power);
  if (taper_ == Taper::kNone) {
    correlation_[0] = {1.0};
    correlation_[1] = {0.0};
    return;
  }
  for (std::size_t neighbour : {0, 1}) {
    const std::size_t shift = neighbour * (block_samples_ / 2);
    std::vector<double> product(block_samples_ - shift);
    for (std::size_t n = 0; n < product.size(); ++n) product[n] = window_[n] * window_[n + shift];
    for (int k = 0; k <= kCorrelatedBins; ++k)
      correlation_[neighbour].push_back(power_at(product, k, block_samples_) / (power * power));
  }
  double sum = 0.0;
  for (int j = -kKernelBins * kKernelSteps; j <= kKernelBins * kKernelSteps; ++j) {
    kernel_.push_back(power_at(window_, static_cast<double>(j) / kKernelSteps, block_samples_));
    sum += kernel_.back();
  }
  for (double& share : kernel_) share /= sum;
}

std::vector<std::complex<double>> BlockTransform::operator()(std::span<const double> series) const {
  std::vector<std::complex<double>> all, transform;
  all.reserve(blocks_ * bins());
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  for (std::size_t b = 0; b < blocks_; ++b) {
    const auto part = series.subspan(b * (block_samples_ / 2), block_samples_);
    std::vector<double> block(part.begin(), part.end());
    if (taper_ != Taper::kNone) remove_trend(block);
    for (std::size_t i = 0; i < block.size(); ++i) block[i] *= window_[i];
    fft.fwd(transform, block);
    for (std::size_t k = 0; k < bins(); ++k) {
      const bool own_mirror = k == 0 || 2 * k == block_samples_;
      all.push_back((own_mirror ? 1.0 : std::sqrt(2.0)) * scale_ * transform[k]);
    }
  }
  return all;
}

double BlockTransform::expected(std::size_t bin,
                                const std::function<double(double)>& density_of_hz) const {
  const double f_hz = frequency_hz(bin);
  if (taper_ == Taper::kNone) {
    const double half_hz = 0.5 * df_hz_;
    return (density_of_hz(f_hz - half_hz) + 4.0 * density_of_hz(f_hz) +
            density_of_hz(f_hz + half_hz)) /
           6.0;
  }
  double sum = 0.0;
  for (std::size_t j = 0; j < kernel_.size(); ++j) {
    const double bins_away = static_cast<double>(j) / kKernelSteps - kKernelBins;
    const double away_hz = std::abs(f_hz + bins_away * df_hz_);
    sum += kernel_[j] * density_of_hz(std::max(away_hz, 0.125 * df_hz_));
  }
  return sum;
}

double BlockTransform::variance_of_mean(std::size_t first, std::size_t end) const {
  const std::size_t count = end - first;
  return variance_of_sum(std::vector<double>(count, 1.0 / static_cast<double>(count)));
}

double BlockTransform::variance_of_sum(std::span<const double> weights) const {
  const auto blocks = static_cast<double>(blocks_);
  double sum = 0.0;
  for (std::size_t apart = 0; apart < correlation_[0].size() && apart < weights.size(); ++apart) {
    double pairs = 0.0;
    for (std::size_t k = apart; k < weights.size(); ++k) pairs += weights[k] * weights[k - apart];
    const double correlation =
        correlation_[0][apart] + 2.0 * (blocks - 1.0) / blocks * correlation_[1][apart];
    sum += (apart == 0 ? 1.0 : 2.0) * pairs * correlation / blocks;
  }
  return sum;
}

}  // namespace lac::sim
