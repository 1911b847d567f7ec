// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/wind_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kProfileHeights = 11;
constexpr const char* kComponents[] = {"u", "v", "w"};

using Series = std::array<std::vector<double>, 3>;

/// u, v, w above the hub's foot at a height, at the samples.
Series series_at(const WindField& field, double z_m, const RotorSignals& s) {
  Series series;
  for (std::size_t i = 0; i < s.rews_mps.size(); ++i) {
    const Vec3 v = field.velocity({0.0, 0.0, z_m}, s.t_begin_s + static_cast<double>(i) * s.dt_s);
    series[0].push_back(v.x);
    series[1].push_back(v.y);
    series[2].push_back(v.z);
  }
  return series;
}

double fitted_exponent(const WindField& field, const RotorWindParams& rotor,
                       const RotorSignals& s) {
  double xx = 0.0, xy = 0.0, x_sum = 0.0, y_sum = 0.0;
  for (int i = 0; i < kProfileHeights; ++i) {
    const double z_m =
        rotor.hub_height_m + rotor.radius_m * (2.0 * i / (kProfileHeights - 1) - 1.0);
    const double u_mps = statistics(series_at(field, z_m, s)[0]).mean;
    if (!(u_mps > 0.0 && z_m > 0.0)) return kNone;
    const double x = std::log(z_m / rotor.hub_height_m), y = std::log(u_mps);
    xx += x * x, xy += x * y, x_sum += x, y_sum += y;
  }
  return (kProfileHeights * xy - x_sum * y_sum) / (kProfileHeights * xx - x_sum * x_sum);
}

/// Of the values that are there.
Statistics statistics_of_present(const std::vector<double>& series) {
  std::vector<double> present;
  std::copy_if(series.begin(), series.end(), std::back_inserter(present),
               [](double x) { return !std::isnan(x); });
  if (present.size() == 1) return {present[0], 0.0, present[0], present[0]};
  return statistics(present);
}

}  // namespace

WindStatistics wind_statistics(const WindField& field, const RotorWindParams& rotor,
                               double window_s) {
  const double length_s = rotor.t_end_s - rotor.t_begin_s + rotor.dt_s;
  WindStatistics s;
  s.rotor = rotor;
  s.window_s = std::min(window_s, length_s);
  s.signals = rotor_signals(field, rotor, s.window_s);
  const Series hub = series_at(field, rotor.hub_height_m, s.signals);
  for (std::size_t c = 0; c < 3; ++c) {
    s.hub[c] = statistics(hub[c]);
    s.hub_intensity[c] = s.hub[c].standard_deviation / s.hub[0].mean;
  }
  s.rews = statistics(s.signals.rews_mps);
  s.shear_y = statistics(s.signals.shear_y_per_s);
  s.shear_z = statistics(s.signals.shear_z_per_s);
  s.intensity = statistics_of_present(s.signals.intensity);
  s.shear_exponent = fitted_exponent(field, rotor, s.signals);
  s.direction_rad = std::atan2(-s.hub[1].mean, s.hub[0].mean);
  s.upflow_rad = std::atan2(s.hub[2].mean, std::hypot(s.hub[0].mean, s.hub[1].mean));
  return s;
}

std::string statistics_table(const WindStatistics& s) {
  TextTable table({"quantity", "unit", "mean", "std", "std / mean u", "min", "max"});
  const auto add = [&](const std::string& name, const std::string& unit, const Statistics& st,
                       double intensity, int decimals) {
    table.add_row({name, unit, format_value(st.mean, decimals),
                   format_value(st.standard_deviation, decimals),
                   std::isnan(intensity) ? "" : format_value(100.0 * intensity, 2) + " %",
                   format_value(st.min, decimals), format_value(st.max, decimals)});
  };
  for (std::size_t c = 0; c < 3; ++c)
    add(std::string("hub ") + kComponents[c], "m/s", s.hub[c], s.hub_intensity[c], 3);
  add("rotor-effective wind speed", "m/s", s.rews, s.rews.standard_deviation / s.rews.mean, 3);
  add("rotor-averaged TI", "-", s.intensity, kNone, 4);
  add("horizontal shear, leftwards", "1/s", s.shear_y, kNone, 5);
  add("vertical shear, upwards", "1/s", s.shear_z, kNone, 5);
  std::string text = table.text();
  text += "TI: windows of " + format_value(s.window_s, 1) + " s; " +
          std::to_string(s.signals.point_count) + " points within " +
          format_value(s.rotor.radius_m, 1) + " m about " + format_value(s.rotor.hub_height_m, 1) +
          " m\n";
  text += "profile of the mean: power-law exponent " + format_value(s.shear_exponent, 3) +
          "; direction " + format_value(deg_from_rad(s.direction_rad), 2) + " deg, upflow " +
          format_value(deg_from_rad(s.upflow_rad), 2) + " deg at the hub\n";
  return text;
}

Recording wind_channels(const WindField& field, const RotorSignals& s, double hub_height_m) {
  Recording recording({{"RtVAvgxh", "m/s"},
                       {"RtTI", "-"},
                       {"RtShrHor", "1/s"},
                       {"RtShrVer", "1/s"},
                       {"WindHubVelX", "m/s"},
                       {"WindHubVelY", "m/s"},
                       {"WindHubVelZ", "m/s"}},
                      s.t_begin_s, s.dt_s, s.rews_mps.size());
  const Series hub = series_at(field, hub_height_m, s);
  for (std::size_t i = 0; i < s.rews_mps.size(); ++i) {
    const double row[] = {s.rews_mps[i], s.intensity[i], s.shear_y_per_s[i], s.shear_z_per_s[i],
                          hub[0][i],     hub[1][i],      hub[2][i]};
    float values[std::size(row)];
    std::copy(std::begin(row), std::end(row), std::begin(values));
    recording.append(values);
  }
  return recording;
}

}  // namespace lac::sim
