// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/ti_estimator.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lac {
namespace {

constexpr double kCosOfTwoDegrees = 0.99939;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Where a sample comes from: the beam in frame I, and along the mean wind.
struct View {
  Vec3 beam_I;
  double along_wind;  // -n_x
};

View view_of(const LidarMeasurement& m, const TiEstimatorParams& p, double yaw_error_rad) {
  const bool moving = p.motion_compensation;
  const double roll = moving ? m.roll_rad : 0.0, pitch = moving ? m.pitch_rad : 0.0;
  const double yaw = moving ? m.yaw_rad : kPi;
  const Vec3 beam_I = rotation_from_roll_pitch_yaw(roll, pitch, yaw) * m.beam_dir_L;
  if (!p.use_yaw_error) return {beam_I, -beam_I.x};
  // Seen from the wind, the nacelle is turned by minus the yaw error, wherever x of I points.
  const Vec3 beam_W = rotation_from_roll_pitch_yaw(roll, pitch, kPi - yaw_error_rad) * m.beam_dir_L;
  return {beam_I, -beam_W.x};
}

TiEstimatorParams with_weights(TiEstimatorParams p) {
  p.gate_weights.resize(static_cast<std::size_t>(p.number_of_gates), 1.0);
  return p;
}

/// Sampled every whole number of steps.
SignalIntensityParams paced(SignalIntensityParams p, double time_step_s) {
  constexpr double kRounding = 1e-6;
  p.statistics.scan_time_s =
      time_step_s * std::ceil(p.statistics.scan_time_s / time_step_s - kRounding);
  return p;
}

/// With sigma_u over sigma_REWS.
SignalIntensityParams turbine_params(const TiEstimatorParams& p) {
  SignalIntensityParams turbine = p.turbine;
  if (!turbine.used) return turbine;
  const Correction correction(p.correction);
  std::vector<double> factors;
  for (const double speed_mps : p.table_speeds_mps) {
    factors.push_back(
        std::sqrt(correction.u_variance(speed_mps) /
                  correction.rews_variance(speed_mps, p.rotor_radius_m, p.turbine_cutoff_hz)));
  }
  turbine.correction = LookupTable(p.table_speeds_mps, factors);
  return turbine;
}

}  // namespace

TiEstimator::TiEstimator(TiEstimatorParams params, double time_step_s)
    : params_(with_weights(std::move(params))),
      time_step_s_(time_step_s),
      table_(Correction(params_.correction), params_.beam_dir_L, params_.table_speeds_mps,
             params_.table_yaw_errors_rad),
      anemometer_(paced(params_.anemometer, time_step_s)),
      turbine_(paced(turbine_params(params_), time_step_s)) {}

TiEstimator::State TiEstimator::initial_state() const {
  State s;
  s.window = SpeedStatistics(params_.statistics());
  s.beams.resize(params_.beam_dir_L.size());
  s.anemometer = anemometer_.initial_state();
  s.turbine = turbine_.initial_state();
  return s;
}

TiEstimator::Outputs TiEstimator::step(const Inputs& in, State& state) const noexcept {
  if (params_.use_yaw_error && std::isfinite(in.yaw_error_rad)) {
    state.yaw_error_rad.add(in.yaw_error_rad, time_step_s_, params_.averaging_time_s);
  }
  Outputs out;
  const int left = state.window.expire(in.time_s);
  if (left >= 0) update_beam(left, in.time_s, state);
  if (in.measurement != nullptr) take_in(*in.measurement, in.time_s, state, out);
  const bool news = left >= 0 || in.measurement != nullptr;
  if (news) update_estimate(in, state);
  out.estimates = estimates(in, state);
  const IntensitySource source = params_.power_level_source;
  if (news || source == IntensitySource::Anemometer || source == IntensitySource::Turbine) {
    const IntensityEstimate& e = out.estimates[static_cast<std::size_t>(source)];
    state.power_level.set_intensity(e.intensity, e.mean_speed_mps, params_.power_level);
  }
  state.power_level.step(params_.power_level.rate_1ps, time_step_s_);

  out.intensity = state.intensity;
  out.mean_speed_mps = state.mean_speed_mps;
  out.filled_series = state.filled_series;
  out.outside_table = state.outside_table;
  out.ldp_missing = state.ldp_missing;
  out.power_level = state.power_level.level();
  out.power_level_valid = state.power_level.valid();
  return out;
}

