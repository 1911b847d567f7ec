// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/mann_los.hpp"

#include <algorithm>
#include <cmath>

namespace lac {
namespace {

constexpr double kLowestK1L = 1e-3;  // the spectra are level below
constexpr double kLogStep = 0.25;
constexpr int kNodes = 121;
constexpr double kReach = 200.0;
constexpr double kSmallest = 1e-300;  // where a volume leaves nothing

}  // namespace

TabulatedSpectrum::TabulatedSpectrum(double first_k1_radpm, double log_step,
                                     const std::vector<double>& values)
    : first_log_(std::log(first_k1_radpm)), log_step_(log_step) {
  for (const double value : values) logs_.push_back(std::log(std::max(value, kSmallest)));
}

double TabulatedSpectrum::at(double k1_radpm) const {
  const double s = (std::log(k1_radpm) - first_log_) / log_step_;
  if (!(s > 0.0)) return std::exp(logs_.front());
  if (s > static_cast<double>(logs_.size() - 1)) return 0.0;
  const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(s), 1, logs_.size() - 3);
  const double t = s - static_cast<double>(i);
  const double a = -t * (t - 1.0) * (t - 2.0) / 6.0, b = (t * t - 1.0) * (t - 2.0) / 2.0;
  const double c = -t * (t + 1.0) * (t - 2.0) / 2.0, d = t * (t * t - 1.0) / 6.0;
  return std::exp(a * logs_[i - 1] + b * logs_[i] + c * logs_[i + 1] + d * logs_[i + 2]);
}

MannLos::MannLos(const MannParams& params, double volume_std_m, double highest_k1_radpm)
    : volume_std_m_(volume_std_m) {
  const MannTensor tensor(params);
  const double lowest = kLowestK1L / params.length_m;
  const auto steps = static_cast<int>(std::ceil(std::log(highest_k1_radpm / lowest) / kLogStep));
  for (int i = 0; i <= std::max(steps, 3); ++i) {
    Sheet sheet;
    sheet.k1_radpm = lowest * std::exp(i * kLogStep);
    const SinhNodes nodes(sheet.k1_radpm, params.length_m, kNodes, kReach);
    sheet.k3_radpm = nodes.k_radpm;
    for (std::size_t j = kNodes / 2; j < nodes.k_radpm.size(); ++j) {
      const double k2 = nodes.k_radpm[j], share = j == kNodes / 2 ? 0.5 : 1.0;
      sheet.k2_radpm.push_back(k2);
      for (std::size_t m = 0; m < nodes.k_radpm.size(); ++m) {
        SpectralTensor phi = tensor(sheet.k1_radpm, k2, nodes.k_radpm[m]);
        for (double& value : phi) value *= share * nodes.weight_radpm[j] * nodes.weight_radpm[m];
        sheet.weighted.push_back(phi);
      }
    }
    sheets_.push_back(std::move(sheet));
  }
}

double MannLos::los_at(const Sheet& sheet, const Vec3& n) const {
  double sum = 0.0;
  const SpectralTensor* phi = sheet.weighted.data();
  const auto left = [&](double along) {
    const double phase = volume_std_m_ * along;
    return std::exp(-phase * phase);
  };
  for (const double k2 : sheet.k2_radpm) {
    const double across = k2 * n.y;
    for (const double k3 : sheet.k3_radpm) {
      const SpectralTensor& p = *phi++;
      const double along = sheet.k1_radpm * n.x + k3 * n.z;
      const double even =
          n.x * n.x * p[kUu] + n.y * n.y * p[kVv] + n.z * n.z * p[kWw] + 2.0 * n.x * n.z * p[kUw];
      const double odd = 2.0 * n.y * (n.x * p[kUv] + n.z * p[kVw]);
      sum += (even + odd) * left(along + across) + (even - odd) * left(along - across);
    }
  }
  return sum;
}

TabulatedSpectrum MannLos::los(const Vec3& beam_I) const {
  std::vector<double> values;
  for (const Sheet& sheet : sheets_) values.push_back(los_at(sheet, beam_I));
  return {sheets_.front().k1_radpm, kLogStep, values};
}

TabulatedSpectrum MannLos::u() const {
  std::vector<double> values;
  for (const Sheet& sheet : sheets_) {
    double sum = 0.0;
    for (const SpectralTensor& p : sheet.weighted) sum += 2.0 * p[kUu];
    values.push_back(sum);
  }
  return {sheets_.front().k1_radpm, kLogStep, values};
}

}  // namespace lac
