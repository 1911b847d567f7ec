// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/platform_motion.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr double kTimeRounding_s = 1e-6;

/// Slope of the spline in a row of the table.
double slope(const PrescribedMotion& m, std::size_t row) {
  const std::size_t low = row == 0 ? 0 : row - 1;
  const std::size_t high = std::min(row + 1, m.time_s.size() - 1);
  return (m.values[high] - m.values[low]) / (m.time_s[high] - m.time_s[low]);
}

Motion from_table(const PrescribedMotion& m, double time_s) {
  const auto above = std::upper_bound(m.time_s.begin() + 1, m.time_s.end() - 1, time_s);
  const auto i = static_cast<std::size_t>(above - m.time_s.begin()) - 1;
  const double h = m.time_s[i + 1] - m.time_s[i];
  const double s = (time_s - m.time_s[i]) / h;
  const double a = m.values[i], b = m.values[i + 1];
  const double slope_a = slope(m, i) * h, slope_b = slope(m, i + 1) * h;
  const double c2 = 3.0 * (b - a) - 2.0 * slope_a - slope_b;
  const double c3 = 2.0 * (a - b) + slope_a + slope_b;
  return {a + s * (slope_a + s * (c2 + s * c3)), (slope_a + s * (2.0 * c2 + s * 3.0 * c3)) / h};
}

double norm_of_greatest(const PlatformMotion& p, PlatformFreedom first) {
  double sum = 0.0;
  for (std::size_t i = first; i < first + 3; ++i) sum += std::pow(p.freedoms[i].greatest(), 2);
  return std::sqrt(sum);
}

}  // namespace

Motion PrescribedMotion::at(double t_s) const {
  if (!time_s.empty()) return from_table(*this, t_s);
  Motion sum{mean, 0.0};
  for (const Harmonic& h : harmonics) {
    const double rate_radps = 2.0 * kPi / h.period_s;
    sum.value += h.amplitude * std::sin(rate_radps * t_s + h.phase_rad);
    sum.rate += h.amplitude * rate_radps * std::cos(rate_radps * t_s + h.phase_rad);
  }
  return sum;
}

double PrescribedMotion::greatest() const {
  double bound = std::abs(mean);
  for (const Harmonic& h : harmonics) bound += std::abs(h.amplitude);
  double in_table = 0.0, rise = 0.0;  // a spline leaves its rows by 4/27 (|slope| + |slope|) h
  for (std::size_t i = 0; i < values.size(); ++i) {
    in_table = std::max(in_table, std::abs(values[i]));
    if (i > 0) {
      const double steepest = std::max(std::abs(slope(*this, i - 1)), std::abs(slope(*this, i)));
      rise = std::max(rise, 8.0 / 27.0 * steepest * (time_s[i] - time_s[i - 1]));
    }
  }
  return bound + in_table + rise;
}

bool PlatformMotion::is_still() const {
  return std::all_of(freedoms.begin(), freedoms.end(),
                     [](const PrescribedMotion& m) { return m.is_still(); });
}

RigidFrame PlatformMotion::frame_at(double time_s) const {
  std::array<Motion, 6> m;
  for (std::size_t i = 0; i < m.size(); ++i) m[i] = freedoms[i].at(time_s);
  const double pitch_rad = m[kPlatformPitch].value, yaw_rad = m[kYaw].value;
  const Rotation after_yaw = rotation_from_roll_pitch_yaw(0.0, 0.0, yaw_rad);
  const Rotation after_pitch = rotation_from_roll_pitch_yaw(0.0, pitch_rad, yaw_rad);
  return {{m[kSurge].value, m[kSway].value, m[kHeave].value + reference_height_m},
          {m[kSurge].rate, m[kSway].rate, m[kHeave].rate},
          rotation_from_roll_pitch_yaw(m[kRoll].value, pitch_rad, yaw_rad),
          Vec3{0.0, 0.0, m[kYaw].rate} + after_yaw * Vec3{0.0, m[kPlatformPitch].rate, 0.0} +
              after_pitch * Vec3{m[kRoll].rate, 0.0, 0.0}};
}

double PlatformMotion::greatest_travel_m(double distance_m) const {
  double turned_rad = 0.0;
  for (const PlatformFreedom f : {kRoll, kPlatformPitch, kYaw})
    turned_rad += freedoms[f].greatest();
  return norm_of_greatest(*this, kSurge) + turned_rad * distance_m;
}

void PlatformMotion::require_until(double end_s) const {
  for (const PrescribedMotion& m : freedoms) {
    if (m.time_s.empty()) continue;
    if (m.time_s.front() <= kTimeRounding_s && m.time_s.back() >= end_s - kTimeRounding_s) continue;
    std::ostringstream text;
    text << "lidar: the table of platform motion runs from " << m.time_s.front() << " to "
         << m.time_s.back() << " s, expected 0 to " << end_s << " s, the length of the run";
    throw Error(text.str());
  }
}

}  // namespace lac::sim
