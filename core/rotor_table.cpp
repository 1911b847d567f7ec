// SPDX-License-Identifier: Apache-2.0
#include "core/rotor_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/error.hpp"

namespace lac {

namespace {

bool evenly_spaced(const std::vector<double>& x) {
  const double step = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (std::abs(x[i] - x.front() - static_cast<double>(i) * step) > 1e-9 * step) return false;
  }
  return true;
}

void require_rising(const std::vector<double>& x, const char* name) {
  if (x.size() < 2) {
    throw Error(std::string("rotor table: the ") + name + " vector has " +
                std::to_string(x.size()) + " entries; expected 2 or more");
  }
  const auto fall = std::adjacent_find(x.begin(), x.end(), std::greater_equal<>());
  if (fall != x.end()) {
    throw Error(std::string("rotor table: the ") + name + " vector does not rise: " +
                std::to_string(fall[1]) + " after " + std::to_string(fall[0]));
  }
}

}  // namespace

RotorTable::Axis::Axis(std::vector<double> rising_points)
    : points(std::move(rising_points)),
      uniform(evenly_spaced(points)),
      points_per_unit(static_cast<double>(points.size() - 1) / (points.back() - points.front())) {}

RotorTable::Place RotorTable::Axis::locate(double value) const noexcept {
  const std::size_t last = points.size() - 2;
  if (value <= points.front()) return {0, 0.0};
  if (value >= points.back()) return {last, 1.0};
  if (std::isnan(value)) return {0, value};
  if (uniform) {
    const double position = (value - points.front()) * points_per_unit;
    const std::size_t i = std::min(static_cast<std::size_t>(position), last);
    return {i, position - static_cast<double>(i)};
  }
  const auto upper = std::upper_bound(points.begin(), points.end(), value);
  const auto i = static_cast<std::size_t>(upper - points.begin()) - 1;
  return {i, (value - points[i]) / (points[i + 1] - points[i])};
}

double RotorTable::Axis::clamp(double value) const noexcept {
  return std::clamp(value, points.front(), points.back());
}

double RotorTable::Axis::step(double value) const noexcept {
  const std::size_t i = locate(value).interval;
  return points[i + 1] - points[i];
}

RotorTable::RotorTable(std::vector<double> tsr, std::vector<double> pitch_rad,
                       const std::vector<double>& cp, const std::vector<double>& ct)
    : tsr_((require_rising(tsr, "TSR"), std::move(tsr))),
      pitch_((require_rising(pitch_rad, "pitch"), std::move(pitch_rad))) {
  const std::size_t size = tsr_.points.size() * pitch_.points.size();
  if (cp.size() != size || ct.size() != size) {
    throw Error("rotor table: " + std::to_string(cp.size()) + " power and " +
                std::to_string(ct.size()) + " thrust coefficients; expected " +
                std::to_string(tsr_.points.size()) + " x " + std::to_string(pitch_.points.size()));
  }
  nodes_.reserve(size);
  for (std::size_t i = 0; i < size; ++i) nodes_.push_back({cp[i], ct[i]});
}

RotorTable::Coefficients RotorTable::at(double tsr, double pitch_rad) const noexcept {
  const Place row = tsr_.locate(tsr);
  const Place column = pitch_.locate(pitch_rad);
  const std::size_t width = pitch_.points.size();
  const Coefficients* low = &nodes_[row.interval * width + column.interval];
  const Coefficients* high = low + width;
  const double w11 = row.weight * column.weight;
  const double w10 = row.weight - w11;
  const double w01 = column.weight - w11;
  const double w00 = 1.0 - row.weight - w01;
  return {w00 * low[0].cp + w01 * low[1].cp + w10 * high[0].cp + w11 * high[1].cp,
          w00 * low[0].ct + w01 * low[1].ct + w10 * high[0].ct + w11 * high[1].ct};
}

double RotorTable::dcp_dtsr(double tsr, double pitch_rad) const noexcept {
  const double step = tsr_.step(tsr);
  const double low = tsr_.clamp(tsr_.clamp(tsr) - step);
  const double high = tsr_.clamp(tsr_.clamp(tsr) + step);
  return (cp(high, pitch_rad) - cp(low, pitch_rad)) / (high - low);
}

double RotorTable::dcp_dpitch_per_rad(double tsr, double pitch_rad) const noexcept {
  const double step = pitch_.step(pitch_rad);
  const double low = pitch_.clamp(pitch_.clamp(pitch_rad) - step);
  const double high = pitch_.clamp(pitch_.clamp(pitch_rad) + step);
  return (cp(tsr, high) - cp(tsr, low)) / (high - low);
}

bool RotorTable::inside(double tsr, double pitch_rad) const noexcept {
  return tsr >= tsr_.points.front() && tsr <= tsr_.points.back() &&
         pitch_rad >= pitch_.points.front() && pitch_rad <= pitch_.points.back();
}

RotorTable::Optimum RotorTable::optimum(double min_pitch_rad) const noexcept {
  const std::vector<double>& rows = tsr_.points;
  std::size_t best_row = 0;
  double best_pitch_rad = pitch_.clamp(min_pitch_rad);
  const auto try_pitch = [&](double pitch_rad) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (cp(rows[i], pitch_rad) > cp(rows[best_row], best_pitch_rad)) {
        best_row = i;
        best_pitch_rad = pitch_rad;
      }
    }
  };
  try_pitch(best_pitch_rad);
  for (const double pitch_rad : pitch_.points) {
    if (pitch_rad > min_pitch_rad) try_pitch(pitch_rad);
  }
  Optimum best{rows[best_row], best_pitch_rad, cp(rows[best_row], best_pitch_rad)};
  if (best_row == 0 || best_row + 1 == rows.size()) return best;

  // Newton's form of the parabola: slopes of the two chords, then their change.
  const double left = rows[best_row] - rows[best_row - 1];
  const double right = rows[best_row + 1] - rows[best_row];
  const double slope_left = (best.cp - cp(rows[best_row - 1], best_pitch_rad)) / left;
  const double slope_right = (cp(rows[best_row + 1], best_pitch_rad) - best.cp) / right;
  const double curvature = (slope_right - slope_left) / (left + right);
  if (curvature >= 0.0) return best;
  const double slope = slope_left + curvature * left;
  best.tsr -= 0.5 * slope / curvature;
  best.cp -= 0.25 * slope * slope / curvature;
  return best;
}

}  // namespace lac
