// SPDX-License-Identifier: Apache-2.0
// Numbers of independent origin: hypergeometric function with mpmath (30 digits), closed forms of
// the isotropic case, the tables of GUO.
#include "core/mann_tensor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kPi = 3.14159265358979323846;

MannParams guo(double alpha_epsilon, double length_m, double gamma, double low_slope = -1.0) {
  MannParams p;
  p.alpha_epsilon = alpha_epsilon;
  p.length_m = length_m;
  p.gamma = gamma;
  p.low_slope = low_slope;
  return p;
}

MannParams mann(double length_m, double gamma) {
  MannParams p = guo(1.0, length_m, gamma);
  p.lifetime = EddyLifetime::kMann;
  return p;
}

// beta / Gamma of Mann's lifetime from seven decades of kL, both branches of 2F1 and their seam.
TEST(MannTensor, LifetimeAgainstMpmath) {
  const MannTensor tensor(mann(30.0, 1.0));
  const double found[][2] = {
      {1e-4, 12053.05816882576},  {0.01, 120.5305816894247},   {0.3, 4.018480258995882},
      {0.999, 1.235578663954647}, {1.0, 1.234430999866},       {1.001, 1.233285750138486},
      {3.0, 0.4985661210529549},  {50.0, 0.07369106570791359}, {1e4, 0.002154434697662173}};
  for (const auto& [kl, beta] : found) EXPECT_NEAR(tensor.closed_beta(kl) / beta, 1.0, 1e-12) << kl;
}

// The GUO form: its value at kL = 1 (Gamma a 2^((b2 - b1)/10)), and slopes b1 below, b2 above.
TEST(MannTensor, GuoLifetime) {
  const MannTensor tensor(guo(1.0, 30.0, 2.0, -0.8));
  EXPECT_NEAR(tensor.closed_beta(1.0), 2.0 * 1.234430999866 * std::pow(2.0, 0.4 / 30.0), 1e-12);
  EXPECT_NEAR(std::log10(tensor.closed_beta(1e-4) / tensor.closed_beta(1e-3)), 0.8, 1e-12);
  EXPECT_NEAR(std::log10(tensor.closed_beta(1e3) / tensor.closed_beta(1e4)), 2.0 / 3.0, 1e-12);
}

// The table of beta, its ends included: as its header says.
TEST(MannTensor, TableOfBeta) {
  for (const MannParams& p : {mann(30.0, 3.9), guo(1.0, 30.0, 2.4, -0.8)}) {
    const MannTensor tensor(p);
    for (double log_kl = -20.0; log_kl < 20.0; log_kl += 0.0037) {
      const double kl = std::exp(log_kl);
      ASSERT_NEAR(tensor.beta(kl) / tensor.closed_beta(kl), 1.0, 2e-7) << kl;
    }
  }
}

Eigen::Matrix3d matrix(const SpectralTensor& t) {
  return Eigen::Matrix3d{
      {t[kUu], t[kUv], t[kUw]}, {t[kUv], t[kVv], t[kVw]}, {t[kUw], t[kVw], t[kWw]}};
}

// At 2000 random wave vectors over six decades: positive semidefinite, no divergence (k Phi = 0, so
// that one eigenvalue vanishes), the same at -k; uv and vw change sign with k2, the others do not.
TEST(MannTensor, SymmetriesAndIncompressibility) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-4.0, 2.0), sign(-1.0, 1.0);
  const auto draw = [&] { return std::copysign(std::pow(10.0, exponent(random)), sign(random)); };
  for (const MannParams& p : {mann(30.0, 3.9), guo(1.0, 30.0, 2.4, -0.8)}) {
    const MannTensor phi(p);
    for (int i = 0; i < 1000; ++i) {
      const double k1 = draw(), k2 = draw(), k3 = draw();
      const SpectralTensor t = phi(k1, k2, k3), mirrored = phi(k1, -k2, k3);
      const Eigen::Matrix3d m = matrix(t);
      const double size = m.trace();
      const Eigen::Vector3d k(k1, k2, k3);
      EXPECT_LT((m * k).norm(), 1e-9 * size * k.norm());
      const Eigen::Vector3d eigen = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvalues();
      EXPECT_GT(eigen[0], -1e-9 * size);
      EXPECT_LT((matrix(phi(-k1, -k2, -k3)) - m).norm(), 1e-12 * size);
      for (int c = 0; c < kTensorSize; ++c) {
        const double parity = c == kUv || c == kVw ? -1.0 : 1.0;
        EXPECT_NEAR(mirrored[c], parity * t[c], 1e-12 * size);
      }
    }
  }
}

