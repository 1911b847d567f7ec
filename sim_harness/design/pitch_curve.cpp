// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/pitch_curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sim_harness/design/input_template.hpp"
#include "sim_harness/output/text_table.hpp"
#include "sim_harness/turbine/operating_point.hpp"

namespace lac::sim {
namespace {

constexpr double kBalanceStep_mps = 0.5;
constexpr double kClosest_mps = 0.02;  // the file has two decimals

bool is_pitching(const TurbineParams& t, double wind_mps) {
  return steady_state(t, wind_mps).pitch_rad > t.fine_pitch_rad;
}

double rated_wind_mps(const TurbineParams& t) {
  double low = t.cut_in_wind_mps, high = t.cut_out_wind_mps;
  if (is_pitching(t, low) || !is_pitching(t, high)) {
    throw Error(t.name + ": no wind speed between cut-in (" + shortest(low) +
                " m/s) and cut-out (" + shortest(high) +
                " m/s) from which on the blades pitch; the rotor table and rated " +
                "power do not fit together");
  }
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (is_pitching(t, middle) ? high : low) = middle;
  }
  return high;
}

/// The highest wind, in steps from the last one down, in which the rotor table can shed the power.
double last_balance_mps(const TurbineParams& t, double rated_mps, double last_mps) {
  for (double v = last_mps; v > rated_mps; v -= kBalanceStep_mps) {
    try {
      steady_state(t, v);
      return v;
    } catch (const Error&) {  // more wind than the table can shed
    }
  }
  return rated_mps;
}

/// The curve between two winds, halved where a straight line is not enough.
class Refinement {
 public:
  Refinement(const TurbineParams& turbine, double tolerance_rad)
      : turbine_(turbine), tolerance_rad_(tolerance_rad) {}

  void add(double wind_mps, double pitch_rad) {
    wind_mps_.push_back(wind_mps), pitch_rad_.push_back(pitch_rad);
  }
  double pitch_at(double wind_mps) const { return steady_state(turbine_, wind_mps).pitch_rad; }

  /// Adds all points after `low` up to and with `high`.
  void fill(double low, double low_rad, double high, double high_rad) {
    const double middle = std::round(50.0 * (low + high)) / 100.0, middle_rad = pitch_at(middle);
    const double line_rad = std::lerp(low_rad, high_rad, (middle - low) / (high - low));
    const double error_rad = std::abs(middle_rad - line_rad);
    if (error_rad > tolerance_rad_ && high - low > 2.0 * kClosest_mps) {
      fill(low, low_rad, middle, middle_rad);
      fill(middle, middle_rad, high, high_rad);
      return;
    }
    largest_error_rad_ = std::max(largest_error_rad_, error_rad);
    add(high, high_rad);
  }

  PitchCurve result(double rated_mps, double balance_mps) const {
    for (std::size_t i = 1; i < pitch_rad_.size(); ++i) {
      if (pitch_rad_[i] >= pitch_rad_[i - 1]) continue;
      throw Error(turbine_.name + ": the pitch that balances rated torque falls between " +
                  shortest(wind_mps_[i - 1]) + " and " + shortest(wind_mps_[i]) +
                  " m/s, expected a rotor table that lets it rise with the wind");
    }
    return {{wind_mps_, pitch_rad_}, rated_mps, balance_mps, largest_error_rad_};
  }

 private:
  const TurbineParams& turbine_;
  double tolerance_rad_;
  double largest_error_rad_ = 0.0;
  std::vector<double> wind_mps_, pitch_rad_;
};

}  // namespace

PitchCurve static_pitch_curve(const TurbineParams& t, const PitchCurveSettings& s) {
  const double rated_mps = rated_wind_mps(t);
  const double first_mps = std::floor(100.0 * rated_mps) / 100.0;
  const double balance_mps = last_balance_mps(t, rated_mps, s.last_wind_mps);
  Refinement curve(t, s.tolerance_rad);
  curve.add(0.0, t.fine_pitch_rad);
  curve.add(first_mps, t.fine_pitch_rad);
  double from_mps = first_mps, from_rad = t.fine_pitch_rad;
  for (double to_mps = std::ceil(rated_mps + 0.5); from_mps < balance_mps; to_mps += 2.0) {
    const double end_mps = std::min(to_mps, balance_mps), end_rad = curve.pitch_at(end_mps);
    curve.fill(from_mps, from_rad, end_mps, end_rad);
    from_mps = end_mps, from_rad = end_rad;
  }
  if (balance_mps < s.last_wind_mps) {
    const double slope = from_rad - curve.pitch_at(balance_mps - 1.0);
    curve.add(s.last_wind_mps, from_rad + slope * (s.last_wind_mps - balance_mps));
  }
  return curve.result(rated_mps, balance_mps);
}

std::string with_pitch_curve(std::string_view ffp_input, const TurbineParams& turbine,
                             const PitchCurve& curve) {
  std::string origin = "Static pitch curve: steady states of " + turbine.name +
                       " with its rotor table at rated speed and torque;\nthe blades leave fine "
                       "pitch at " +
                       format_value(curve.rated_wind_mps, 2) + " m/s; straight lines within " +
                       format_value(deg_from_rad(curve.largest_error_rad), 3) + " deg.\n";
  if (curve.last_balance_mps < curve.pitch_rad.x().back()) {
    origin += "Beyond " + format_value(curve.last_balance_mps, 1) +
              " m/s, where the rotor table ends, continued with its last slope.\n";
  }
  std::vector<double> pitch_deg;
  for (const double rad : curve.pitch_rad.y()) pitch_deg.push_back(deg_from_rad(rad));
  return with_keys_replaced(ffp_input, {"staticwind", "staticpitch"},
                            commented(origin) +
                                key_row(curve.pitch_rad.x(), 2, "StaticWind - wind speed [m/s]") +
                                key_row(pitch_deg, 3, "StaticPitch - pitch there [deg]"));
}

}  // namespace lac::sim
