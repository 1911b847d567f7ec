// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/time_transform.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/units.hpp"

namespace lac::sim {
namespace {

/// 5 x 7 points, so that blocks of points are not whole.
VelocityGrid grid_of(int nt) {
  return VelocityGrid({5, 7, nt, 10.0, 10.0, 1.0, 60.0, 90.0, 16.0, true});
}

// A_m in time steps 2 m - 1 and 2 m becomes 2 Re{A_m e^(i 2 pi m t / T)} at its own point and
// component, plus the mean of the height for u; with even and odd numbers of steps, several
// threads.
TEST(TimeTransform, AmplitudesBecomeWaves) {
  for (const int nt : {16, 15}) {
    VelocityGrid grid = grid_of(nt);
    for (int iz = 0; iz < 7; ++iz) {
      for (int iy = 0; iy < 5; ++iy) {
        for (int c = 0; c < 3; ++c) {
          const int m = 1 + (iy + iz + c) % 7;
          grid.at(2 * m - 1, iz, iy, c) = 0.5F + static_cast<float>(iy);
          grid.at(2 * m, iz, iy, c) = 0.25F * static_cast<float>(iz);
        }
      }
    }
    const std::vector<float> mean{1, 2, 3, 4, 5, 6, 7};
    amplitudes_to_series(grid, mean, 3);
    for (int iz = 0; iz < 7; ++iz) {
      for (int iy = 0; iy < 5; ++iy) {
        for (int c = 0; c < 3; ++c) {
          for (int it = 0; it < nt; ++it) {
            const double phase = 2.0 * kPi * (1 + (iy + iz + c) % 7) * it / nt;
            const double wave = 2.0 * ((0.5 + iy) * std::cos(phase) - 0.25 * iz * std::sin(phase));
            EXPECT_NEAR(grid.at(it, iz, iy, c), wave + (c == 0 ? iz + 1.0 : 0.0), 1e-5);
          }
        }
      }
    }
  }
}

/// Random amplitudes of all harmonics and a mean profile.
template <class Grid>
void fill(Grid& grid) {
  std::mt19937 random(7);
  std::normal_distribution<float> normal;
  std::vector<std::complex<float>> amplitudes(grid.spec().plane_points());
  for (int m = 1; m <= grid.spec().nt / 2; ++m) {
    for (int c = 0; c < 3; ++c) {
      for (auto& a : amplitudes) a = {normal(random), normal(random)};
      put_amplitudes(amplitudes, c, m, grid);
    }
  }
  amplitudes_to_series(grid, std::vector<float>{1, 2, 3, 4, 5, 6, 7}, 2);
}

// Columns of a thinned grid become those of the whole grid, to the last bit.
TEST(TimeTransform, ThinnedAsWhole) {
  std::vector<bool> kept(35);
  for (const int point : {0, 7, 8, 34}) kept[point] = true;
  for (const int nt : {48, 45}) {
    VelocityGrid whole = grid_of(nt);
    fill(whole);
    const ThinnedGrid expected(whole, GridColumns(kept));
    ThinnedGrid found(whole.spec(), GridColumns(kept));
    fill(found);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_TRUE(std::ranges::equal(found.column(i), expected.column(i))) << nt << ' ' << i;
    EXPECT_NE(found.column(3)[5], 0.0F);
  }
}

// The Nyquist amplitude of an even number of steps is real and enters once.
TEST(TimeTransform, Nyquist) {
  VelocityGrid grid = grid_of(8);
  grid.at(7, 2, 3, 1) = 3.0F;
  amplitudes_to_series(grid, std::vector<float>(7), 1);
  for (int it = 0; it < 8; ++it) EXPECT_NEAR(grid.at(it, 2, 3, 1), it % 2 == 0 ? 3.0 : -3.0, 1e-6);
  EXPECT_EQ(grid.at(3, 2, 2, 1), 0.0F);
}

}  // namespace
}  // namespace lac::sim
