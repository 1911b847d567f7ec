// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/lattice_moments.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_harness/wind/plane_sampler.hpp"

namespace lac::sim {
namespace {

/// exp(-rate r) on a lattice.
CoherencyTable exponential(const Lattice& lattice, double rate) {
  CoherencyTable table(lattice);
  for (int z = 1 - lattice.nz; z < lattice.nz; ++z) {
    for (int y = 1 - lattice.ny; y < lattice.ny; ++y)
      table.at(y, z) = std::exp(-rate * std::hypot(y * lattice.dy_m, z * lattice.dz_m));
  }
  return table;
}

// Independent points: 1 / n; points that do the same: 1, however many.
TEST(LatticeMoments, PowerLimits) {
  const Lattice lattice{5, 4, 10.0, 10.0};
  EXPECT_NEAR(variance_of_mean_power(exponential(lattice, 1e3)), 1.0 / 20.0, 1e-12);
  EXPECT_NEAR(variance_of_mean_power(exponential(lattice, 0.0)), 1.0, 1e-12);
}

// Two points of coherence g: (1 + g^2) / 2. One pair: variance of g is (1 - g^2)^2 / 2, that of
// atanh g is 1/2 whatever g is.
TEST(LatticeMoments, TwoPoints) {
  const Lattice lattice{2, 1, 10.0, 10.0};
  for (const double rate : {0.001, 0.05, 1.0}) {
    const CoherencyTable table = exponential(lattice, rate);
    const double g = std::exp(-10.0 * rate);
    EXPECT_NEAR(variance_of_mean_power(table), 0.5 * (1.0 + g * g), 1e-12);
    EXPECT_NEAR(variance_of_coherence(table, 1, 0), 0.5, 1e-6);
  }
}

// Pairs that know nothing of each other count one by one.
TEST(LatticeMoments, IndependentPairs) {
  const CoherencyTable table = exponential({9, 7, 10.0, 10.0}, 1e3);
  EXPECT_NEAR(variance_of_coherence(table, 2, 3), 0.5 / (7 * 4), 1e-12);
}

/// Mean power and coherence of 16 frequencies drawn from the model, once.
struct Draw {
  double power = 0.0;
  double z = 0.0;  // atanh of the coherence
};

Draw draw(CheapestSampler& sampler, const Lattice& l, int y, int z, ComplexNormal& noise) {
  Draw result;
  double cross = 0.0, power_1 = 0.0, power_2 = 0.0;
  std::vector<std::complex<double>> a(static_cast<std::size_t>(l.points()));
  for (int f = 0; f < 16; ++f) {
    sampler.sample(noise, a);
    for (const auto& value : a) result.power += std::norm(value) / l.points() / 16.0;
    for (int iz = 0; iz + z < l.nz; ++iz) {
      for (int iy = 0; iy + y < l.ny; ++iy) {
        const auto a1 = a[iz * l.ny + iy], a2 = a[(iz + z) * l.ny + iy + y];
        cross += (a1 * std::conj(a2)).real();
        power_1 += std::norm(a1);
        power_2 += std::norm(a2);
      }
    }
  }
  result.z = std::atanh(cross / std::sqrt(power_1 * power_2));
  return result;
}

// Against 3000 draws of a correlated plane, 16 frequencies each: variances within 10 % (a variance
// of 3000 normal values has a standard error of 2.6 %, first order in the coherence the rest).
TEST(LatticeMoments, AgreeWithDraws) {
  const Lattice lattice{7, 5, 10.0, 12.0};
  CheapestSampler sampler({7, 5, 10.0, 12.0});
  ComplexNormal noise(3, 0, 0);
  for (const double rate : {0.01, 0.05}) {
    ASSERT_TRUE(sampler.prepare(rate));
    const CoherencyTable table = exponential(lattice, rate);
    double power = 0.0, power_2 = 0.0, z = 0.0, z_2 = 0.0;
    constexpr int kDraws = 3000;
    for (int i = 0; i < kDraws; ++i) {
      const Draw d = draw(sampler, lattice, 2, 1, noise);
      power += d.power / kDraws, power_2 += d.power * d.power / kDraws;
      z += d.z / kDraws, z_2 += d.z * d.z / kDraws;
    }
    EXPECT_NEAR((power_2 - power * power) * 16.0 / variance_of_mean_power(table), 1.0, 0.1);
    EXPECT_NEAR((z_2 - z * z) * 16.0 / variance_of_coherence(table, 2, 1), 1.0, 0.1) << rate;
  }
}

}  // namespace
}  // namespace lac::sim
