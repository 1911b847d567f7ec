// SPDX-License-Identifier: Apache-2.0
// Planes of evolving Mann turbulence against the space-time tensor, over seeds which are fixed.
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/sim_harness/wind/mann_reference.hpp"
#include "tests/sim_harness/wind/plane_comparison.hpp"

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
  MannPlanes planes(small_box());
  const GriddedWind rotor = planes.next(0.0), upwind = planes.next(80.0);
  EXPECT_TRUE(std::ranges::equal(rotor.grid().plane(9), upwind.grid().plane(9)));
}

MannFieldParams evolving_box() {
  MannFieldParams p = small_box();
  p.model.evolution_s = 200.0;
  return p;
}

// All planes at once are those drawn one by one, whole and thinned, on any number of threads; a
// plane of which nothing is wanted does not change those behind it.
TEST(MannEvolution, AllAtOnceAsOneByOne) {
  const PlaneLayout layout({50.0, 100.0, 170.0});
  const WindDemand demand{{}, {{-52.0, 3.0, 95.0}, {-180.0, -14.0, 84.0}}, 1.0};
  MannFieldParams p = evolving_box();
  for (const int threads : {1, 3}) {
    p.threads = threads;
    EXPECT_TRUE(same_as_one_by_one(draw_evolving_mann(p, layout), MannPlanes(evolving_box())));
    const EvolvingGrids thinned = draw_evolving_mann(p, layout, &demand);
    EXPECT_EQ(thinned.upwind[0].columns().count(), 4U);
    EXPECT_EQ(thinned.upwind[1].columns().count(), 0U);
    EXPECT_EQ(thinned.upwind[2].columns().count(), 4U);
    EXPECT_TRUE(same_as_one_by_one(thinned, MannPlanes(evolving_box())));
  }
  p.seed = 2;
  EXPECT_FALSE(same_as_one_by_one(draw_evolving_mann(p, layout), MannPlanes(evolving_box())));
}

// Planes of a model that does not evolve are refused.
TEST(MannEvolution, RefusesFrozenTurbulence) {
  EXPECT_THROW(draw_evolving_mann(small_box(), PlaneLayout({50.0})), Error);
}

}  // namespace
}  // namespace lac::sim
