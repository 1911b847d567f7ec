// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/quantiles.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kPrecision = 1e-15;

/// x^a e^-x / Gamma(a).
double front_factor(double a, double x) {
  return std::exp(a * std::log(x) - x - std::lgamma(a));
}

/// Regularised incomplete gamma function from below, by its series; for x < a + 1.
double gamma_series(double a, double x) {
  double term = 1.0 / a, sum = term;
  for (double n = a + 1.0; std::abs(term) > kPrecision * sum; n += 1.0) {
    term *= x / n;
    sum += term;
  }
  return sum * front_factor(a, x);
}

/// The same from above, by Lentz's continued fraction; for x >= a + 1.
double gamma_fraction(double a, double x) {
  constexpr double kTiny = std::numeric_limits<double>::min() / kPrecision;
  double b = x + 1.0 - a, c = 1.0 / kTiny, d = 1.0 / b, product = d, change = 0.0;
  for (double i = 1.0; std::abs(change - 1.0) > kPrecision && i < 1e6; i += 1.0) {
    const double numerator = -i * (i - a);
    b += 2.0;
    d = numerator * d + b;
    if (std::abs(d) < kTiny) d = kTiny;
    c = b + numerator / c;
    if (std::abs(c) < kTiny) c = kTiny;
    d = 1.0 / d;
    change = d * c;
    product *= change;
  }
  return product * front_factor(a, x);
}

void require_probability(double probability) {
  if (probability > 0.0 && probability < 1.0) return;
  throw Error("quantile: probability " + std::to_string(probability) +
              ", expected above 0 and below 1");
}

/// Halves [low, high] until nothing is between them.
template <class Below>
double bisect(double low, double high, Below&& below) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (below(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double chi_square_probability(double x, double degrees_of_freedom) {
  if (!(x > 0.0)) return 0.0;
  const double a = 0.5 * degrees_of_freedom;
  return 0.5 * x < a + 1.0 ? gamma_series(a, 0.5 * x) : 1.0 - gamma_fraction(a, 0.5 * x);
}

double chi_square_quantile(double probability, double degrees_of_freedom) {
  require_probability(probability);
  if (!(degrees_of_freedom > 0.0)) throw Error("quantile: there are no degrees of freedom");
  double high = degrees_of_freedom + 1.0;
  while (chi_square_probability(high, degrees_of_freedom) < probability) high *= 2.0;
  return bisect(0.0, high, [&](double x) {
    return chi_square_probability(x, degrees_of_freedom) < probability;
  });
}

double normal_quantile(double probability) {
  require_probability(probability);
  return bisect(-40.0, 40.0,
                [&](double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2) < probability; });
}

}  // namespace lac::sim
