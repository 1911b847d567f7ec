// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <functional>
#include <vector>

namespace lac::sim {

/// What a point is worth: first by how much it misses its conditions (0: it meets them), then by
/// what is to be small. Points that meet all conditions come before all that do not.
struct Score {
  double violation = 0.0;
  double objective = 0.0;

  auto operator<=>(const Score&) const = default;
};

using Point = std::vector<double>;

/// A box, and the size of the first simplex along each side.
struct SearchBox {
  Point lower, upper;
  Point step;  // > 0, at most upper - lower
};

/// Evaluates points of the box, one score each; may do them side by side.
using EvaluatePoints = std::function<std::vector<Score>(const std::vector<Point>&)>;

/// Nelder and Mead's simplex search in a box (Computer Journal 7, 1965, pp. 308-313; coefficients
/// 1, 2, 1/2, 1/2), which compares scores and does not calculate with them, so that conditions need
/// no weights. Points outside are moved to the border. Ends after `evaluations`, or when the
/// simplex is smaller than `tolerance` times the first one along every side. Returns the best point
/// seen.
Point simplex_search(const Point& start, Score start_score, const SearchBox& box, int evaluations,
                     double tolerance, const EvaluatePoints& evaluate);

}  // namespace lac::sim
