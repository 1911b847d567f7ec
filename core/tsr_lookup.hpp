// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/rotor_table.hpp"

namespace lac {

/// The rotor table the other way round: tip-speed ratio from C_p/lambda^3 and pitch (HM eqs. 16,
/// 17; methods section 9). At a given pitch C_p/lambda^3 falls strictly with lambda from its
/// largest value on; this branch alone is used. C_p is bilinear as in RotorTable, so that the
/// inversion of RotorTable::cp is exact to rounding.
class TsrLookup {
 public:
  /// Throws Error if at some pitch C_p/lambda^3 falls over fewer than two entries.
  explicit TsrLookup(const RotorTable& table);

  /// Not a number outside the falling branch or the pitch range, and for what is not finite; never
  /// the edge. [real time]
  double tsr(double cp_over_tsr_cubed, double pitch_rad) const noexcept;

 private:
  struct Branch {
    std::size_t first = 0;
    std::size_t last = 0;  // included
  };
  struct Column {  // C_p at one pitch between two of the table
    const double* low;
    const double* high;
    double weight;
    double cp(std::size_t row) const noexcept { return low[row] + weight * (high[row] - low[row]); }
  };

  Branch falling_branch(std::size_t column) const;
  double solve(const Column& cp, std::size_t row, double target) const noexcept;

  std::vector<double> tsr_;
  std::vector<double> tsr_cubed_;
  std::vector<double> pitch_rad_;
  std::vector<double> cp_;  // [i_pitch * tsr_.size() + i_tsr]
  std::vector<Branch> branches_;
};

}  // namespace lac
