// SPDX-License-Identifier: Apache-2.0
// Fatigue: rainflow counting and damage-equivalent loads.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lac::sim {

/// Range is the full stroke (maximum minus minimum), not the amplitude.
struct LoadCycle {
  double range = 0.0;
  double mean = 0.0;
  double count = 0.0;  // 1 closed cycle, 0.5 half cycle

  bool operator==(const LoadCycle&) const = default;
};

/// First sample, every reversal, last sample; equal neighbours count once.
std::vector<double> turning_points(std::span<const double> series);

enum class RainflowRule {
  /// Three points, ASTM E1049-85 section 5.4.4: ranges that hold the start of the history, and the
  /// residue, count half.
  kAstm,
  /// Four points (Amzallag et al. 1994): an inner range not above either of its neighbours closes.
  /// The residue is repeated once and closed the same way: the history of a load that goes on.
  kFourPoint,
};

/// In the order in which they close. No binning. Throws lac::Error if a sample is not finite.
std::vector<LoadCycle> rainflow(std::span<const double> series,
                                RainflowRule rule = RainflowRule::kAstm);

enum class ReferenceCycles {
  kOneHertz,                 // N_ref = T: the load that acts once a second
  kTwoMillionInTwentyYears,  // N_ref = 2e6 T / (20 * 8760 * 3600 s): life-scaled
};

/// What loads of any exponent mean.
struct DelRule {
  ReferenceCycles reference = ReferenceCycles::kOneHertz;
  RainflowRule counting = RainflowRule::kAstm;

  bool operator==(const DelRule&) const = default;
  /// "R the full range, reference ...; rainflow ...", for reports.
  std::string text() const;
};

/// Words for tables and command lines: "1hz", "2e6in20y"; "astm", "four-point".
const char* word_of(ReferenceCycles reference);
const char* word_of(RainflowRule rule);
/// Of two such words; none if one of them is another.
std::optional<DelRule> del_rule_of(const std::string& reference, const std::string& counting);

/// What a damage-equivalent load means; two numbers compare only if all of it is the same.
struct DelConvention {
  double woehler_exponent = 4.0;  // m: 4 for steel towers and shafts, 10 for composite blades
  ReferenceCycles reference = ReferenceCycles::kOneHertz;
  RainflowRule counting = RainflowRule::kAstm;

  /// N_ref of a record of this length.
  double reference_cycles(double duration_s) const;

  /// The convention in words, for reports.
  std::string text() const;
};

/// (sum n_i R_i^m / N_ref)^(1/m), in the unit of the load. The cycles must have been counted by
/// the convention's rule.
double damage_equivalent_load(std::span<const LoadCycle> cycles, double duration_s,
                              const DelConvention& convention);

/// The same for a series: duration is its number of samples times the step.
double damage_equivalent_load(std::span<const double> series, double time_step_s,
                              const DelConvention& convention);

}  // namespace lac::sim
