// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/simplex_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lac::sim {
namespace {

/// Counts, and refuses points outside of the box.
class Course {
 public:
  Course(SearchBox box, std::function<Score(const Point&)> score)
      : box_(std::move(box)), score_(std::move(score)) {}

  Point search(const Point& start, int most, double tolerance = 1e-4) {
    return simplex_search(start, score_(start), box_, most, tolerance,
                          [this](const std::vector<Point>& points) {
                            std::vector<Score> scores;
                            for (const Point& p : points) scores.push_back(looked_at(p));
                            return scores;
                          });
  }
  int evaluations = 0;

 private:
  Score looked_at(const Point& p) {
    ++evaluations;
    for (std::size_t i = 0; i < p.size(); ++i) {
      EXPECT_GE(p[i], box_.lower[i]);
      EXPECT_LE(p[i], box_.upper[i]);
    }
    return score_(p);
  }
  SearchBox box_;
  std::function<Score(const Point&)> score_;
};

const SearchBox kBox{{-5.0, -5.0}, {5.0, 5.0}, {1.0, 1.0}};

// Whatever the objective, points that meet their conditions come first; NaN is no score to win
// with.
TEST(Score, ConditionsFirst) {
  EXPECT_LT((Score{0.0, 100.0}), (Score{1e-9, -100.0}));
  EXPECT_LT((Score{0.0, 1.0}), (Score{0.0, 2.0}));
  EXPECT_LT((Score{0.1, 2.0}), (Score{0.2, 1.0}));
  EXPECT_FALSE((Score{0.0, std::nan("")}) < (Score{0.0, 1.0}));
}

// Rosenbrock's valley, minimum in (1, 1).
TEST(SimplexSearch, FindsTheEndOfACurvedValley) {
  Course course(kBox, [](const Point& p) {
    return Score{0.0, 100.0 * std::pow(p[1] - p[0] * p[0], 2) + std::pow(1.0 - p[0], 2)};
  });
  const Point best = course.search({-1.2, 1.0}, 400, 1e-6);
  EXPECT_NEAR(best[0], 1.0, 1e-4);
  EXPECT_NEAR(best[1], 1.0, 2e-4);
}

// A minimum outside of the box: its nearest point on the border, here a corner.
TEST(SimplexSearch, StopsAtTheBorder) {
  Course course(kBox, [](const Point& p) {
    return Score{0.0, std::pow(p[0] - 9.0, 2) + std::pow(p[1] + 7.0, 2)};
  });
  const Point best = course.search({0.0, 0.0}, 200);
  EXPECT_NEAR(best[0], 5.0, 1e-3);
  EXPECT_NEAR(best[1], -5.0, 1e-3);
}

// x^2 + y^2 with x >= 1 + y^2: the optimum (1, 0) lies on the condition.
TEST(SimplexSearch, KeepsACondition) {
  Course course(kBox, [](const Point& p) {
    return Score{std::max(1.0 + p[1] * p[1] - p[0], 0.0), p[0] * p[0] + p[1] * p[1]};
  });
  const Point best = course.search({4.0, 1.5}, 300, 1e-6);
  EXPECT_GE(best[0], 1.0 + best[1] * best[1]);
  EXPECT_NEAR(best[0], 1.0, 0.02);
  EXPECT_NEAR(best[1], 0.0, 0.15);
}

// It ends: by the number of evaluations, which a last step may exceed by what it needs; and by
// size.
TEST(SimplexSearch, Ends) {
  const auto bowl = [](const Point& p) { return Score{0.0, p[0] * p[0] + p[1] * p[1]}; };
  Course few(kBox, bowl);
  few.search({3.0, 3.0}, 10, 0.0);
  EXPECT_GE(few.evaluations, 10);
  EXPECT_LE(few.evaluations, 10 + 3);
  Course small(kBox, bowl);
  small.search({3.0, 3.0}, 1000, 0.1);
  EXPECT_LT(small.evaluations, 60);
}

// Failed flights everywhere but at the start (infinite scores): the start is the best.
TEST(SimplexSearch, LivesWithoutNeighbours) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Course course(kBox, [](const Point& p) {
    return p == Point{0.0, 0.0} ? Score{0.0, 1.0} : Score{kInfinite, kInfinite};
  });
  EXPECT_EQ(course.search({0.0, 0.0}, 50), (Point{0.0, 0.0}));
}

}  // namespace
}  // namespace lac::sim
