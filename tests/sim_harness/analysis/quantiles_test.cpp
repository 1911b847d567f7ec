// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/quantiles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

// scipy.stats.chi2.ppf, from half a degree of freedom to a hundred thousand, deep in both tails.
TEST(Quantiles, ChiSquareAgreesWithScipy) {
  struct {
    double probability, degrees, value;
  } const kCases[] = {{0.025, 2.0, 0.05063561596857975}, {0.975, 2.0, 7.377758908227871},
                      {0.025, 7.3, 1.833244287117484},   {0.975, 7.3, 16.473245004110147},
                      {1e-5, 40.0, 12.566736882426502},  {0.99999, 40.0, 90.07909063405718},
                      {0.5, 1e5, 99999.33333412347},     {0.9999, 1e5, 101671.75506958258},
                      {0.05, 0.5, 8.437150840525987e-06}};
  for (const auto& c : kCases)
    EXPECT_NEAR(chi_square_quantile(c.probability, c.degrees) / c.value, 1.0, 1e-9)
        << c.probability << ' ' << c.degrees;
}

// Two degrees of freedom: an exponential distribution.
TEST(Quantiles, ChiSquareProbability) {
  for (const double x : {0.01, 1.0, 5.0, 40.0})
    EXPECT_NEAR(chi_square_probability(x, 2.0), 1.0 - std::exp(-0.5 * x), 1e-14);
  EXPECT_EQ(chi_square_probability(-1.0, 2.0), 0.0);
}

// scipy.stats.norm.ppf.
TEST(Quantiles, Normal) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-12);
  EXPECT_NEAR(normal_quantile(1e-6), -4.753424308822899, 1e-12);
  EXPECT_NEAR(normal_quantile(0.5), 0.0, 1e-12);
}

// Probabilities that leave nothing, and no degrees of freedom.
TEST(Quantiles, Refuses) {
  EXPECT_THROW(normal_quantile(1.0), Error);
  EXPECT_THROW(chi_square_quantile(0.0, 3.0), Error);
  EXPECT_THROW(chi_square_quantile(0.5, 0.0), Error);
}

// Against scipy.stats.t (ppf and cdf), degrees of freedom from one up, whole or not.
TEST(Student, AgreesWithScipy) {
  EXPECT_NEAR(student_quantile(0.975, 5.0), 2.5705818356363146, 1e-12);
  EXPECT_NEAR(student_quantile(0.975, 1.0), 12.706204736174694, 1e-11);
  EXPECT_NEAR(student_quantile(0.975, 2.5), 3.5746548420036817, 1e-12);
  EXPECT_NEAR(student_quantile(0.995, 40.3), 2.7034580258698857, 1e-12);
  EXPECT_NEAR(student_quantile(0.9, 1e4), 1.2816362297304775, 1e-11);
  EXPECT_NEAR(student_quantile(0.025, 11.0), -2.2009851600916392, 1e-12);
  EXPECT_NEAR(student_probability(-2.5, 3.0), 0.04385332350403278, 1e-14);
  EXPECT_NEAR(student_probability(0.7, 7.5), 0.7474721890630748, 1e-14);
  EXPECT_NEAR(student_probability(4.0, 1.0), 0.5 + std::atan(4.0) / kPi, 1e-14);
  EXPECT_NEAR(student_quantile(0.5, 3.0), 0.0, 1e-12);
}

}  // namespace
}  // namespace lac::sim
