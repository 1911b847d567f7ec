// SPDX-License-Identifier: Apache-2.0
#include "core/mann_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac {
namespace {

void require(bool ok, std::string_view name, double found, std::string_view expected) {
  if (ok) return;
  std::ostringstream text;
  text.precision(9);
  text << "Mann tensor: " << name << " = " << found << ", expected " << expected;
  throw Error(text.str());
}

void require_positive(std::string_view name, double found) {
  require(std::isfinite(found) && found > 0.0, name, found, "a finite number above 0");
}

// Table of log beta: beyond its ends beta is a power law (to 1e-7).
constexpr double kFirstLog = -12.0;  // kL = 6e-6
constexpr double kLastLog = 12.0;
constexpr double kLogStep = 0.02;

/// 2F1(a, 1; c; x) for 0 <= x <= 1/2: the series, 60 terms leave less than 1e-17.
double series(double a, double c, double x) {
  double term = 1.0, sum = 1.0;
  for (int n = 0; n < 60; ++n) {
    term *= (a + n) / (c + n) * x;
    sum += term;
  }
  return sum;
}

/// 2F1(1/3, 17/6; 4/3; -1/q), q = (kL)^2: Pfaff's transformation for q >= 1, the connection
/// formula in 1/z below, its second part by Pfaff again.
double lifetime_2f1(double q) {
  const double x = 1.0 / (1.0 + q);
  if (q >= 1.0) return std::pow(1.0 - x, 17.0 / 6.0) * series(17.0 / 6.0, 4.0 / 3.0, x);
  static const double kLimit = std::tgamma(4.0 / 3.0) * std::tgamma(2.5) / std::tgamma(17.0 / 6.0);
  return kLimit * std::cbrt(q) -
         2.0 / 15.0 * std::pow(q * x, 17.0 / 6.0) * series(17.0 / 6.0, 3.5, q * x);
}

double guo_factor() {
  static const double kFactor = 1.0 / std::sqrt(lifetime_2f1(1.0));
  return kFactor;
}

void check(const MannParams& p) {
  require_positive("alpha_epsilon", p.alpha_epsilon);
  require_positive("length_m", p.length_m);
  require(std::isfinite(p.gamma) && p.gamma >= 0.0, "gamma", p.gamma, "0 or a finite number above");
  require(p.high_slope <= 0.0, "high_slope", p.high_slope, "0 or below");
  require(std::isfinite(p.low_slope) && p.low_slope <= p.high_slope, "low_slope", p.low_slope,
          "a finite number, high_slope or below");
  require(p.evolution_s > 0.0, "evolution_s", p.evolution_s, "above 0, or infinity");
}

/// Cubic through the four nodes about position s (in steps from v[0]), 1 <= s <= size - 2.
double cubic(const std::vector<double>& v, double s) {
  const auto i = std::min(static_cast<std::size_t>(s), v.size() - 3);
  const double t = s - static_cast<double>(i);
  const double a = -t * (t - 1.0) * (t - 2.0) / 6.0, b = (t * t - 1.0) * (t - 2.0) / 2.0;
  const double c = -t * (t + 1.0) * (t - 2.0) / 2.0, d = t * (t * t - 1.0) / 6.0;
  return a * v[i - 1] + b * v[i] + c * v[i + 1] + d * v[i + 2];
}

}  // namespace

SinhNodes::SinhNodes(double k1_radpm, double length_m, int nodes, double reach) {
  require(nodes >= 3 && nodes % 2 == 1, "quadrature nodes", nodes, "an odd number from 3");
  const double k1 = std::abs(k1_radpm), scale = 0.3 * k1;
  require_positive("k1 [rad/m]", k1);
  const double end = std::asinh(reach * (1.0 / length_m + k1) / scale);
  const double step = 2.0 * end / (nodes - 1);
  for (int i = 0; i < nodes; ++i) {
    const double t = (i - nodes / 2) * step;
    k_radpm.push_back(scale * std::sinh(t));
    weight_radpm.push_back(scale * std::cosh(t) * step);
  }
}

MannTensor::MannTensor(const MannParams& params) : params_(params) {
  check(params_);
  if (params_.gamma == 0.0) return;
  const int nodes = static_cast<int>(std::lround((kLastLog - kFirstLog) / kLogStep)) + 1;
  for (int i = 0; i < nodes; ++i)
    log_beta_.push_back(std::log(closed_beta(std::exp(kFirstLog + i * kLogStep))));
}

double MannTensor::closed_beta(double kl) const {
  if (params_.lifetime == EddyLifetime::kMann)
    return params_.gamma / (std::cbrt(kl * kl) * std::sqrt(lifetime_2f1(kl * kl)));
  const double bend = std::pow(1.0 + std::pow(kl, 10.0), 0.1);
  return params_.gamma * guo_factor() * std::pow(kl, params_.low_slope) *
         std::pow(bend, params_.high_slope - params_.low_slope);
}

double MannTensor::log_beta_in_table(double log_kl) const {
  const std::size_t last = log_beta_.size() - 1;
  const double s = (log_kl - kFirstLog) / kLogStep, end = static_cast<double>(last);
  if (s < 1.0) return log_beta_[1] + (s - 1.0) * (log_beta_[1] - log_beta_[0]);
  if (s > end - 1.0)
    return log_beta_[last - 1] + (s - end + 1.0) * (log_beta_[last] - log_beta_[last - 1]);
  return cubic(log_beta_, s);
}