void TiEstimator::take_in(const LidarMeasurement& m, double time_s, State& state,
                          Outputs& out) const noexcept {
  const View view = view_of(m, params_, state.yaw_error_rad.mean());
  const double own_mps = params_.motion_compensation ? dot(view.beam_I, m.velocity_I_mps) : 0.0;
  std::array<std::int32_t, native_lidar::kMaxGates> row;
  row.fill(SampleWindow::kNone);
  const int gates = std::min(m.gate_count, params_.number_of_gates);
  for (int g = 0; g < gates; ++g) {
    const LidarGate& gate = m.gates[static_cast<std::size_t>(g)];
    const double u_mps = (gate.speed_mps - own_mps) / view.along_wind;
    if (gate.valid && view.along_wind > kSmallestProjection && RunningMoments::fits(u_mps)) {
      row[static_cast<std::size_t>(g)] = RunningMoments::quantise(u_mps);
    }
  }
  out.too_many_gates = m.gate_count > params_.number_of_gates;
  out.other_direction = is_other_direction(m);
  out.no_room = !state.window.add(time_s, m.beam_id, row);
  update_beam(m.beam_id, time_s, state);
}

bool TiEstimator::is_other_direction(const LidarMeasurement& m) const noexcept {
  const double cosine = dot(m.beam_dir_L, params_.beam_dir_L[static_cast<std::size_t>(m.beam_id)]);
  return !(std::abs(cosine - 1.0) < 1.0 - kCosOfTwoDegrees);
}

void TiEstimator::update_beam(int beam, double time_s, State& state) const noexcept {
  State::Beam sums;
  for (int g = 0; g < params_.number_of_gates; ++g) {
    const SpeedStatistics::Series series = state.window.series(beam, g, time_s);
    if (!series.filled) continue;
    const double weight = params_.gate_weights[static_cast<std::size_t>(g)];
    sums.sum_of_std_mps += weight * series.standard_deviation_mps;
    sums.sum_of_mean_mps += weight * series.mean_mps;
    sums.sum_of_weights += weight;
    ++sums.filled;
  }
  state.beams[static_cast<std::size_t>(beam)] = sums;
}

void TiEstimator::update_estimate(const Inputs& in, State& state) const noexcept {
  double mean_mps = 0.0, weights = 0.0;
  int filled = 0;
  for (const State::Beam& beam : state.beams) {
    mean_mps += beam.sum_of_mean_mps;
    weights += beam.sum_of_weights;
    filled += beam.filled;
  }
  state.intensity = state.mean_speed_mps = state.uncorrected = kNaN;
  state.filled_series = filled;
  if (filled == 0 || !state.window.has_lasted(in.time_s)) return;

  mean_mps = params_.mean_speed_of_ldp ? in.ldp_mean_speed_mps : mean_mps / weights;
  state.ldp_missing =
      !std::isfinite(mean_mps) || (params_.use_yaw_error && !state.yaw_error_rad.started());
  if (state.ldp_missing) {
    state.outside_table = false;
    return;
  }
  const double yaw_error_rad = state.yaw_error_rad.mean();
  state.mean_speed_mps = mean_mps;
  state.outside_table = !table_.covers(mean_mps, yaw_error_rad);
  if (state.outside_table) return;
  const CorrectionTable::Place place = table_.find(mean_mps, yaw_error_rad);
  double sigma_mps = 0.0, uncorrected_mps = 0.0;
  for (std::size_t b = 0; b < state.beams.size(); ++b) {
    sigma_mps += table_.at(b, place) * state.beams[b].sum_of_std_mps;
    uncorrected_mps += state.beams[b].sum_of_std_mps;
  }
  state.intensity = sigma_mps / weights / mean_mps;
  state.uncorrected = uncorrected_mps / weights / mean_mps;
}

TiEstimator::Estimates TiEstimator::estimates(const Inputs& in, State& state) const noexcept {
  return {{{state.intensity, state.mean_speed_mps},
           {state.uncorrected, state.mean_speed_mps},
           anemometer_.step(in.anemometer_mps, in.time_s, state.anemometer),
           turbine_.step(in.turbine_rews_mps, in.time_s, state.turbine)}};
}

}  // namespace lac
