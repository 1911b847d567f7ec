// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/hard_target.hpp"

#include <cmath>
#include <numbers>

namespace lac::sim {
namespace {

constexpr double kPointReach_m = 0.5;
constexpr double kFaintest = 1e-12;  // of 0 dB; keeps the CNR of an empty gate finite

double power(double db) noexcept {
  return std::pow(10.0, 0.1 * db);
}

double normal_distribution(double s) noexcept {
  return 0.5 * std::erfc(-s / std::numbers::sqrt2);
}

/// Its integral from minus infinity.
double normal_distribution_integral(double s) noexcept {
  return s * normal_distribution(s) +
         std::exp(-0.5 * s * s) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
}

/// Of a Gaussian pulse of unit standard deviation seen through a gate of this half length.
double pulse_distribution(double s, double half_gate) noexcept {
  return (normal_distribution_integral(s + half_gate) -
          normal_distribution_integral(s - half_gate)) /
         (2.0 * half_gate);
}

void read_window(YamlReader& in, const std::string& key, double largest_deg, double& min_rad,
                 double& max_rad) {
  if (!in.has(key)) return;
  const std::vector<double> deg = in.numbers(key, Range::between(-largest_deg, largest_deg));
  if (deg.size() != 2 || deg[0] > deg[1]) in.fail(key, "expected two numbers: from, to");
  min_rad = rad_from_deg(deg[0]);
  max_rad = rad_from_deg(deg[1]);
}

HardTarget read_target(YamlReader& in) {
  HardTarget t;
  t.distance_m = in.number("distance_m", Range::positive());
  t.cnr_db = in.number("cnr_db", t.cnr_db, Range::between(-60.0, 100.0));
  t.opaque = in.flag("opaque", t.opaque);
  t.beam = in.integer("beam", 0, Range::between(1, 1000)) - 1;
  read_window(in, "azimuth_deg", 180.0, t.azimuth_min_rad, t.azimuth_max_rad);
  read_window(in, "elevation_deg", 90.0, t.elevation_min_rad, t.elevation_max_rad);
  t.start_s = in.number("start_s", t.start_s, Range::not_negative());
  t.end_s = in.number("end_s", t.end_s, Range::not_negative());
  if (t.end_s <= t.start_s) in.fail("end_s", "expected a time after start_s");
  in.finish();
  return t;
}

}  // namespace

bool HardTarget::met_by(const LidarMeasurement& m) const noexcept {
  if (m.time_s < start_s || m.time_s >= end_s || (beam >= 0 && beam != m.beam_id)) return false;
  const Vec3 n = m.beam_dir_I();
  const double azimuth_rad = std::atan2(-n.y, -n.x);
  const double elevation_rad = std::atan2(n.z, std::hypot(n.x, n.y));
  return azimuth_rad >= azimuth_min_rad && azimuth_rad <= azimuth_max_rad &&
         elevation_rad >= elevation_min_rad && elevation_rad <= elevation_max_rad;
}

std::vector<HardTarget> read_hard_targets(YamlReader& in, const std::string& key) {
  std::vector<HardTarget> targets;
  for (YamlReader& item : in.maps(key)) targets.push_back(read_target(item));
  return targets;
}

GateView gate_view(const RangeWeighting& w, double gate_range_m, double object_m) noexcept {
  const double off_m = object_m - gate_range_m;
  if (w.is_point()) return {std::abs(off_m) <= kPointReach_m ? 1.0 : 0.0, off_m > 0.0 ? 1.0 : 0.0};
  if (w.kind == ProbeKind::kLorentzian) {
    const double s = off_m / w.rayleigh_m(gate_range_m);
    return {1.0 / (1.0 + s * s), 0.5 + std::atan(s) / kPi};
  }
  const double sigma_m = w.sigma_m();
  const double before = w.kind == ProbeKind::kGaussian
                            ? normal_distribution(off_m / sigma_m)
                            : pulse_distribution(off_m / sigma_m, 0.5 * w.gate_length_m / sigma_m);
  return {w.shape(off_m) / w.shape(0.0), before};
}

void mix_in(const HardTarget& target, const GateView& view, double own_speed_mps,
            LidarGate& gate) noexcept {
  const double echo = power(target.cnr_db) * view.echo;
  const double wind = power(gate.cnr_db) * (target.opaque ? view.before : 1.0);
  const double sum = echo + wind;
  gate.cnr_db = 10.0 * std::log10(sum + kFaintest);
  if (sum > 0.0) gate.speed_mps = (wind * gate.speed_mps + echo * own_speed_mps) / sum;
}

}  // namespace lac::sim
