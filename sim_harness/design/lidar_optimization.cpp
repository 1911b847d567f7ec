// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/lidar_optimization.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlopt.hpp>

#include "core/error.hpp"
#include "sim_harness/wind/parallel_jobs.hpp"

namespace lac::sim {
namespace {

constexpr double kTolerance = 1e-4;  // of the free numbers, over their range
constexpr int kMostSteps = 300;
constexpr double kFirstStep = 0.05;

/// A free number of a layout, 0 to 1 over its range.
struct FreeNumber {
  double LidarLayout::*place;
  Interval range;
};

std::vector<FreeNumber> free_numbers(const OptimizeSettings& s) {
  std::vector<FreeNumber> all{{&LidarLayout::azimuth_rad, s.azimuth_rad},
                              {&LidarLayout::elevation_rad, s.elevation_rad},
                              {&LidarLayout::first_gate_m, s.first_gate_m},
                              {&LidarLayout::last_gate_m, s.last_gate_m}};
  std::erase_if(all, [](const FreeNumber& n) { return !n.range.is_free(); });
  return all;
}

std::vector<double> grid_of(const Interval& range, int points) {
  if (!range.is_free()) return {range.low};
  std::vector<double> values;
  for (int i = 0; i < points; ++i)
    values.push_back(std::lerp(range.low, range.high, static_cast<double>(i) / (points - 1)));
  return values;
}

LayoutMap map_of(const LayoutJudge& judge, const OptimizeSettings& s, LidarLayout layout,
                 int threads) {
  LayoutMap map{grid_of(s.azimuth_rad, s.grid), grid_of(s.elevation_rad, s.grid), {}};
  const std::size_t columns = map.azimuth_rad.size();
  map.figures.resize(columns * map.elevation_rad.size());
  for_each_job(static_cast<int>(map.figures.size()), threads, [&] {
    return [&, layout](int job) mutable {
      const auto i = static_cast<std::size_t>(job);
      layout.azimuth_rad = map.azimuth_rad[i % columns];
      layout.elevation_rad = map.elevation_rad[i / columns];
      map.figures[i] = judge.figures(layout);
    };
  });
  return map;
}

/// A text about `optimize` of the design file.
Error optimize_error(const DesignCase& design, const std::string& text) {
  return Error(design.file.string() + ": optimize: " + text);
}

/// The best point of a map that is allowed.
LidarLayout best_of(const DesignCase& design, const LayoutMap& map, LidarLayout layout) {
  const LayoutFigures* best = nullptr;
  for (const LayoutFigures& f : map.figures)
    if (f.is_allowed() && f.k05_radpm > 0.0 && (!best || f.k05_radpm > best->k05_radpm)) best = &f;
  if (!best) {
    throw optimize_error(design,
                         "no layout with " + std::to_string(layout.beams) +
                             " beams on the grid of azimuth_deg and elevation_deg keeps the "
                             "constraints and is coherent to a half anywhere; expected wider "
                             "ranges, or gates farther away");
  }
  const auto i = static_cast<std::size_t>(best - map.figures.data());
  layout.azimuth_rad = map.azimuth_rad[i % map.azimuth_rad.size()];
  layout.elevation_rad = map.elevation_rad[i / map.azimuth_rad.size()];
  return layout;
}

/// The search as NLopt calls it: numbers from 0 to 1, the last layout remembered, as objective and
/// constraints ask for the same one.
class Search {
 public:
  Search(const LayoutJudge& judge, const OptimizeSettings& settings, LidarLayout start)
      : judge_(judge), free_(free_numbers(settings)), layout_(start) {}

  LidarLayout run() {
    nlopt::opt search(nlopt::LN_COBYLA, static_cast<unsigned>(free_.size()));
    search.set_lower_bounds(0.0);
    search.set_upper_bounds(1.0);
    search.set_max_objective(&Search::objective, this);
    const std::vector<double> slack(3, 0.0);
    search.add_inequality_mconstraint(&Search::constraints, this, slack);
    search.set_xtol_abs(kTolerance);
    search.set_maxeval(kMostSteps);
    search.set_initial_step(kFirstStep);
    std::vector<double> x = position(layout_);
    best_ = layout_, best_figures_ = judge_.figures(layout_);
    double ignored = 0.0;
    try {
      search.optimize(x, ignored);
    } catch (const nlopt::roundoff_limited&) {
      // It ends where rounding stops it; the best layout until then counts.
    } catch (const nlopt::forced_stop&) {
      // The judge has thrown.
    }
    if (failure_) std::rethrow_exception(failure_);
    return best_;
  }
  int judged() const { return judged_; }
  const LayoutFigures& figures() const { return best_figures_; }

