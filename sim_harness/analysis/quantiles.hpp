// SPDX-License-Identifier: Apache-2.0
// Confidence limits.
#pragma once

namespace lac::sim {

/// Probability that a chi-square variable with so many degrees of freedom (> 0, need not be whole)
/// is below x.
double chi_square_probability(double x, double degrees_of_freedom);

/// Its inverse: relative error below 1e-10. Throws lac::Error unless 0 < probability < 1 and there
/// are degrees of freedom.
double chi_square_quantile(double probability, double degrees_of_freedom);

/// Standard normal: the x with this probability below it, 0 < probability < 1 (lac::Error).
double normal_quantile(double probability);

/// Probability that a variable of Student's distribution with so many degrees of freedom (> 0, need
/// not be whole) is below x.
double student_probability(double x, double degrees_of_freedom);

/// Its inverse; throws as chi_square_quantile().
double student_quantile(double probability, double degrees_of_freedom);

}  // namespace lac::sim