double MannTensor::beta(double kl) const {
  return params_.gamma == 0.0 ? 0.0 : std::exp(log_beta_in_table(std::log(kl)));
}

double MannTensor::evolution_time_s(double k_radpm) const {
  const double kl = k_radpm * params_.length_m;
  const double bend = std::pow(1.0 + std::pow(kl, 10.0), -2.0 / 15.0);
  return params_.evolution_s * guo_factor() * bend / kl;
}

SpectralTensor MannTensor::operator()(double k1, double k2, double k3) const {
  const double length = params_.length_m;
  const double kh_sq = k1 * k1 + k2 * k2, kh = std::sqrt(kh_sq), k_sq = kh_sq + k3 * k3;
  const double b = beta(std::sqrt(k_sq) * length);
  const double k30 = k3 + b * k1, k0_sq = kh_sq + k30 * k30;

  const double q = k0_sq * length * length, q1 = 1.0 + q;
  const double energy = params_.alpha_epsilon * std::cbrt(length * length) * length * q * q *
                        std::sqrt(std::cbrt(q1)) / (q1 * q1 * q1);  // E(k0)
  const double c1 = b * k1 * k1 * (k0_sq - 2.0 * k30 * k30 + b * k1 * k30) / (k_sq * kh_sq);
  const double c2 = k2 * k0_sq / (kh_sq * kh) * std::atan2(b * k1 * kh, k0_sq - k30 * k1 * b);
  const double z1 = c1 - k2 / k1 * c2, z2 = k2 / k1 * c1 + c2;

  const double e = energy / (4.0 * kPi);
  const double e00 = e / (k0_sq * k0_sq), e0 = e / (k_sq * k0_sq), e3 = e / (k_sq * k_sq);
  return {e00 * (k0_sq - k1 * k1 - 2.0 * k1 * k30 * z1 + kh_sq * z1 * z1),
          e00 * (k0_sq - k2 * k2 - 2.0 * k2 * k30 * z2 + kh_sq * z2 * z2),
          e3 * kh_sq,
          e00 * (-k1 * k2 - k1 * k30 * z2 - k2 * k30 * z1 + kh_sq * z1 * z2),
          e0 * (-k1 * k30 + kh_sq * z1),
          e0 * (-k2 * k30 + kh_sq * z2)};
}

CrossSpectra MannTensor::cross_spectra(double k1_radpm, const Separation& separation,
                                       int nodes) const {
  const SinhNodes n(k1_radpm, params_.length_m, nodes);
  const auto middle = static_cast<std::size_t>(nodes / 2);
  CrossSpectra sum{};
  for (std::size_t i = middle; i < n.k_radpm.size(); ++i) {
    const double k2 = n.k_radpm[i], both = i == middle ? 1.0 : 2.0;
    const double even = both * std::cos(k2 * separation.dy_m);
    const std::complex<double> odd(0.0, both * std::sin(k2 * separation.dy_m));
    for (std::size_t j = 0; j < n.k_radpm.size(); ++j) {
      const double k3 = n.k_radpm[j];
      double weight = n.weight_radpm[i] * n.weight_radpm[j];
      if (separation.dt_s != 0.0)
        weight *=
            std::exp(-std::abs(separation.dt_s) / evolution_time_s(std::hypot(k1_radpm, k2, k3)));
      const auto phase = std::polar(weight, k3 * separation.dz_m);
      const SpectralTensor phi = (*this)(k1_radpm, k2, k3);
      for (int c = 0; c < kTensorSize; ++c)
        sum[c] += phi[c] * phase * (c == kUv || c == kVw ? odd : even);
    }
  }
  return sum;
}

SpectralTensor MannTensor::spectra(double k1_radpm, int nodes) const {
  const CrossSpectra cross = cross_spectra(k1_radpm, {}, nodes);
  SpectralTensor spectra;
  std::ranges::transform(cross, spectra.begin(), [](auto f) { return f.real(); });
  return spectra;
}

SpectralTensor MannTensor::covariance() const {
  constexpr double kFirst = 1e-4, kLast = 3e3;  // k1 L; F is constant below, k1^(-5/3) above
  constexpr int kSteps = 40;
  const double step = std::log(kLast / kFirst) / kSteps;
  SpectralTensor sum{};
  for (int i = 0; i <= kSteps; ++i) {
    const double k1 = kFirst * std::exp(i * step) / params_.length_m;
    const double weight = i == 0 ? 0.5 * step + 1.0 : i == kSteps ? 0.5 * step + 1.5 : step;
    const SpectralTensor f = spectra(k1, 71);
    for (int c = 0; c < kTensorSize; ++c) sum[c] += 2.0 * weight * k1 * f[c];
  }
  return sum;
}

MannParams scaled_to_sigma_u(MannParams params, double sigma_u_mps) {
  require_positive("sigma_u [m/s]", sigma_u_mps);
  const double variance = MannTensor(params).covariance()[kUu];
  params.alpha_epsilon *= sigma_u_mps * sigma_u_mps / variance;
  return params;
}

}  // namespace lac