// Gamma = 0 is von Karman's isotropic turbulence: one-point spectra, cross terms and variance have
// closed forms, from k1 L = 3e-4 to 3e3.
TEST(MannTensor, IsotropicClosedForms) {
  const double length = 30.0, alpha = 0.4;
  const MannTensor phi(guo(alpha, length, 0.0));
  for (const double k1 : {1e-5, 1e-3, 0.01, 0.1, 1.0, 100.0}) {
    const SpectralTensor f = phi.spectra(k1);
    const double q = 1.0 / (length * length) + k1 * k1;
    const double uu = 9.0 / 55.0 * alpha * std::pow(q, -5.0 / 6.0);
    const double vv =
        3.0 / 110.0 * alpha * (3.0 / (length * length) + 8.0 * k1 * k1) * std::pow(q, -11.0 / 6.0);
    EXPECT_NEAR(f[kUu] / uu, 1.0, 1e-4) << k1;
    EXPECT_NEAR(f[kVv] / vv, 1.0, 1e-4) << k1;
    EXPECT_NEAR(f[kWw] / vv, 1.0, 1e-4) << k1;
    EXPECT_NEAR(f[kUw] / uu, 0.0, 1e-9) << k1;
  }
  const double variance = 9.0 / 55.0 * alpha * std::pow(length, 2.0 / 3.0) * std::sqrt(kPi) *
                          std::tgamma(1.0 / 3.0) / std::tgamma(5.0 / 6.0);
  const SpectralTensor sigma = phi.covariance();
  for (const int c : {kUu, kVv, kWw}) EXPECT_NEAR(sigma[c] / variance, 1.0, 2e-4) << c;
}

// Isotropic root coherence of u across the wind, closed form (von Karman): with
// x = r sqrt(1/L^2 + k1^2), 2/Gamma(5/6) [(x/2)^(5/6) K_5/6(x) - (x/2)^(11/6) K_1/6(x)], at every
// angle, without phase.
TEST(MannTensor, IsotropicCoherence) {
  const double length = 30.0;
  const MannTensor phi(guo(1.0, length, 0.0));
  for (const double k1 : {1e-3, 0.02, 0.1}) {
    const double r = 25.0, x = r * std::hypot(1.0 / length, k1);
    const double coherence = 2.0 / std::tgamma(5.0 / 6.0) *
                             (std::pow(0.5 * x, 5.0 / 6.0) * std::cyl_bessel_k(5.0 / 6.0, x) -
                              std::pow(0.5 * x, 11.0 / 6.0) * std::cyl_bessel_k(1.0 / 6.0, x));
    const double uu = phi.spectra(k1)[kUu];
    for (const double angle : {0.0, 0.5 * kPi, 0.7}) {
      const CrossSpectra f =
          phi.cross_spectra(k1, {r * std::cos(angle), r * std::sin(angle), 0.0}, 601);
      EXPECT_NEAR(f[kUu].real() / uu, coherence, 1e-4) << k1 << ' ' << angle;
      EXPECT_NEAR(f[kUu].imag() / uu, 0.0, 1e-9) << k1 << ' ' << angle;
    }
  }
}

// The quadrature has converged as its header says: 301 nodes against 801 28 m and 150 m apart, 101
// at one point.
TEST(MannTensor, QuadratureConverges) {
  for (const MannParams& p : {guo(0.184, 140.0, 2.6), guo(0.652, 30.0, 2.4, -0.8)}) {
    const MannTensor phi(p);
    for (const double k1 : {2e-4, 0.05}) {
      const SpectralTensor f = phi.spectra(k1, 801);
      for (const auto& [separation, tolerance] : {std::pair<Separation, double>{{}, 1e-5},
                                                  {{20.0, 20.0}, 1e-4},
                                                  {{90.0, 120.0}, 1.5e-3}}) {
        const bool one_point = separation.dy_m == 0.0;
        const CrossSpectra a = phi.cross_spectra(k1, separation, one_point ? 101 : 301);
        const CrossSpectra b = phi.cross_spectra(k1, separation, 801);
        for (const int c : {kUu, kVv, kWw})
          EXPECT_LT(std::abs(a[c] - b[c]), tolerance * f[c]) << k1 << ' ' << c;
      }
    }
  }
}

