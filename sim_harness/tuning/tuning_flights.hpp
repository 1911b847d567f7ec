// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim_harness/run/interruption.hpp"
#include "sim_harness/run/run_case.hpp"
#include "sim_harness/tuning/evaluation.hpp"
#include "sim_harness/tuning/tuning_file.hpp"

namespace lac::sim {

/// The cases of a tuning with their winds in memory, each made once, flown as often as wanted over
/// all cores. Equal parameters give equal numbers, whatever flies beside them.
class TuningFlights {
 public:
  /// Makes the winds. `work`: an empty folder for input files of candidates, which are there only
  /// while these fly. Throws lac::Error; Interrupted between two winds.
  TuningFlights(const Tuning& tuning, std::filesystem::path work, int threads,
                const Interruption& interruption);

  /// Figures of the baseline, one per target. Throws lac::Error, Interrupted.
  std::vector<double> fly_baseline();

  /// One evaluation per point; a controller that refuses its input or ends its flight is the
  /// problem of its point. Throws lac::Error if files cannot be written. `progress` is told the
  /// share that is done. After an interruption: of those points alone that are through all cases.
  std::vector<Evaluation> fly(const std::vector<Point>& points, const std::vector<double>& baseline,
                              const std::function<void(double)>& progress);

  /// Throws Interrupted if somebody has asked to stop.
  void check() const;

  /// The input file that is tuned, as it is now, and its text.
  const std::filesystem::path& input_file() const { return input_file_; }
  /// That text with the values of a point.
  std::string input_text(const Point& values) const;

 private:
  struct Flight {
    std::vector<double> figures;  // one per target that looks at the case, NaN for the others
    std::string problem;
  };

  /// A point on its flights.
  struct Candidate {
    std::filesystem::path folder;
    CaseController controller;
    std::vector<Flight> flights;  // one per case
    std::size_t begun = 0, ended = 0;
  };

  void link(Candidate& candidate, const Point& values) const;
  Evaluation evaluation_of(const Candidate& candidate, const Point& values,
                           const std::vector<double>& baseline) const;
  Flight fly_one(std::size_t case_index, const CaseController& controller,
                 const std::filesystem::path& output_root) const;
  /// One where the library keeps static data, which flights would share.
  int threads_of(const std::string& controller) const;
  std::vector<double> figures_over_cases(const std::vector<Flight>& flights) const;

  const Tuning& tuning_;
  std::filesystem::path work_;
  int threads_;
  const Interruption& interruption_;
  std::vector<Case> cases_;
  std::vector<std::size_t> wind_of_;  // of each case
  std::vector<CaseWind> winds_;
  CaseController controller_;  // that is tuned
  std::filesystem::path input_file_;
  std::string template_text_;
  std::size_t flown_points_ = 0;
};

}  // namespace lac::sim
