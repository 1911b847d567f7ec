// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/uniform_wind.hpp"

#include <algorithm>

#include "sim_harness/wind/iec_wind.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

/// f(state, const state) over every pair of fields.
template <class F>
void for_each_field(UniformState& a, const UniformState& b, F&& f) {
  f(a.speed_mps, b.speed_mps);
  f(a.direction_rad, b.direction_rad);
  f(a.vertical_mps, b.vertical_mps);
  f(a.shear_y, b.shear_y);
  f(a.shear_exponent, b.shear_exponent);
  f(a.shear_z, b.shear_z);
  f(a.gust_mps, b.gust_mps);
  f(a.upflow_rad, b.upflow_rad);
}

bool equal(UniformState a, const UniformState& b) {
  bool same = true;
  for_each_field(a, b, [&](double x, double y) { same = same && x == y; });
  return same;
}

/// Each kind's state at a time of arrival; `state` comes with the power law of the wind.
struct StateAt {
  const UniformWindParams& wind;
  double time_s;
  UniformState state{.shear_exponent = wind.shear_exponent};

  UniformState operator()(const SteadySpeed& steady) {
    state.speed_mps = steady.speed_mps;
    return state;
  }

  UniformState operator()(const StepSpeed& step) {
    const double since_s = time_s - step.time_s;
    const double done = since_s < 0.0 ? 0.0 : since_s >= step.ramp_s ? 1.0 : since_s / step.ramp_s;
    state.speed_mps =
        done == 1.0 ? step.to_mps : step.from_mps + (step.to_mps - step.from_mps) * done;
    return state;
  }

  UniformState operator()(const GustSpeed& gust) {
    state.speed_mps = gust.mean_speed_mps;
    state.gust_mps = eog_deviation_mps(gust.magnitude_mps, time_s - gust.start_s);
    return state;
  }

  UniformState operator()(const DirectionChange& change) {
    state.speed_mps = change.mean_speed_mps;
    state.direction_rad =
        change.angle_rad * half_cosine_rise(time_s - change.start_s, kEdcDuration_s);
    return state;
  }

  UniformState operator()(const CoherentGust& gust) {
    const double rise = half_cosine_rise(time_s - gust.start_s, kEcdDuration_s);
    state.speed_mps = gust.mean_speed_mps;
    state.gust_mps = gust.gust_mps * rise;
    state.direction_rad = gust.angle_rad * rise;
    return state;
  }

  UniformState operator()(const ShearEvent& event) {
    const double shear =
        event.amplitude_mps / event.mean_speed_mps * ews_shape(time_s - event.start_s);
    state.speed_mps = event.mean_speed_mps;
    (event.axis == ShearEvent::Axis::kVertical ? state.shear_z : state.shear_y) = shear;
    return state;
  }

  UniformState operator()(const UniformTable& table) {
    const auto next =
        std::partition_point(table.rows.begin(), table.rows.end(),
                             [this](const UniformRow& row) { return row.time_s <= time_s; });
    if (next == table.rows.begin()) return next->state;
    if (next == table.rows.end()) return table.rows.back().state;
    const UniformRow& before = *std::prev(next);
    const double weight = (time_s - before.time_s) / (next->time_s - before.time_s);
    state = before.state;
    for_each_field(state, next->state, [=](double& a, double b) { a += weight * (b - a); });
    return state;
  }
};

void check_finite(const char* where, const char* name, double value) {
  require(std::isfinite(value), where, name, value, "a finite number");
}

struct Check {
  void operator()(const SteadySpeed& steady) const {
    require_positive("steady wind", "speed_mps", steady.speed_mps);
  }
  void operator()(const StepSpeed& step) const {
    require_positive("wind step", "from_mps", step.from_mps);
    require_positive("wind step", "to_mps", step.to_mps);
    check_finite("wind step", "time_s", step.time_s);
    require(std::isfinite(step.ramp_s) && step.ramp_s >= 0.0, "wind step", "ramp_s", step.ramp_s,
            "0 or a finite number above");
  }
  void operator()(const GustSpeed& gust) const {
    event("operating gust", gust.mean_speed_mps, gust.start_s);
    require(std::isfinite(gust.magnitude_mps) && gust.magnitude_mps >= 0.0, "operating gust",
            "magnitude_mps", gust.magnitude_mps,
            "0 or a finite number above (IEC's is below 0 once the mean exceeds V_e1)");
  }
  void operator()(const DirectionChange& change) const {
    event("direction change", change.mean_speed_mps, change.start_s);
    check_finite("direction change", "angle_rad", change.angle_rad);
  }
  void operator()(const CoherentGust& gust) const {
    event("coherent gust", gust.mean_speed_mps, gust.start_s);
    check_finite("coherent gust", "angle_rad", gust.angle_rad);
    check_finite("coherent gust", "gust_mps", gust.gust_mps);
  }
  void operator()(const ShearEvent& shear) const {
    event("extreme shear", shear.mean_speed_mps, shear.start_s);
    check_finite("extreme shear", "amplitude_mps", shear.amplitude_mps);
  }
  void operator()(const UniformTable& table) const {
    constexpr auto kWhere = "uniform wind table";
    require(!table.rows.empty(), kWhere, "rows", 0, "at least 1");
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      UniformState state = table.rows[i].state;
      check_finite(kWhere, "time_s", table.rows[i].time_s);
      for_each_field(state, state, [](double x, double) { check_finite(kWhere, "value", x); });
      require(i == 0 || table.rows[i].time_s > table.rows[i - 1].time_s, kWhere, "time_s",
              table.rows[i].time_s, "later than the row before");
    }
  }

 private:
  static void event(const char* where, double mean_speed_mps, double start_s) {
    require_positive(where, "mean_speed_mps", mean_speed_mps);
    check_finite(where, "start_s", start_s);
  }
};

