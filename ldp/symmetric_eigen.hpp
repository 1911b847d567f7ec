// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace lac {

/// A = V diag(values) V^T of a small symmetric matrix, by cyclic Jacobi rotations (Golub and Van
/// Loan, section 8.5): exact to rounding also for the small eigenvalues that tell whether a
/// problem can be solved. Eigenvectors are the columns of V; values in no order.
template <std::size_t most>
struct SymmetricEigen {
  using Matrix = std::array<std::array<double, most>, most>;
  std::array<double, most> values{};
  Matrix vectors{};

  /// Takes the leading n x n block. Precondition: finite entries, n <= most.
  static SymmetricEigen of(Matrix a, std::size_t n) noexcept {
    SymmetricEigen e;
    for (std::size_t i = 0; i < n; ++i) e.vectors[i][i] = 1.0;
    for (int sweep = 0; sweep < kMostSweeps && off_diagonal(a, n) > 0.0; ++sweep) {
      for (std::size_t p = 0; p + 1 < n; ++p) {
        for (std::size_t q = p + 1; q < n; ++q) rotate(a, e.vectors, p, q, n);
      }
    }
    for (std::size_t i = 0; i < n; ++i) e.values[i] = a[i][i];
    return e;
  }

 private:
  static constexpr int kMostSweeps = 12;        // convergence is quadratic: 6 are enough
  static constexpr double kNegligible = 1e-17;  // of the diagonal

  /// 0 once all are negligible.
  static double off_diagonal(const Matrix& a, std::size_t n) noexcept {
    double sum = 0.0;
    for (std::size_t p = 0; p + 1 < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) sum += std::abs(a[p][q]);
    }
    double diagonal = 0.0;
    for (std::size_t i = 0; i < n; ++i) diagonal = std::max(diagonal, std::abs(a[i][i]));
    return sum > kNegligible * diagonal ? sum : 0.0;
  }

  static void rotate(Matrix& a, Matrix& v, std::size_t p, std::size_t q, std::size_t n) noexcept {
    if (a[p][q] == 0.0) return;
    const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
    const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
    for (std::size_t k = 0; k < n; ++k) turn(a[k][p], a[k][q], c, s);
    for (std::size_t k = 0; k < n; ++k) turn(a[p][k], a[q][k], c, s);
    for (std::size_t k = 0; k < n; ++k) turn(v[k][p], v[k][q], c, s);
    a[p][q] = a[q][p] = 0.0;
  }

  static void turn(double& x, double& y, double c, double s) noexcept {
    const double before = x;
    x = c * before - s * y;
    y = s * before + c * y;
  }
};

}  // namespace lac
