// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/coherence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "sim_harness/analysis/quantiles.hpp"

namespace lac::sim {
namespace {

void require_finite(std::span<const double> series) {
  const auto bad = std::ranges::find_if_not(series, [](double v) { return std::isfinite(v); });
  if (bad != series.end()) {
    throw Error("coherence: sample " + std::to_string(bad - series.begin()) +
                " is not a finite number");
  }
}

}  // namespace

CrossSpectrumEstimator::CrossSpectrumEstimator(double time_step_s, std::size_t block_samples)
    : time_step_s_(time_step_s), block_samples_(block_samples) {
  if (block_samples < kLeastBlock) {
    throw Error("coherence: a block of " + std::to_string(block_samples) +
                " samples is too short, expected at least " + std::to_string(kLeastBlock));
  }
  const BlockTransform smallest(block_samples, time_step_s, block_samples, Taper::kHamming);
  sum_x_.assign(smallest.bins(), 0.0);
  sum_y_.assign(smallest.bins(), 0.0);
  sum_cross_.assign(smallest.bins(), 0.0);
}

bool CrossSpectrumEstimator::add(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) {
    throw Error("coherence: series of " + std::to_string(x.size()) + " and " +
                std::to_string(y.size()) + " samples, expected equal lengths");
  }
  require_finite(x);
  require_finite(y);
  if (x.size() < block_samples_) return false;
  const BlockTransform transform(x.size(), time_step_s_, block_samples_, Taper::kHamming);
  const auto of_x = transform(x), of_y = transform(y);
  for (std::size_t i = 0; i < of_x.size(); ++i) {
    const std::size_t bin = i % sum_x_.size();
    sum_x_[bin] += std::norm(of_x[i]);
    sum_y_[bin] += std::norm(of_y[i]);
    sum_cross_[bin] += std::conj(of_x[i]) * of_y[i];
  }
  const auto blocks = static_cast<double>(transform.blocks());
  const std::size_t middle = transform.bins() / 2;
  squared_variance_sum_ += blocks * blocks * transform.variance_of_mean(middle, middle + 1);
  blocks_ += transform.blocks();
  return true;
}

CrossSpectrum CrossSpectrumEstimator::result() const {
  if (blocks_ == 0) {
    throw Error("coherence: no stretch is as long as a block of " + std::to_string(block_samples_) +
                " samples");
  }
  const BlockTransform transform(block_samples_, time_step_s_, block_samples_, Taper::kHamming);
  const auto blocks = static_cast<double>(blocks_);
  CrossSpectrum s;
  s.independent_blocks = blocks * blocks / squared_variance_sum_;
  for (std::size_t k = transform.first_bin(); k < transform.end_bin(); ++k) {
    s.frequency_hz.push_back(transform.frequency_hz(k));
    s.density_x.push_back(sum_x_[k] / blocks);
    s.density_y.push_back(sum_y_[k] / blocks);
    s.cross.push_back(sum_cross_[k] / blocks);
    const double both = sum_x_[k] * sum_y_[k];
    s.coherence.push_back(both > 0.0 ? std::norm(sum_cross_[k]) / both : 0.0);
  }
  return s;
}

Band density_band(std::span<const double> density, double independent_blocks, double confidence) {
  const double degrees = 2.0 * independent_blocks;
  const double beside = 0.5 * (1.0 - confidence);
  const double low = degrees / chi_square_quantile(1.0 - beside, degrees);
  const double high = degrees / chi_square_quantile(beside, degrees);
  Band band;
  for (const double s : density) {
    band.low.push_back(low * s);
    band.high.push_back(high * s);
  }
  return band;
}

Band coherence_band(std::span<const double> coherence, double independent_blocks,
                    double confidence) {
  if (!(independent_blocks > 1.0)) {
    throw Error("coherence: a band needs more than one independent block, found " +
                std::to_string(independent_blocks));
  }
  const double variance = 0.5 / (independent_blocks - 1.0);
  const double half = normal_quantile(0.5 * (1.0 + confidence)) * std::sqrt(variance);
  const auto squared = [](double z) {
    const double root = std::tanh(std::max(z, 0.0));
    return root * root;
  };
  Band band;
  for (const double c : coherence) {
    const double z = std::atanh(std::sqrt(c)) - variance;
    band.low.push_back(squared(z - half));
    band.high.push_back(squared(z + half));
  }
  return band;
}

double coherence_by_chance(double independent_blocks, double confidence) {
  return 1.0 - std::pow(1.0 - confidence, 1.0 / (independent_blocks - 1.0));
}

double first_fall_hz(std::span<const double> frequency_hz, std::span<const double> values,
                     double level) {
  for (std::size_t i = 1; i < values.size() && values[i - 1] >= level; ++i) {
    if (values[i] >= level) continue;
    const double part = (values[i - 1] - level) / (values[i - 1] - values[i]);
    return frequency_hz[i - 1] + part * (frequency_hz[i] - frequency_hz[i - 1]);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace lac::sim
