// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/complex_normal.hpp"

#include <gtest/gtest.h>

namespace lac::sim {
namespace {

constexpr int kDraws = 200000;

// Moments of a complex normal: E xi = 0, E|xi|^2 = 1, E xi^2 = 0, E|xi|^4 = 2 (a random phase of
// fixed modulus would have 1). Each within 4.5 standard errors; false alarm below 5e-5.
TEST(ComplexNormal, Moments) {
  ComplexNormal draw(42, 0, 1);
  std::complex<double> mean = 0.0, square = 0.0;
  double power = 0.0, power_squared = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const std::complex<double> xi = draw();
    mean += xi;
    square += xi * xi;
    power += std::norm(xi);
    power_squared += std::norm(xi) * std::norm(xi);
  }
  const double error = 4.5 / std::sqrt(kDraws);
  EXPECT_LT(std::abs(mean) / kDraws, error);
  EXPECT_LT(std::abs(square) / kDraws, error * std::sqrt(2.0));
  EXPECT_NEAR(power / kDraws, 1.0, error);
  EXPECT_NEAR(power_squared / kDraws, 2.0, error * std::sqrt(20.0));
}

// |xi|^2 is exponential: its tail beyond 6 is exp(-6), within 4.5 standard errors.
TEST(ComplexNormal, Tail) {
  ComplexNormal draw(43, 0, 1);
  int beyond = 0;
  for (int i = 0; i < kDraws; ++i) beyond += std::norm(draw()) > 6.0;
  const double expected = kDraws * std::exp(-6.0);
  EXPECT_NEAR(beyond, expected, 4.5 * std::sqrt(expected));
}

double correlation(ComplexNormal a, ComplexNormal b) {
  std::complex<double> sum = 0.0;
  for (int i = 0; i < kDraws; ++i) sum += a() * std::conj(b());
  return std::abs(sum) / kDraws;
}

// Neighbouring seeds, streams and substreams have nothing in common; the same three repeat.
TEST(ComplexNormal, StreamsAreIndependent) {
  const double limit = 4.5 / std::sqrt(kDraws);
  EXPECT_LT(correlation({1, 0, 1}, {2, 0, 1}), limit);
  EXPECT_LT(correlation({1, 0, 1}, {1, 1, 1}), limit);
  EXPECT_LT(correlation({1, 0, 1}, {1, 0, 2}), limit);
  EXPECT_LT(correlation({1, 0, 1}, {1, 1, 0}), limit);
  EXPECT_EQ(ComplexNormal(1, 2, 3)(), ComplexNormal(1, 2, 3)());
}

}  // namespace
}  // namespace lac::sim
