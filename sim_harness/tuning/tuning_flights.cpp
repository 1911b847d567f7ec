// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/tuning_flights.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "sim_harness/analysis/channel_figures.hpp"
#include "sim_harness/comparison/life_table.hpp"
#include "sim_harness/config/input_text.hpp"
#include "sim_harness/run/flight.hpp"
#include "sim_harness/tuning/candidate_input.hpp"
#include "sim_harness/wind/parallel_jobs.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

const CaseController& controller_of(const Case& c, const std::string& name) {
  return *std::ranges::find(c.controllers, name, &CaseController::name);
}

/// What has to be computed of a flight for these targets.
struct Wanted {
  explicit Wanted(const std::vector<TuningTarget>& targets) {
    std::set<std::string> names;
    std::set<double> exponents{4.0};
    for (const TuningTarget& t : targets) {
      names.insert(t.figure.substr(0, t.figure.find('_')));
      if (is_load(t.figure)) exponents.insert(exponent_of(t.figure));
    }
    channels.assign(names.begin(), names.end());
    options.woehler_exponents.assign(exponents.begin(), exponents.end());
  }
  std::vector<std::string> channels;
  FigureOptions options;
};

}  // namespace

TuningFlights::TuningFlights(const Tuning& tuning, fs::path work, int threads,
                             const Interruption& interruption)
    : tuning_(tuning), work_(std::move(work)), threads_(threads), interruption_(interruption) {
  std::map<std::string, std::size_t> made;
  for (const StudyCase& study_case : tuning.cases) {
    cases_.push_back(load_case(tuning.base_case, study_case.overrides));
    const auto [wind, is_new] = made.try_emplace(study_case.wind, winds_.size());
    if (is_new) winds_.push_back(make_case_wind(cases_.back()));
    wind_of_.push_back(wind->second);
    interruption.check();
  }
  controller_ = controller_of(cases_.front(), tuning.controller);
  for (const Case& c : cases_) {
    const CaseController& here = controller_of(c, tuning.controller);
    if (here.input_file != controller_.input_file || here.library != controller_.library ||
        here.entry != controller_.entry)
      throw Error(tuning.file.string() + ": controller: has another input file, library or entry " +
                  "in some of the cases, expected one controller to tune");
  }
  input_file_ = input_of_secondary(controller_.input_file, tuning.secondary);
  template_text_ = text_of_file(input_file_);
}

void TuningFlights::check() const {
  if (interruption_.requested())
    throw Interrupted("interrupted: no input file is written; evaluations.csv has what is known");
}

std::string TuningFlights::input_text(const Point& values) const {
  std::vector<KeyValue> keys;
  for (std::size_t i = 0; i < values.size(); ++i)
    keys.push_back({tuning_.parameters[i].key, shortest(values[i])});
  return with_values(template_text_, keys);
}

TuningFlights::Flight TuningFlights::fly_one(std::size_t i, const CaseController& controller,
                                             const fs::path& output_root) const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Wanted wanted(tuning_.targets);
  wanted.options.from_s = cases_[i].time.run_in_s;
  FlightReport report;
  report.on_progress = [this](double) { check(); };
  Flight flight{std::vector<double>(tuning_.targets.size(), kNone), {}};
  try {
    const CaseWind& wind = winds_[wind_of_[i]];
    const Recording flown =
        sim::fly(cases_[i], controller, *wind.field, wind.rotor, output_root, report);
    const std::vector<NamedFigure> figures =
        named_figures(channel_figures(flown, wanted.options, wanted.channels), wanted.options);
    for (std::size_t t = 0; t < flight.figures.size(); ++t)
      flight.figures[t] =
          std::ranges::find(figures, tuning_.targets[t].figure, &NamedFigure::name)->value;
  } catch (const Interrupted&) {
    throw;
  } catch (const Error& e) {
    flight.problem = "case " + tuning_.cases[i].name + ": " + e.what();
  }
  return flight;
}

std::vector<double> TuningFlights::figures_over_cases(const std::vector<Flight>& flights) const {
  std::vector<double> all;
  for (std::size_t t = 0; t < tuning_.targets.size(); ++t) {
    std::vector<double> of_cases;
    for (const std::size_t i : tuning_.targets[t].cases) of_cases.push_back(flights[i].figures[t]);
    all.push_back(over_cases(tuning_.targets[t].figure, of_cases));
  }
  return all;
}

int TuningFlights::threads_of(const std::string& controller) const {
  const bool in_threads = std::ranges::all_of(
      cases_, [&](const Case& c) { return can_fly_in_threads(controller_of(c, controller)); });
  return in_threads ? threads_ : 1;
}

std::vector<double> TuningFlights::fly_baseline() {
  std::vector<Flight> flights(cases_.size());
  for_each_job(static_cast<int>(cases_.size()), threads_of(tuning_.baseline), [&] {
    return [&](int job) {
      const auto i = static_cast<std::size_t>(job);
      flights[i] = fly_one(i, controller_of(cases_[i], tuning_.baseline),
                           work_ / ("baseline-" + std::to_string(i)));
    };
  });
  for (const Flight& f : flights)
    if (!f.problem.empty()) throw Error(tuning_.baseline + ": " + f.problem);
  return figures_over_cases(flights);
}

void TuningFlights::link(Candidate& c, const Point& values) const {
  c.controller = controller_;
  c.controller.input_file =
      linked_chain(controller_.input_file, input_file_, input_text(values), c.folder);
}

Evaluation TuningFlights::evaluation_of(const Candidate& c, const Point& values,
                                        const std::vector<double>& baseline) const {
  const auto bad =
      std::ranges::find_if(c.flights, [](const Flight& f) { return !f.problem.empty(); });
  if (bad != c.flights.end())
    return {.values = values, .figures = {}, .changes = {}, .problem = bad->problem};
  return evaluated(values, tuning_.targets, figures_over_cases(c.flights), baseline);
}

std::vector<Evaluation> TuningFlights::fly(const std::vector<Point>& points,
                                           const std::vector<double>& baseline,
                                           const std::function<void(double)>& progress) {
  std::vector<Candidate> candidates(points.size());
  for (Candidate& c : candidates) {
    c.folder = work_ / std::to_string(flown_points_++);
    c.flights.resize(cases_.size());
  }
  const std::size_t count = points.size() * cases_.size();
  std::mutex one_at_a_time;
  std::size_t done = 0;
  const auto fly_job = [&](int job) {
    const std::size_t p = static_cast<std::size_t>(job) / cases_.size();
    const std::size_t i = static_cast<std::size_t>(job) % cases_.size();
    Candidate& c = candidates[p];
    {
      const std::scoped_lock lock(one_at_a_time);
      if (c.begun++ == 0) link(c, points[p]);
    }
    c.flights[i] = fly_one(i, c.controller, c.folder / ("flight-" + std::to_string(i)));
    const std::scoped_lock lock(one_at_a_time);
    if (++c.ended == cases_.size()) fs::remove_all(c.folder);
    progress(static_cast<double>(++done) / static_cast<double>(count));
  };
  try {
    for_each_job(static_cast<int>(count), threads_of(tuning_.controller), [&] { return fly_job; });
  } catch (const Interrupted&) {  // what has flown to its end counts
  }
  std::vector<Evaluation> evaluations;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (candidates[p].ended == cases_.size())
      evaluations.push_back(evaluation_of(candidates[p], points[p], baseline));
  return evaluations;
}

}  // namespace lac::sim
