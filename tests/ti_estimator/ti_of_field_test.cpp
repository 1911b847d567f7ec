// SPDX-License-Identifier: Apache-2.0
// The whole method on a turbulent field: the lidar's TI against the rotor-averaged TI of the
// field (S20 eq. 3), as in S20 section 3.2.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim_harness/wind/kaimal_field.hpp"
#include "ti_estimator/ti_estimator.hpp"

namespace lac {
namespace {

constexpr double kT_s = 600.0;
constexpr double kHub_m = 90.0;
constexpr double kSpeed_mps = 16.0;

TiEstimatorParams params() {
  TiEstimatorParams p;
  p.averaging_time_s = p.correction.averaging_time_s = kT_s;
  p.correction.max_frequency_hz = 2.0;  // of the field: 1/(2 dt)
  p.number_of_gates = 4;
  for (const int beam : {0, 1, 2, 3}) {
    p.beam_dir_L.push_back(beam_direction(rad_from_deg(beam < 2 ? 15.0 : -15.0),
                                          rad_from_deg(beam % 3 == 0 ? 12.5 : -12.5)));
  }
  return p;
}

sim::GriddedWind field(std::uint64_t seed) {
  sim::KaimalFieldParams f;
  f.model = iec_kaimal(2.8, kHub_m);
  f.mean_speed_mps = kSpeed_mps;
  f.width_m = f.height_m = 80.0;
  f.ny = f.nz = 17;
  f.dt_s = 0.25;
  f.duration_s = kT_s;
  f.seed = seed;
  f.lateral_coherence = sim::LateralCoherence::kSameAsU;
  f.threads = 1;
  return sim::make_kaimal_field(f);
}

/// Line-of-sight speed of a Gaussian volume of 30 m, positive towards the lidar.
double volume_speed(const sim::WindField& wind, const Vec3& n_I, double range_m, double time_s) {
  const double s = 30.0 / std::sqrt(8.0 * std::log(2.0));
  double sum = 0.0, weights = 0.0;
  for (int i = -12; i <= 12; ++i) {
    const double offset_m = 0.25 * i * s, weight = std::exp(-0.5 * 0.0625 * i * i);
    const Vec3 at = Vec3{0.0, 0.0, kHub_m} + (range_m + offset_m) * n_I;
    sum -= weight * dot(n_I, wind.velocity(at, time_s));
    weights += weight;
  }
  return sum / weights;
}

double lidar_intensity(const sim::WindField& wind) {
  const TiEstimatorParams p = params();
  const TiEstimator estimator(p, 0.25);
  TiEstimator::State state = estimator.initial_state();
  TiEstimator::Outputs out;
  LidarMeasurement m;
  for (int i = 0; i <= static_cast<int>(kT_s * 4.0); ++i) {
    m.beam_id = i % 4;
    m.time_s = 0.25 * i;
    m.beam_dir_L = p.beam_dir_L[static_cast<std::size_t>(m.beam_id)];
    m.gate_count = 4;
    for (int g = 0; g < 4; ++g) {
      const double range_m = 40.0 + 20.0 * g;
      m.gates[static_cast<std::size_t>(g)] = {
          range_m, volume_speed(wind, m.beam_dir_I(), range_m, m.time_s), true, 0.0};
    }
    out = estimator.step({&m, m.time_s, 0.0}, state);
  }
  return out.intensity;
}

double rotor_intensity(const sim::GriddedWind& wind) {
  double sigma = 0.0, mean = 0.0;
  const auto points = wind.disk_points(kHub_m, 35.0);
  for (const sim::DiskPoint& point : points) {
    double sum = 0.0, squares = 0.0;
    const int n = static_cast<int>(kT_s * 4.0);
    for (int i = 0; i < n; ++i) {
      const double u = wind.velocity({0.0, point.y_m, point.z_m}, 0.25 * i).x;
      sum += u;
      squares += u * u;
    }
    sigma += std::sqrt((squares - sum * sum / n) / (n - 1));
    mean += sum / n;
  }
  return sigma / mean;
}

// Over 30 other seeds lidar over rotor was 0.994 with a standard deviation of 0.019 (0.31 % TI; S20
// reports an error below 0.43 % TI for T = 600 s). Limits: one seed 4 standard deviations, the
// mean of six 3 standard errors and 1 % for the 5 m grid. Without c_TI it is 9 % too low.
TEST(TiOfField, LidarAgreesWithTheRotor) {
  const double expected =
      std::sqrt(iec_kaimal(2.8, kHub_m).u.variance(0.5 / kT_s, 2.0, kSpeed_mps));
  double ratio_sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const sim::GriddedWind wind = field(seed);
    const double rotor = rotor_intensity(wind), lidar = lidar_intensity(wind);
    EXPECT_NEAR(rotor * kSpeed_mps / expected, 1.0, 0.2) << seed;
    EXPECT_NEAR(lidar / rotor, 1.0, 0.076) << seed;
    ratio_sum += lidar / rotor;
  }
  EXPECT_NEAR(ratio_sum / 6.0, 1.0, 0.033);
}

}  // namespace
}  // namespace lac
