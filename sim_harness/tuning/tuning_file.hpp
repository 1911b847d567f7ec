// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sim_harness/campaign/study_cases.hpp"

namespace lac::sim {

/// A key of the input file and the values on the grid.
struct TuningParameter {
  std::string key;
  std::vector<double> values;  // rising, of four_digits()
};

/// A figure of the flights (docs/campaigns.md) over some cases of the study: loads by damage, all
/// others, extremes too, as the mean over the cases.
struct TuningTarget {
  enum class Kind { kMinimise, kMaximise, kAtLeast, kAtMost };

  std::string figure;  // "TwrBsMyt_max"
  std::string where;   // "turbulence etm"; empty: all cases
  Kind kind = Kind::kMinimise;
  double limit = 0.0;              // of conditions: relative change from the baseline
  std::vector<std::size_t> cases;  // of the study

  bool wants_less() const { return kind == Kind::kMinimise || kind == Kind::kAtMost; }
};

/// Input of `lac tune` (docs/tuning.md lists the keys).
struct Tuning {
  std::filesystem::path file;
  std::string name;
  std::filesystem::path base_case;
  std::vector<StudyCase> cases;  // with the overrides of the tuning behind their own
  std::string baseline;          // controller of the case that changes count from
  std::string controller;        // the one that is tuned
  std::string secondary;         // of its chain: whose input file is tuned
  std::vector<TuningParameter> parameters;
  std::vector<TuningTarget> targets;  // the objective first, then conditions
  int refinements = 0;  // flights of the simplex search, in parameter sets; 0: grid only
};

/// Rounded to what is written and flown: four significant digits.
double four_digits(double v);

/// Reads a tuning file and the study it names; `overrides`: keys of the case, behind its `set`.
/// Throws lac::Error: file, line, key, found, expected, hint. Every case is loaded as a run would.
Tuning load_tuning(const std::filesystem::path& file,
                   const std::vector<std::string>& overrides = {});

}  // namespace lac::sim
