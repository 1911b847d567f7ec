// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/tuning.hpp"

#include <algorithm>
#include <ostream>
#include <thread>

#include "core/error.hpp"
#include "core/part_file.hpp"
#include "sim_harness/config/input_text.hpp"
#include "sim_harness/config/temporary_folder.hpp"
#include "sim_harness/output/progress.hpp"
#include "sim_harness/run/interruption.hpp"
#include "sim_harness/tuning/tuning_flights.hpp"
#include "sim_harness/tuning/tuning_report.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr double kSmallestSimplex = 0.05;  // of a step of the grid
constexpr std::size_t kMostGridPoints = 100000;

/// The border of the grid, which rounding to the digits of the grid cannot pass; half a step of it
/// for the first simplex. Parameters with one value alone stay where they are.
SearchBox search_box(const std::vector<TuningParameter>& parameters) {
  SearchBox box;
  for (const TuningParameter& p : parameters) {
    if (p.values.size() < 2) continue;
    box.lower.push_back(p.values.front());
    box.upper.push_back(p.values.back());
    const double intervals = static_cast<double>(p.values.size() - 1);
    box.step.push_back(0.5 * (p.values.back() - p.values.front()) / intervals);
  }
  return box;
}

class Search {
 public:
  Search(const Tuning& tuning, TuningFlights& flights, TuningResult& result)
      : tuning_(tuning), flights_(flights), result_(result) {}

  void fly_grid() {
    Progress progress("grid");
    result_.evaluations = flights_.fly(grid_points(tuning_.parameters), result_.baseline,
                                       [&](double done) { progress.update(done); });
    result_.grid = result_.evaluations.size();
    flights_.check();
    progress.finish();
  }

  void refine() {
    const std::size_t best = best_of(result_.evaluations, tuning_.targets);
    const SearchBox box = search_box(tuning_.parameters);
    if (best == result_.evaluations.size() || box.step.empty() || tuning_.refinements == 0) return;
    const Evaluation start = result_.evaluations[best];
    Progress progress("refinement");
    simplex_search(free_part(start.values), start.score(tuning_.targets), box, tuning_.refinements,
                   kSmallestSimplex, [&](const std::vector<Point>& points) {
                     const std::vector<Score> scores = scores_of(points, start.values);
                     progress.update(std::min(
                         1.0, static_cast<double>(result_.evaluations.size() - result_.grid) /
                                  tuning_.refinements));
                     return scores;
                   });
    progress.finish();
  }

 private:
  bool is_free(std::size_t i) const { return tuning_.parameters[i].values.size() > 1; }

  Point free_part(const Point& all) const {
    Point part;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (is_free(i)) part.push_back(all[i]);
    return part;
  }

  Point complete(const Point& part, Point all) const {
    std::size_t next = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (is_free(i)) all[i] = part[next++];
    std::ranges::transform(all, all.begin(), four_digits);
    return all;
  }

  const Evaluation* known(const Point& values) const {
    const auto found = std::ranges::find(result_.evaluations, values, &Evaluation::values);
    return found == result_.evaluations.end() ? nullptr : &*found;
  }

  std::vector<Score> scores_of(const std::vector<Point>& parts, const Point& fixed) {
    std::vector<Point> fresh;
    for (const Point& part : parts) {
      const Point p = complete(part, fixed);
      if (!known(p) && std::ranges::find(fresh, p) == fresh.end()) fresh.push_back(p);
    }
    for (Evaluation& e : flights_.fly(fresh, result_.baseline, [](double) {}))
      result_.evaluations.push_back(std::move(e));
    flights_.check();
    std::vector<Score> scores;
    for (const Point& part : parts)
      scores.push_back(known(complete(part, fixed))->score(tuning_.targets));
    return scores;
  }

  const Tuning& tuning_;
  TuningFlights& flights_;
  TuningResult& result_;
};

void make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw Error(folder.string() + ": cannot be made: " + failed.message());
}

void write(const fs::path& path, const std::string& text, std::ostream& out) {
  write_whole_file(path, text);
  out << "wrote " << path.string() << '\n';
}

/// Whoever finds an input file there afterwards takes it for the result.
void remove_result_of_before(const fs::path& path, std::ostream& out) {
  std::error_code failed;
  if (fs::remove(path, failed)) out << "removed " << path.string() << " of an earlier tuning\n";
  if (failed) throw Error(path.string() + ": cannot be removed: " + failed.message());
}

}  // namespace

std::vector<Point> grid_points(const std::vector<TuningParameter>& parameters) {
  std::vector<Point> points{{}};
  for (const TuningParameter& parameter : parameters) {
    std::vector<Point> longer;
    for (const Point& p : points) {
      for (const double value : parameter.values) {
        longer.push_back(p);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
    if (points.size() > kMostGridPoints) throw Error("parameters: more than 100000 combinations");
  }
  return points;
}

bool run_tuning(const TuningOptions& o, std::ostream& out) {
  const Tuning tuning = load_tuning(o.file, o.overrides);
  const fs::path folder =
      o.output_folder.empty() ? fs::path("results") / tuning.name : o.output_folder;
  const Interruption interruption;
  const TemporaryFolder work;
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  TuningFlights flights(tuning, work.path(), o.jobs > 0 ? o.jobs : cores, interruption);
  const fs::path written = folder / flights.input_file().filename();
  require_other_file(written, flights.input_file(), "what is tuned");
  make_folder(folder);
  remove_result_of_before(written, out);

  TuningResult result{.tuning = tuning, .baseline = {}};
  const auto write_evaluations = [&] {
    write(folder / "evaluations.csv", evaluations_csv(result), out);
  };
  try {
    result.baseline = flights.fly_baseline();
    Search search(tuning, flights, result);
    search.fly_grid();
    search.refine();
  } catch (const Error&) {
    write_evaluations();
    throw;
  }
  out << tuning_text(result);
  write_evaluations();
  const std::size_t best = best_of(result.evaluations, tuning.targets);
  if (best == result.evaluations.size() || !result.evaluations[best].meets_conditions())
    return false;
  write(written, origin_comment(result, best) + flights.input_text(result.evaluations[best].values),
        out);
  return true;
}

}  // namespace lac::sim
