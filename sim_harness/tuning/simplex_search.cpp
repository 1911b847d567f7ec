// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/simplex_search.hpp"

#include <algorithm>
#include <numeric>

namespace lac::sim {
namespace {

struct Vertex {
  Point at;
  Score score;
};

class Simplex {
 public:
  Simplex(const SearchBox& box, int evaluations, const EvaluatePoints& evaluate)
      : box_(box), left_(evaluations), evaluate_(evaluate) {}

  void begin(const Point& start, Score score) {
    std::vector<Point> others;
    for (std::size_t i = 0; i < start.size(); ++i) {
      others.push_back(start);
      const bool fits = start[i] + box_.step[i] <= box_.upper[i];
      others.back()[i] += fits ? box_.step[i] : -box_.step[i];
    }
    vertices_.push_back({start, score});
    add(others);
  }

  bool goes_on(double tolerance) const {
    if (left_ <= 0) return false;
    for (std::size_t i = 0; i < box_.step.size(); ++i) {
      const auto along = [i](const Vertex& a, const Vertex& b) { return a.at[i] < b.at[i]; };
      const auto [least, most] = std::ranges::minmax_element(vertices_, along);
      if (most->at[i] - least->at[i] > tolerance * box_.step[i]) return true;
    }
    return false;
  }

  void step() {
    sort();
    const Score worst = vertices_.back().score;
    const Vertex reflected = tried(1.0);
    if (reflected.score < vertices_.front().score) {
      const Vertex expanded = tried(2.0);
      replace_worst(expanded.score < reflected.score ? expanded : reflected);
    } else if (reflected.score < vertices_[vertices_.size() - 2].score) {
      replace_worst(reflected);
    } else {
      const bool outside = reflected.score < worst;
      const Vertex contracted = tried(outside ? 0.5 : -0.5);
      if (contracted.score < (outside ? reflected.score : worst))
        replace_worst(contracted);
      else
        shrink();
    }
    sort();
  }

  const Point& best() const { return std::ranges::min_element(vertices_, by_score)->at; }

 private:
  static bool by_score(const Vertex& a, const Vertex& b) { return a.score < b.score; }
  void sort() { std::ranges::stable_sort(vertices_, by_score); }
  void replace_worst(const Vertex& v) { vertices_.back() = v; }

  void add(const std::vector<Point>& points) {
    const std::vector<Score> scores = evaluate_(points);
    left_ -= static_cast<int>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) vertices_.push_back({points[i], scores[i]});
  }

  /// From the centre of all but the worst, away from the worst.
  Vertex tried(double factor) {
    const Point& worst = vertices_.back().at;
    Point p(worst.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      double centre = 0.0;
      for (std::size_t k = 0; k + 1 < vertices_.size(); ++k) centre += vertices_[k].at[i];
      centre /= static_cast<double>(vertices_.size() - 1);
      p[i] = std::clamp(centre + factor * (centre - worst[i]), box_.lower[i], box_.upper[i]);
    }
    --left_;
    return {p, evaluate_({p}).front()};
  }

  void shrink() {
    std::vector<Point> nearer;
    for (std::size_t k = 1; k < vertices_.size(); ++k) {
      nearer.push_back(vertices_[k].at);
      for (std::size_t i = 0; i < nearer.back().size(); ++i)
        nearer.back()[i] = std::midpoint(vertices_[0].at[i], nearer.back()[i]);
    }
    vertices_.resize(1);
    add(nearer);
  }

  const SearchBox& box_;
  int left_;
  const EvaluatePoints& evaluate_;
  std::vector<Vertex> vertices_;
};

}  // namespace

Point simplex_search(const Point& start, Score start_score, const SearchBox& box, int evaluations,
                     double tolerance, const EvaluatePoints& evaluate) {
  Simplex simplex(box, evaluations, evaluate);
  simplex.begin(start, start_score);
  while (simplex.goes_on(tolerance)) simplex.step();
  return simplex.best();
}

}  // namespace lac::sim
