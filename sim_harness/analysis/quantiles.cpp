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
constexpr double kTiny = std::numeric_limits<double>::min() / kPrecision;

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

/// Lentz's way to a continued fraction.
struct Lentz {
  double c = 1.0;
  double d = 0.0;
  double product = 0.0;

  double step(double numerator, double b) {
    d = b + numerator * d;
    c = b + numerator / c;
    if (std::abs(d) < kTiny) d = kTiny;
    if (std::abs(c) < kTiny) c = kTiny;
    d = 1.0 / d;
    product *= c * d;
    return c * d;
  }
};

/// The same from above, by its continued fraction; for x >= a + 1.
double gamma_fraction(double a, double x) {
  double b = x + 1.0 - a, change = 0.0;
  Lentz f{1.0 / kTiny, 1.0 / b, 1.0 / b};
  for (double i = 1.0; std::abs(change - 1.0) > kPrecision && i < 1e6; i += 1.0) {
    b += 2.0;
    change = f.step(-i * (i - a), b);
  }
  return f.product * front_factor(a, x);
}

/// Regularised incomplete beta function for x < (a + 1) / (a + b + 2), by its continued fraction.
double beta_fraction(double x, double a, double b) {
  const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                a * std::log(x) + b * std::log1p(-x)) /
                       a;
  Lentz f;
  f.d = 1.0 / (1.0 - (a + b) * x / (a + 1.0));
  f.product = f.d;
  for (double m = 1.0, change = 0.0; std::abs(change - 1.0) > kPrecision && m < 1e5; m += 1.0) {
    f.step(m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m)), 1.0);
    change = f.step(-(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0)), 1.0);
  }
  return front * f.product;
}

double beta_probability(double x, double a, double b) {
  if (!(x > 0.0)) return 0.0;
  if (x >= 1.0) return 1.0;
  return x < (a + 1.0) / (a + b + 2.0) ? beta_fraction(x, a, b)
                                       : 1.0 - beta_fraction(1.0 - x, b, a);
}

void require_probability(double probability) {
  if (probability > 0.0 && probability < 1.0) return;
  throw Error("quantile: probability " + std::to_string(probability) +
              ", expected above 0 and below 1");
}

void require_degrees(double degrees_of_freedom) {
  if (!(degrees_of_freedom > 0.0)) throw Error("quantile: there are no degrees of freedom");
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
  require_degrees(degrees_of_freedom);
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

double student_probability(double x, double degrees_of_freedom) {
  const double n = degrees_of_freedom;
  const double square = x * x;
  const double beyond =  // of |x|, on one side
      square < n ? 0.5 - 0.5 * beta_probability(square / (n + square), 0.5, 0.5 * n)
                 : 0.5 * beta_probability(n / (n + square), 0.5 * n, 0.5);
  return x < 0.0 ? beyond : 1.0 - beyond;
}

double student_quantile(double probability, double degrees_of_freedom) {
  require_probability(probability);
  require_degrees(degrees_of_freedom);
  if (probability > 0.5) return -student_quantile(1.0 - probability, degrees_of_freedom);
  double low = -1.0;
  while (student_probability(low, degrees_of_freedom) > probability) low *= 2.0;
  return bisect(low, 0.0,
                [&](double x) { return student_probability(x, degrees_of_freedom) < probability; });
}

}  // namespace lac::sim
