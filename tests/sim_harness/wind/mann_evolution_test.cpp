// SPDX-License-Identifier: Apache-2.0
// Planes of evolving Mann turbulence against the space-time tensor, over seeds which are fixed.
#include <gtest/gtest.h>

#include "tests/sim_harness/wind/mann_reference.hpp"

namespace lac::sim {
namespace {

// Planes 50, 100 and 170 m up-wind: each has the spectra of the first, every two the coherence of
// the space-time tensor for their distance (so the recursion is Markov), across the wind too.
TEST(MannEvolution, SpaceTimeTensor) {
  MannFieldParams p = small_box();
  p.model.evolution_s = 200.0;
  const std::vector<double> distances{50.0, 100.0, 170.0};
  std::vector<Pair> pairs;
  for (int plane = 0; plane < 4; ++plane) {
    pairs.push_back({{0, 2, 2, 0}, {0, 2, 2, plane}});
    pairs.push_back({{2, 2, 2, plane}, {2, 2, 2, plane}});
  }
  pairs.push_back({{0, 2, 2, 1}, {0, 2, 2, 3}});
  pairs.push_back({{1, 2, 2, 0}, {1, 2, 2, 2}});
  pairs.push_back({{0, 1, 1, 0}, {0, 2, 3, 2}});
  pairs.push_back({{0, 1, 1, 0}, {2, 1, 1, 2}});
  expect_products(p, distances, pairs, 60);
}

// Frozen turbulence is the same in every plane.
TEST(MannEvolution, FrozenPlanes) {
  const EvolvingWind wind = make_evolving_mann_field(small_box(), std::vector{80.0});
  EXPECT_TRUE(std::ranges::equal(wind.planes()[0].wind.grid().plane(9),
                                 wind.planes()[1].wind.grid().plane(9)));
}

}  // namespace
}  // namespace lac::sim
