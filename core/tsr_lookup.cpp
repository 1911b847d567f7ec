// SPDX-License-Identifier: Apache-2.0
#include "core/tsr_lookup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
// A pitch record of single precision may lie this far beyond the end of the table.
constexpr double kRounding_rad = 1e-5;
// Newton from the outer end of an interval of the table: quadratic, and the interval is narrow.
constexpr int kNewtonSteps = 6;
constexpr double kExact = 1e-7;  // of the last step: its square is left

}  // namespace

TsrLookup::TsrLookup(const RotorTable& table) : tsr_(table.tsr()), pitch_rad_(table.pitch_rad()) {
  for (const double tsr : tsr_) tsr_cubed_.push_back(tsr * tsr * tsr);
  for (const double pitch_rad : pitch_rad_) {
    for (const double tsr : tsr_) cp_.push_back(table.cp(tsr, pitch_rad));
  }
  for (std::size_t i = 0; i < pitch_rad_.size(); ++i) branches_.push_back(falling_branch(i));
}

TsrLookup::Branch TsrLookup::falling_branch(std::size_t column) const {
  const double* cp = &cp_[column * tsr_.size()];
  const auto quotient = [&](std::size_t row) { return cp[row] / tsr_cubed_[row]; };
  const auto turning = std::upper_bound(tsr_.begin(), tsr_.end() - 1, 0.0);  // not at rest
  Branch b;
  b.first = static_cast<std::size_t>(turning - tsr_.begin());
  for (std::size_t i = b.first + 1; i < tsr_.size(); ++i) {
    if (quotient(i) > quotient(b.first)) b.first = i;
  }
  b.last = b.first;
  while (b.last + 1 < tsr_.size() && quotient(b.last + 1) < quotient(b.last)) ++b.last;
  if (b.last > b.first) return b;
  throw Error("rotor table: at a pitch of " + std::to_string(deg_from_rad(pitch_rad_[column])) +
              " deg the power coefficient over the tip-speed ratio cubed does not fall, expected "
              "a table that reaches to higher tip-speed ratios");
}

/// lambda between rows `row` and `row` + 1, where C_p is a + b lambda: root of the concave (target
/// above 0) or convex g = a + b lambda - target lambda^3, from the end at which Newton's steps
/// cannot overshoot.
double TsrLookup::solve(const Column& cp, std::size_t row, double target) const noexcept {
  const double slope = (cp.cp(row + 1) - cp.cp(row)) / (tsr_[row + 1] - tsr_[row]);
  const double at_zero = cp.cp(row) - slope * tsr_[row];
  double x = target > 0.0 ? tsr_[row + 1] : tsr_[row];
  for (int i = 0; i < kNewtonSteps; ++i) {
    const double gradient = slope - 3.0 * target * x * x;
    if (gradient == 0.0) break;
    const double change = (at_zero + slope * x - target * x * x * x) / gradient;
    x -= change;
    if (std::abs(change) < kExact * x) break;
  }
  return x;
}

double TsrLookup::tsr(double target, double pitch_rad) const noexcept {
  if (!std::isfinite(target)) return kNothing;
  const double first_rad = pitch_rad_.front(), last_rad = pitch_rad_.back();
  if (!(pitch_rad >= first_rad - kRounding_rad && pitch_rad <= last_rad + kRounding_rad)) {
    return kNothing;
  }
  const double inside_rad = std::clamp(pitch_rad, first_rad, last_rad);
  const auto upper = std::upper_bound(pitch_rad_.begin() + 1, pitch_rad_.end() - 1, inside_rad);
  const auto j = static_cast<std::size_t>(upper - pitch_rad_.begin()) - 1;
  const Column cp{&cp_[j * tsr_.size()], &cp_[(j + 1) * tsr_.size()],
                  (inside_rad - pitch_rad_[j]) / (pitch_rad_[j + 1] - pitch_rad_[j])};
  std::size_t low = std::max(branches_[j].first, branches_[j + 1].first);
  std::size_t high = std::min(branches_[j].last, branches_[j + 1].last);
  const auto above = [&](std::size_t row) { return cp.cp(row) - target * tsr_cubed_[row]; };
  if (low >= high || above(low) < 0.0 || above(high) > 0.0) return kNothing;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (above(middle) >= 0.0 ? low : high) = middle;
  }
  return solve(cp, low, target);
}

}  // namespace lac
