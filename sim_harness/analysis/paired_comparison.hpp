// SPDX-License-Identifier: Apache-2.0
// Two controllers on the same winds: is there a difference, and how large?
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace lac::sim {

/// The mean of a quantity with A and with B, and an interval that holds the true mean difference
/// with the stated confidence if the differences of the pairs are independent and normal (Student).
struct PairedDifference {
  std::size_t pairs = 0;
  double mean_a = 0.0;
  double mean_b = 0.0;
  double low = 0.0;  // of the mean of b - a; NaN with fewer than two pairs
  double high = 0.0;
  double confidence = 0.95;

  double difference() const { return mean_b - mean_a; }
  /// The interval leaves 0 out.
  bool significant() const { return low > 0.0 || high < 0.0; }
  bool has_interval() const { return low <= high; }
  /// As a share of |mean_a|, which counts as known.
  double relative_change() const;
  double relative_low() const;
  double relative_high() const;
  /// "significant", "not significant at 95 %" or "one pair: no interval".
  std::string verdict() const;
};

/// a[i] and b[i] of the same wind. Throws lac::Error if their numbers differ or there is none.
PairedDifference compare_pairs(std::span<const double> a, std::span<const double> b,
                               double confidence = 0.95);

/// A sum of independent differences, each times its weight: over the wind speeds of a life.
/// Degrees of freedom after Welch and Satterthwaite. No interval if one has none.
PairedDifference weighted_sum(std::span<const PairedDifference> parts,
                              std::span<const double> weights);

}  // namespace lac::sim
