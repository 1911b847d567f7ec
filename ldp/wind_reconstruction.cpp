// SPDX-License-Identifier: Apache-2.0
#include "ldp/wind_reconstruction.hpp"

#include <algorithm>
#include <cmath>

#include "ldp/symmetric_eigen.hpp"

namespace lac {
namespace {

enum ColumnOf : std::size_t { kU, kV, kW, kUy, kUz, kUx };

constexpr double kUnknownShare = 0.01;  // of the square of a quantity in what cannot be told
constexpr double kStaleShare = 0.1;     // of the window
constexpr double kSolutions = 100.0;    // per window

/// The quantities a model asks for, u first.
struct Asked {
  std::array<std::size_t, 5> columns{};
  std::size_t count = 0;
};

Asked asked(WindModel model) {
  switch (model) {
    case WindModel::U:
      return {{kU}, 1};
    case WindModel::UShear:
      return {{kU, kUy, kUz}, 3};
    case WindModel::UV:
      return {{kU, kV}, 2};
    case WindModel::UVW:
      return {{kU, kV, kW}, 3};
    case WindModel::All:
      break;
  }
  return {{kU, kV, kW, kUy, kUz}, 5};
}

double known(double value) {
  return std::isnan(value) ? 0.0 : value;
}

struct Problem {
  WindReconstruction::Matrix normal{};
  WindReconstruction::Column right{};
};

/// The asked-for part of the normal equations, u_x eliminated (Schur complement) where the
/// geometry shows it at all. u_x counts from the mean place of the samples, which makes it
/// independent of u.
Problem reduced(const WindReconstruction::State& s, const Asked& a, double largest_condition) {
  const auto entry = [&s](std::size_t i, std::size_t j) {
    return i <= j ? s.normal[i][j] : s.normal[j][i];
  };
  const double uu = entry(kU, kU);
  const double mean_x = entry(kU, kUx) / uu;
  const double xx = entry(kUx, kUx) - mean_x * entry(kU, kUx);
  const bool shows = xx > uu / (largest_condition * largest_condition);
  const double right_x = s.right[kUx] - mean_x * s.right[kU];
  WindReconstruction::Column along{};
  for (std::size_t i = 0; i < a.count; ++i) {
    along[i] = entry(a.columns[i], kUx) - mean_x * entry(a.columns[i], kU);
  }
  Problem p;
  for (std::size_t i = 0; i < a.count; ++i) {
    const double share = shows ? along[i] / xx : 0.0;
    p.right[i] = s.right[a.columns[i]] - share * right_x;
    for (std::size_t j = 0; j < a.count; ++j) {
      p.normal[i][j] = entry(a.columns[i], a.columns[j]) - share * along[j];
    }
  }
  return p;
}

/// Not a number without what they are made of.
void set_angles(WindReconstruction::State& s) {
  WindReconstruction::Estimate& e = s.estimate;
  e.yaw_error_rad = std::atan2(e.v_mps, e.u_mps) - s.heading_rad;
  e.inflow_angle_rad = std::atan2(e.w_mps, std::hypot(e.u_mps, known(e.v_mps)));
}

}  // namespace

WindReconstruction::State WindReconstruction::initial_state() const {
  State s;
  s.estimate.reason = active() ? WindReason::Settling : WindReason::Off;
  return s;
}

void WindReconstruction::add(const Sample& sample, Sums& sums) const noexcept {
  const Vec3& n = sample.beam_dir_I;
  const double scale = 1.0 / params_.rotor_radius_m;
  const double along = -n.x * sample.induction;
  const Column row{along,
                   -n.y,
                   -n.z,
                   along * sample.from_hub_I_m.y * scale,
                   along * sample.from_hub_I_m.z * scale,
                   along * sample.from_hub_I_m.x * scale};
  for (std::size_t i = 0; i < kColumns; ++i) {
    const double weighted = sample.weight * row[i];
    for (std::size_t j = i; j < kColumns; ++j) sums.normal[i][j] += weighted * row[j];
    sums.right[i] += weighted * sample.los_mps;
  }
  sums.weight += sample.weight;
}

void WindReconstruction::add(const Sums& sums, const Measurement& m, State& s) const noexcept {
  if (!(sums.weight > 0.0)) return;
  if (s.elapsed_s > 0.0 && m.time_s - s.last_s > params_.window_s) s = initial_state();
  s.last_s = m.time_s;
  s.elapsed_s = std::min(s.elapsed_s + m.share_s, params_.window_s);
  const double share = std::min(1.0, m.share_s / s.elapsed_s);
  for (std::size_t i = 0; i < kColumns; ++i) {
    for (std::size_t j = i; j < kColumns; ++j) {
      s.normal[i][j] += share * (sums.normal[i][j] - s.normal[i][j]);
    }
    s.right[i] += share * (sums.right[i] - s.right[i]);
  }
  s.heading_rad += share * (m.heading_rad - s.heading_rad);
  s.since_solved_s += m.share_s;
  const double every_s = std::max(m.scan_time_s, params_.window_s / kSolutions);
  if (s.elapsed_s < params_.window_s || s.since_solved_s < every_s) return;
  s.since_solved_s = 0.0;
  solve(s);
}

void WindReconstruction::solve(State& s) const noexcept {
  using Eigen = SymmetricEigen<kColumns>;
  const Asked a = asked(params_.model);
  s.estimate = Estimate{};
  s.estimate.reason = WindReason::Refused;
  s.estimate.condition = std::numeric_limits<double>::infinity();
  if (!(s.normal[kU][kU] > 0.0)) return;
  const Problem p = reduced(s, a, params_.largest_condition);
  const Eigen eigen = Eigen::of(p.normal, a.count);
  const auto last = eigen.values.begin() + static_cast<std::ptrdiff_t>(a.count);
  const double greatest = *std::max_element(eigen.values.begin(), last);
  const double least = *std::min_element(eigen.values.begin(), last);
  if (least > 0.0) s.estimate.condition = std::sqrt(greatest / least);

  const double limit = greatest / (params_.largest_condition * params_.largest_condition);
  Column solution{}, unknown{};
  for (std::size_t k = 0; k < a.count; ++k) {
    const bool told = eigen.values[k] >= limit;
    double along = 0.0;
    for (std::size_t i = 0; i < a.count; ++i) along += eigen.vectors[i][k] * p.right[i];
    for (std::size_t i = 0; i < a.count; ++i) {
      const double v = eigen.vectors[i][k];
      if (told) solution[i] += v * along / eigen.values[k];
      if (!told) unknown[i] += v * v;
    }
  }
  const std::array<double*, 5> out{&s.estimate.u_mps, &s.estimate.v_mps, &s.estimate.w_mps,
                                   &s.estimate.du_dy_per_s, &s.estimate.du_dz_per_s};
  std::size_t there = 0;
  for (std::size_t i = 0; i < a.count; ++i) {
    if (unknown[i] >= kUnknownShare) continue;
    const double length_m = a.columns[i] >= kUy ? params_.rotor_radius_m : 1.0;
    *out[a.columns[i]] = solution[i] / length_m;
    if (i > 0) ++there;  // u alone needs no model
  }
  set_angles(s);
  if (there > 0) s.estimate.reason = WindReason::Partly;
  if (there + 1 == a.count && !std::isnan(s.estimate.u_mps)) {
    s.estimate.reason = WindReason::Complete;
  }
}

void WindReconstruction::watch(double time_s, double scan_time_s, State& s) const noexcept {
  if (s.estimate.reason == WindReason::Settling || s.estimate.reason == WindReason::Stale) return;
  if (time_s - s.last_s <= std::max(kStaleShare * params_.window_s, 2.0 * scan_time_s)) return;
  s.estimate = Estimate{};
  s.estimate.reason = WindReason::Stale;
}

double WindReconstruction::axial_mps(const Sample& s, const Estimate& e) noexcept {
  const Vec3& n = s.beam_dir_I;
  const double across_mps = n.y * known(e.v_mps) + n.z * known(e.w_mps);
  const double there_mps = (s.los_mps + across_mps) / (-n.x * s.induction);
  return there_mps - known(e.du_dy_per_s) * s.from_hub_I_m.y -
         known(e.du_dz_per_s) * s.from_hub_I_m.z;
}

}  // namespace lac