 private:
  std::vector<double> position(const LidarLayout& layout) const {
    std::vector<double> x;
    for (const FreeNumber& n : free_)
      x.push_back((layout.*n.place - n.range.low) / (n.range.high - n.range.low));
    return x;
  }

  const LayoutFigures& judge_at(unsigned n, const double* x) {
    const std::vector<double> at(x, x + n);
    if (at == last_) return figures_;
    for (unsigned i = 0; i < n; ++i) {
      const Interval& r = free_[i].range;
      layout_.*free_[i].place = std::clamp(std::lerp(r.low, r.high, x[i]), r.low, r.high);
    }
    figures_ = judged_figures();
    last_ = at;
    ++judged_;
    if (figures_.is_allowed() && figures_.k05_radpm > best_figures_.k05_radpm)
      best_ = layout_, best_figures_ = figures_;
    return figures_;
  }

  /// NLopt would make an error its own, without a text.
  LayoutFigures judged_figures() {
    try {
      return judge_.figures(layout_);
    } catch (...) {
      if (!failure_) failure_ = std::current_exception();
      throw nlopt::forced_stop();
    }
  }

  static double objective(unsigned n, const double* x, double* /*gradient*/, void* self) {
    return 100.0 * static_cast<Search*>(self)->judge_at(n, x).k05_radpm;
  }
  static void constraints(unsigned /*m*/, double* result, unsigned n, const double* x,
                          double* /*gradient*/, void* self) {
    const LayoutFigures& f = static_cast<Search*>(self)->judge_at(n, x);
    result[0] = -f.lead_margin_s, result[1] = -f.angle_margin_rad;
    result[2] = -0.01 * f.height_margin_m;
  }

  const LayoutJudge& judge_;
  std::vector<FreeNumber> free_;
  LidarLayout layout_, best_;
  LayoutFigures figures_, best_figures_;
  std::vector<double> last_;
  std::exception_ptr failure_;
  int judged_ = 0;
};

OptimizedLidar optimize_beams(const DesignCase& design, const LayoutJudge& judge,
                              const OptimizeSettings& s, int beams) {
  const int threads = design.curves.threads;
  const LidarLayout start{beams,
                          s.azimuth_rad.middle(),
                          s.elevation_rad.middle(),
                          s.lead_at_mps ? s.first_gate_m.high : s.first_gate_m.low,
                          s.last_gate_m.middle(),
                          s.gates};
  OptimizedLidar r;
  r.map = map_of(judge, s, start, threads);
  r.best_of_grid = best_of(design, r.map, start);
  r.grid_figures = judge.figures(r.best_of_grid);
  Search search(judge, s, r.best_of_grid);
  r.best = search.run(), r.figures = search.figures();
  r.judged = search.judged() + static_cast<int>(r.map.figures.size());
  if (s.first_gate_m.is_free() || s.last_gate_m.is_free())
    r.map = map_of(judge, s, r.best, threads);
  return r;
}

/// What a layout takes from the lidar of the design has to be there.
void check_lidar(const DesignCase& design) {
  try {
    with_layout(design.lidar, {});
  } catch (const Error& e) {
    throw Error(design.file.string() + ": lidar: " + e.what());
  }
}

}  // namespace

std::vector<OptimizedLidar> optimize_lidar(const DesignCase& design,
                                           const OptimizeSettings& settings) {
  if (free_numbers(settings).empty())
    throw optimize_error(design,
                         "nothing is free, expected [from, to] for one of azimuth_deg, "
                         "elevation_deg, first_gate_m, last_gate_m");
  check_lidar(design);
  const LayoutJudge judge(design, settings);
  std::vector<OptimizedLidar> all;
  for (const int beams : settings.beams)
    all.push_back(optimize_beams(design, judge, settings, beams));
  return all;
}

}  // namespace lac::sim
