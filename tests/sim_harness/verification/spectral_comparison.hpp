// SPDX-License-Identifier: Apache-2.0
// Spectra and coherence of simulated series against theory, with the limits between which 95 % of
// such means lie. The series repeat after their end, so the frequencies are independent of each
// other, amplitudes complex normal, and the limits known.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "sim_harness/analysis/quantiles.hpp"

namespace lac::sim {

/// Densities of two series and between them, S_ab = E[A B*].
struct PairDensity {
  double aa = 0.0;
  double bb = 0.0;
  std::complex<double> ab;
};

struct ComparedBand {
  double frequency_hz = 0.0;  // mean of the band
  double expected = 0.0;
  double found = 0.0;
  double low = 0.0;  // 95 % of the found ones lie between
  double high = 0.0;

  /// Within so many times the reach of the limits.
  bool inside(double times = 1.0) const {
    return found >= expected - times * (expected - low) &&
           found <= expected + times * (high - expected);
  }
};

/// Collects realisations of a pair of series. Amplitudes are taken over the roots of their expected
/// densities, so that the bins of a band are alike.
class PairComparison {
 public:
  /// theory: [bin]; the one of frequency zero is not used.
  PairComparison(std::vector<PairDensity> theory, double df_hz)
      : theory_(std::move(theory)), df_hz_(df_hz), sums_(theory_.size()) {}

  void add(std::span<const std::complex<double>> a, std::span<const std::complex<double>> b) {
    for (std::size_t k = 1; k < theory_.size(); ++k) {
      const PairDensity& t = theory_[k];
      sums_[k].aa += std::norm(a[k]) / t.aa;
      sums_[k].bb += std::norm(b[k]) / t.bb;
      const std::complex<double> back = std::conj(direction(t.ab));
      sums_[k].ab += back * a[k] * std::conj(b[k]) / std::sqrt(t.aa * t.bb);
    }
    ++realisations_;
  }

  /// Power of a (or b) over the expected one; 1 is expected. The limits are chi-square's.
  std::vector<ComparedBand> power_a() const { return powers(&Means::aa); }
  std::vector<ComparedBand> power_b() const { return powers(&Means::bb); }

  /// Root coherence (its part at the expected phase); limits after Fisher's transformation.
  std::vector<ComparedBand> coherence() const {
    std::vector<ComparedBand> result;
    for (const Band& band : bands()) {
      const Means m = means(band);
      const double reach = kNormal / std::sqrt(2.0 * m.count);
      const double middle = std::atanh(m.coherence);
      result.push_back({m.frequency_hz, m.coherence, m.ab / std::sqrt(m.aa * m.bb),
                        std::tanh(middle - reach), std::tanh(middle + reach)});
    }
    return result;
  }

  /// S_ab / S_bb over the expected one.
  std::vector<ComparedBand> transfer() const {
    std::vector<ComparedBand> result;
    for (const Band& band : bands()) {
      const Means m = means(band);
      const double g2 = m.coherence * m.coherence;
      const double reach = kNormal * std::sqrt((1.0 - g2) / (2.0 * m.count * g2));
      result.push_back(
          {m.frequency_hz, 1.0, m.ab / (m.bb * m.coherence), 1.0 - reach, 1.0 + reach});
    }
    return result;
  }

  /// Variance of a (or b) over the bins, found over expected.
  ComparedBand variance_a() const { return variance(&PairDensity::aa, &Sums::aa); }
  ComparedBand variance_b() const { return variance(&PairDensity::bb, &Sums::bb); }

 private:
  static constexpr double kNormal = 1.959964;
  static constexpr double kBandsPerDecade = 8.0;
  static constexpr double kFewest = 30.0;  // values behind a band

  struct Band {
    std::size_t first, end;
  };
  struct Sums {
    double aa = 0.0, bb = 0.0;
    std::complex<double> ab;
  };
  struct Means {
    double frequency_hz = 0.0, aa = 0.0, bb = 0.0, ab = 0.0, coherence = 0.0, count = 0.0;
  };

