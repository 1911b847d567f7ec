// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/uniform_history.hpp"

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

/// Each kind's state at a time of arrival; `state` comes with the power law of the wind.
struct StateAt {
  double time_s;
  UniformState state;

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

}  // namespace

void check(const UniformHistory& history) {
  std::visit(Check{}, history);
}

UniformState state_at(const UniformHistory& history, double arrival_s, double shear_exponent) {
  UniformState state;
  state.shear_exponent = shear_exponent;
  return std::visit(StateAt{arrival_s, state}, history);
}

UniformShear shear_of(const UniformHistory& history, double shear_exponent) {
  const bool power_law = shear_exponent != 0.0;
  const auto* table = std::get_if<UniformTable>(&history);
  if (table == nullptr)
    return {power_law, power_law || std::holds_alternative<ShearEvent>(history)};
  UniformShear shear;
  for (const UniformRow& row : table->rows) {
    shear.power_law = shear.power_law || row.state.shear_exponent != 0.0;
    shear.any = shear.any || row.state.shear_y != 0.0 || row.state.shear_z != 0.0;
  }
  shear.any = shear.any || shear.power_law;
  return shear;
}

}  // namespace lac::sim