// Longitudinal coherence of u (squared) at 100 m, 16 m/s against the exponential fits of GUO Table
// 2, exp(-a_x dx sqrt((f/U)^2 + b_x^2)), below 0.01 rad/m where the fits are good: within 0.04.
TEST(MannTensor, GuoTable2) {
  const struct {
    MannParams params;
    double evolution_s, ax, bx;
  } rows[] = {{guo(0.184, 140.0, 2.6), 600.0, 4.1, 7.67e-5},
              {guo(0.311, 49.0, 3.1), 400.0, 1.8, 1.49e-4},
              {guo(0.652, 30.0, 2.4, -0.8), 200.0, 1.6, 9.18e-4}};
  for (const auto& row : rows) {
    MannParams p = row.params;
    p.evolution_s = row.evolution_s;
    const MannTensor phi(p);
    for (const double k1 : {3e-4, 1e-3, 3e-3, 0.01}) {
      const double uu = phi.spectra(k1)[kUu];
      const double found = std::norm(phi.cross_spectra(k1, {0.0, 0.0, 100.0 / 16.0})[kUu] / uu);
      const double fit = std::exp(-row.ax * 100.0 * std::hypot(k1 / (2.0 * kPi), row.bx));
      EXPECT_NEAR(found, fit, 0.04) << p.length_m << ' ' << k1;
    }
  }
}

// IEC 61400-1: with Mann's lifetime and Gamma = 3.9 sigma_u is sigma_iso / 0.55, sigma_v about 0.7
// and sigma_w about 0.5 of it; u and w are negatively correlated, v with neither.
TEST(MannTensor, IecRatios) {
  const SpectralTensor sheared = MannTensor(mann(33.6, 3.9)).covariance();
  const SpectralTensor isotropic = MannTensor(mann(33.6, 0.0)).covariance();
  EXPECT_NEAR(std::sqrt(isotropic[kUu] / sheared[kUu]), 0.55, 0.01);
  EXPECT_NEAR(std::sqrt(sheared[kVv] / sheared[kUu]), 0.7, 0.02);
  EXPECT_NEAR(std::sqrt(sheared[kWw] / sheared[kUu]), 0.5, 0.03);
  EXPECT_NEAR(sheared[kUw] / sheared[kUu], -0.24, 0.01);
  EXPECT_NEAR(sheared[kUv] / sheared[kUu], 0.0, 1e-12);
  EXPECT_NEAR(sheared[kVw] / sheared[kUu], 0.0, 1e-12);
}

// The three sets of GUO Table 1 belong to sigma_u = 2.82 m/s: within 3 %.
TEST(MannTensor, GuoTable1) {
  for (const MannParams& p :
       {guo(0.184, 140.0, 2.6), guo(0.311, 49.0, 3.1), guo(0.652, 30.0, 2.4, -0.8)})
    EXPECT_NEAR(std::sqrt(MannTensor(p).covariance()[kUu]) / 2.82, 1.0, 0.03) << p.length_m;
}

// Scaling to a standard deviation changes alpha_epsilon alone.
TEST(MannTensor, ScaledToSigma) {
  const MannParams p = scaled_to_sigma_u(guo(0.311, 49.0, 3.1), 2.0);
  EXPECT_NEAR(std::sqrt(MannTensor(p).covariance()[kUu]), 2.0, 1e-9);
  EXPECT_EQ(p.length_m, 49.0);
  EXPECT_EQ(p.gamma, 3.1);
}

// Shear tilts eddies down-wind: u 20 m above is ahead in x. A pattern displaced by +x has the phase
// -k1 x, so the cross-spectrum from the lower to the upper point has a negative one.
TEST(MannTensor, EddiesLeanDownWind) {
  const MannTensor phi(guo(0.311, 49.0, 3.1));
  EXPECT_LT(phi.cross_spectra(0.02, {0.0, 20.0, 0.0})[kUu].imag(), 0.0);
}

void expect_refused(const MannParams& params, const char* text) {
  try {
    const MannTensor tensor(params);
    FAIL() << text << " was accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(text));
  }
}

// What is no turbulence is refused by name.
TEST(MannTensor, RefusesBadParameters) {
  expect_refused(guo(0.0, 49.0, 3.1), "alpha_epsilon = 0");
  expect_refused(guo(0.3, -1.0, 3.1), "length_m = -1");
  expect_refused(guo(0.3, 49.0, -0.1), "gamma = -0.1");
  expect_refused(guo(0.3, 49.0, std::nan("")), "gamma = nan");
  expect_refused(guo(0.3, 49.0, 3.1, -0.5), "low_slope = -0.5");
  MannParams p;
  p.evolution_s = 0.0;
  expect_refused(p, "evolution_s = 0");
}

}  // namespace
}  // namespace lac::sim