  static std::complex<double> direction(std::complex<double> s) {
    return std::abs(s) > 0.0 ? s / std::abs(s) : 1.0;
  }
  double frequency_hz(std::size_t bin) const { return static_cast<double>(bin) * df_hz_; }

  std::vector<Band> bands() const {
    std::vector<Band> all;
    for (std::size_t first = 1; first < theory_.size();) {
      const auto fewest = static_cast<std::size_t>(std::ceil(kFewest / realisations_));
      const auto width = static_cast<std::size_t>(first * std::pow(10.0, 1.0 / kBandsPerDecade));
      const std::size_t end = std::max(width, first + std::max<std::size_t>(fewest, 1));
      if (end > theory_.size()) break;
      all.push_back({first, end});
      first = end;
    }
    return all;
  }

  Means means(const Band& band) const {
    Means m;
    const auto bins = static_cast<double>(band.end - band.first);
    m.count = bins * realisations_;
    for (std::size_t k = band.first; k < band.end; ++k) {
      m.frequency_hz += frequency_hz(k) / bins;
      m.aa += sums_[k].aa / m.count;
      m.bb += sums_[k].bb / m.count;
      m.ab += sums_[k].ab.real() / m.count;
      m.coherence += std::abs(theory_[k].ab) / std::sqrt(theory_[k].aa * theory_[k].bb) / bins;
    }
    return m;
  }

  ComparedBand variance(double PairDensity::*density, double Sums::*sum) const {
    double found = 0.0, expected = 0.0, squares = 0.0;
    for (std::size_t k = 1; k < theory_.size(); ++k) {
      const double s = theory_[k].*density;
      found += sums_[k].*sum / realisations_ * s;
      expected += s;
      squares += s * s;
    }
    const double reach = kNormal * std::sqrt(squares / realisations_) / expected;
    return {frequency_hz(1), 1.0, found / expected, 1.0 - reach, 1.0 + reach};
  }

  std::vector<ComparedBand> powers(double Means::*power) const {
    std::vector<ComparedBand> result;
    for (const Band& band : bands()) {
      const Means m = means(band);
      const double degrees = 2.0 * m.count;
      result.push_back({m.frequency_hz, 1.0, m.*power,
                        chi_square_quantile(0.025, degrees) / degrees,
                        chi_square_quantile(0.975, degrees) / degrees});
    }
    return result;
  }

  std::vector<PairDensity> theory_;
  double df_hz_;
  std::vector<Sums> sums_;
  int realisations_ = 0;
};

/// Where a line through atanh of the root coherence over log f, fitted to the bands whose expected
/// squared coherence is between 0.25 and 0.75, crosses 0.5 squared: found over expected.
inline double half_coherence_ratio(const std::vector<ComparedBand>& bands) {
  double n = 0.0, x = 0.0, xx = 0.0, y[2] = {}, xy[2] = {};
  for (const ComparedBand& b : bands) {
    if (b.expected * b.expected < 0.25 || b.expected * b.expected > 0.75) continue;
    const double weight = std::pow(std::atanh(b.high) - std::atanh(b.low), -2.0);
    const double log_f = std::log(b.frequency_hz);
    n += weight, x += weight * log_f, xx += weight * log_f * log_f;
    for (int i = 0; i < 2; ++i) {
      const double value = std::atanh(i == 0 ? b.found : b.expected);
      y[i] += weight * value, xy[i] += weight * value * log_f;
    }
  }
  double log_crossing[2];
  for (int i = 0; i < 2; ++i) {
    const double slope = (n * xy[i] - x * y[i]) / (n * xx - x * x);
    log_crossing[i] = (std::atanh(std::sqrt(0.5)) - (y[i] - slope * x) / n) / slope;
  }
  return std::exp(log_crossing[0] - log_crossing[1]);
}

}  // namespace lac::sim
