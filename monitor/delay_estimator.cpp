// SPDX-License-Identifier: Apache-2.0
#include "monitor/delay_estimator.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lac {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kHalf = 2 * Moddemeijer::kSamples;  // past or future of both signals
constexpr std::size_t kSize = 2 * kHalf;
// White noise of this share on either signal: smooth signals have covariances that are all but
// singular, and rounding would decide.
constexpr double kNoiseFloor = 3e-2;

/// Where the parabola through three values has its extreme, in steps from the middle one.
double vertex(double before, double at, double after) noexcept {
  const double curvature = before - 2.0 * at + after;
  return curvature == 0.0 ? 0.0 : 0.5 * (before - after) / curvature;
}

using Matrix = std::array<std::array<double, kSize>, kSize>;

/// ln det of the leading half and of its Schur complement, by the Cholesky factors; not a number
/// unless positive definite.
struct LogDeterminants {
  double leading, remaining;
};
LogDeterminants factorise(Matrix& a) noexcept {
  std::array<double, 2> product{1.0, 1.0};
  for (std::size_t j = 0; j < kSize; ++j) {
    for (std::size_t k = 0; k < j; ++k) {
      const double factor = a[j][k] * a[k][k];
      for (std::size_t i = j; i < kSize; ++i) a[i][j] -= factor * a[i][k];
    }
    if (!(a[j][j] > 0.0)) return {kNothing, kNothing};
    product[j < kHalf ? 0 : 1] *= a[j][j];
    for (std::size_t i = j + 1; i < kSize; ++i) a[i][j] /= a[j][j];
  }
  return {std::log(product[0]), std::log(product[1])};
}

}  // namespace

DelayEstimate correlation_delay(const LaggedMoments& moments, std::size_t range,
                                double tick_s) noexcept {
  const auto end = static_cast<std::ptrdiff_t>(range);
  std::ptrdiff_t best = -end;
  for (std::ptrdiff_t lag = -end; lag <= end; ++lag) {
    if (moments.cross(lag) > moments.cross(best)) best = lag;
  }
  DelayEstimate e;
  const double scale = std::sqrt(moments.auto_x(0) * moments.auto_y(0));
  e.correlation = scale > 0.0 ? moments.cross(best) / scale : 0.0;
  if (best == -end || best == end) return e;
  e.delay_s =
      tick_s * (static_cast<double>(best) +
                vertex(moments.cross(best - 1), moments.cross(best), moments.cross(best + 1)));
  return e;
}

Moddemeijer::State Moddemeijer::initial_state() const {
  State s;
  s.information.assign(2 * range_ + 1, kNothing);
  return s;
}

/// Order of rows: past of x, past of y, future of x, future of y. Both signals in units of their
/// standard deviation.
double Moddemeijer::information(const LaggedMoments& moments, std::ptrdiff_t lag) const noexcept {
  const double variance_x = moments.auto_x(0), variance_y = moments.auto_y(0);
  if (!(variance_x > 0.0 && variance_y > 0.0)) return kNothing;
  const double per_cross = 1.0 / std::sqrt(variance_x * variance_y);
  const auto spacing = static_cast<std::ptrdiff_t>(spacing_);
  constexpr auto kM = static_cast<std::ptrdiff_t>(kSamples);
  const auto of_y = [](std::size_t row) { return row / kSamples % 2 == 1; };
  const auto time = [](std::size_t row) {  // 0 ... 2m - 1
    const auto r = static_cast<std::ptrdiff_t>(row);
    return r % kM + (r >= static_cast<std::ptrdiff_t>(kHalf) ? kM : 0);
  };
  Matrix c;
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const std::ptrdiff_t apart = (time(i) - time(j)) * spacing;
      if (of_y(i) == of_y(j)) {
        const auto gap = static_cast<std::size_t>(std::abs(apart));
        c[i][j] = of_y(i) ? moments.auto_y(gap) / variance_y : moments.auto_x(gap) / variance_x;
        if (i == j) c[i][j] += kNoiseFloor;
      } else {
        c[i][j] = per_cross * moments.cross(lag + (of_y(i) ? apart : -apart));
      }
    }
  }
  const LogDeterminants ln = factorise(c);
  return 0.5 * (ln.leading - ln.remaining);  // the future has the covariances of the past
}

void Moddemeijer::step(const LaggedMoments& moments, State& s) const noexcept {
  const auto lag = static_cast<std::ptrdiff_t>(s.next) - static_cast<std::ptrdiff_t>(range_);
  s.information[s.next] = information(moments, lag);
  if (++s.next < s.information.size()) return;
  s.next = 0;
  const std::vector<double>& v = s.information;
  std::size_t best = 0;
  for (std::size_t i = 1; i < v.size(); ++i) {
    if (v[i] < v[best] || std::isnan(v[best])) best = i;
  }
  s.delay_s = best == 0 || best + 1 == v.size()
                  ? kNothing
                  : tick_s_ * (static_cast<double>(best) - static_cast<double>(range_) +
                               vertex(v[best - 1], v[best], v[best + 1]));
}

}  // namespace lac