double speed_before(const UniformWindParams& params) {
  constexpr double kLongAgo_s = -std::numeric_limits<double>::infinity();
  return std::visit(StateAt{params, kLongAgo_s}, params.history).speed_mps;
}

struct Shear {
  bool power_law = false;
  bool any = false;
};

Shear shear_of(const UniformWindParams& params) {
  const bool power_law = params.shear_exponent != 0.0;
  const auto* table = std::get_if<UniformTable>(&params.history);
  if (table == nullptr)
    return {power_law, power_law || std::holds_alternative<ShearEvent>(params.history)};
  Shear shear;
  for (const UniformRow& row : table->rows) {
    shear.power_law = shear.power_law || row.state.shear_exponent != 0.0;
    shear.any = shear.any || row.state.shear_y != 0.0 || row.state.shear_z != 0.0;
  }
  shear.any = shear.any || shear.power_law;
  return shear;
}

}  // namespace

UniformWind::UniformWind(const UniformWindParams& params) : params_(params) {
  std::visit(Check{}, params_.history);
  advection_speed_mps_ = params_.advection_speed_mps.value_or(speed_before(params_));
  require_positive("uniform wind", "advection_speed_mps", advection_speed_mps_);
  require_positive("uniform wind", "hub_height_m", params_.hub_height_m);
  require_positive("uniform wind", "reference_length_m", params_.reference_length_m);
  require(std::isfinite(params_.shear_exponent) && params_.shear_exponent >= 0.0, "uniform wind",
          "shear_exponent", params_.shear_exponent, "0 or a finite number above");
  const Shear shear = shear_of(params_);
  power_law_ = shear.power_law;
  sheared_ = shear.any;
}

UniformState UniformWind::state(double arrival_s) const {
  return std::visit(StateAt{params_, arrival_s}, params_.history);
}

Vec3 UniformWind::velocity(const Vec3& position_I_m, double time_s) const {
  const UniformState s = state(time_s - position_I_m.x / advection_speed_mps_);
  double profile = 1.0;
  if (sheared_) {
    const double above_hub_m = position_I_m.z - params_.hub_height_m;
    if (s.shear_exponent != 0.0)
      profile = std::pow(position_I_m.z / params_.hub_height_m, s.shear_exponent);
    profile += (s.shear_y * position_I_m.y * std::cos(s.direction_rad) + s.shear_z * above_hub_m) /
               params_.reference_length_m;
  }
  Vec3 wind{s.speed_mps * profile + s.gust_mps, 0.0, s.vertical_mps};
  if (s.upflow_rad != 0.0) {
    const double c = std::cos(s.upflow_rad), sine = std::sin(s.upflow_rad);
    wind = {c * wind.x - sine * wind.z, 0.0, sine * wind.x + c * wind.z};
  }
  if (s.direction_rad == 0.0) return wind;
  return {wind.x * std::cos(s.direction_rad), -wind.x * std::sin(s.direction_rad), wind.z};
}

WindExtent UniformWind::extent() const {
  WindExtent extent;
  if (power_law_) extent.z_min_m = 0.0;
  return extent;
}

std::vector<DiskPoint> UniformWind::disk_points(double hub_height_m, double radius_m) const {
  if (!sheared_) return {{0.0, hub_height_m}};
  return WindField::disk_points(hub_height_m, radius_m);
}

UniformTable tabulate(const UniformWind& wind, double begin_s, double end_s, double step_s) {
  require_positive("uniform wind table", "step_s", step_s);
  require(std::isfinite(end_s) && end_s > begin_s, "uniform wind table", "end_s", end_s,
          "a time behind begin_s");
  const auto last = std::lround((end_s - begin_s) / step_s);
  UniformTable table;
  for (long i = 0; i <= last; ++i) {
    const double time_s = begin_s + static_cast<double>(i) * step_s;
    const UniformRow row{time_s, wind.state(time_s)};
    const std::size_t n = table.rows.size();
    const bool idle = n >= 2 && equal(table.rows[n - 1].state, row.state) &&
                      equal(table.rows[n - 2].state, row.state);
    if (idle) table.rows.pop_back();
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace lac::sim
