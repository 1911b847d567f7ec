// SPDX-License-Identifier: Apache-2.0
// Limits in closed form, and numbers of python/lidar_correlation.py, which shares no code.
#include "sim_harness/design/kaimal_correlation.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "core/units.hpp"
#include "sim_harness/wind/stability.hpp"
#include "tests/sim_harness/design/design_lidars.hpp"

namespace lac::sim {
namespace {

constexpr double kSpeed_mps = 16.0;

KaimalTurbulence turbulence(Stability stability, LateralCoherence lateral) {
  return {stability_kaimal(stability, kStabilitySigmaU_mps), stability_evolution(stability),
          lateral};
}

/// One-sided in f.
double density(const KaimalComponent& c, double k1_radpm) {
  return c.spectrum(k1_radpm * kSpeed_mps / (2.0 * kPi), kSpeed_mps);
}

LidarParams level_points_at(std::vector<double> azimuths_deg, std::vector<double> gates_m) {
  std::vector<LidarBeam> beams;
  for (const double a : azimuths_deg) beams.push_back({rad_from_deg(a), 0.0, 0.0, {}});
  return points_at(std::move(beams), std::move(gates_m));
}

/// One-sided in f.
struct Found {
  double s_rr, s_ll, abs_s_rl;
};

Found spectra(const KaimalTurbulence& t, const LidarParams& lidar, double radius_m, double k1_radpm,
              const LidarVolumeSettings& settings = {}, std::size_t first_plane = 0) {
  const RotorLidarSpectra s =
      KaimalCorrelation(t, lidar_volumes(lidar, settings), radius_m).at(k1_radpm, {kSpeed_mps})[0];
  const double one_sided = 4.0 * kPi / kSpeed_mps;
  return {one_sided * s.s_rr, one_sided * s.s_ll[first_plane],
          one_sided * std::abs(s.s_rl[first_plane])};
}

// A point on the axis and a rotor without extent: the spectrum of u, and the coherence along the
// wind, squared.
TEST(KaimalCorrelation, OfAPointOnTheAxisIsTheCoherenceAlongTheWind) {
  KaimalTurbulence t = turbulence(Stability::kNeutral, LateralCoherence::kSameAsU);
  for (const double k1 : {0.002, 0.05}) {
    const Found f = spectra(t, level_points_at({0.0}, {100.0}), 0.0, k1);
    EXPECT_NEAR(f.s_rr / density(t.model.u, k1), 1.0, 1e-7);
    EXPECT_NEAR(f.s_ll / density(t.model.u, k1), 1.0, 1e-12);
    const double gamma_sq = std::exp(-1.8 * 100.0 * std::hypot(k1 / (2.0 * kPi), 1.49e-4));
    EXPECT_NEAR(f.abs_s_rl * f.abs_s_rl / (f.s_rr * f.s_ll), gamma_sq, 1e-7);
  }
  t.evolution = {};
  const Found frozen = spectra(t, level_points_at({0.0}, {100.0}), 0.0, 0.02);
  EXPECT_NEAR(frozen.abs_s_rl / frozen.s_ll, 1.0, 1e-12);
}

// Two beams in points 2 x 25 m apart: u by its coherence; v fully, partly or not at all connected.
TEST(KaimalCorrelation, TakesVAsTheConventionSays) {
  const double angle_deg = deg_from_rad(std::atan(0.25)), k1 = 0.01;
  for (const LateralCoherence lateral :
       {LateralCoherence::kSameAsU, LateralCoherence::kIndependent}) {
    const KaimalTurbulence t = turbulence(Stability::kNeutral, lateral);
    const Found f = spectra(t, level_points_at({angle_deg, -angle_deg}, {100.0}), 63.0, k1);
    const double gamma = t.model.root_coherence(50.0, k1 * kSpeed_mps / (2.0 * kPi), kSpeed_mps);
    const double of_v = lateral == LateralCoherence::kSameAsU ? 1.0 - gamma : 1.0;
    const double expected =
        0.5 * density(t.model.u, k1) * (1.0 + gamma) + 0.5 * density(t.model.v, k1) * of_v / 16.0;
    EXPECT_NEAR(f.s_ll / expected, 1.0, 1e-12);
  }
}

// Independent v and w leave nothing in a continuous volume, and of three points 3/8.
TEST(KaimalCorrelation, AveragesIndependentComponentsOut) {
  KaimalTurbulence t = turbulence(Stability::kNeutral, LateralCoherence::kIndependent);
  LidarParams lidar = level_points_at({20.0}, {100.0});
  const auto s_ll = [&](VolumeModel model, double fwhm_m) {
    lidar.weighting.fwhm_m = fwhm_m;
    return spectra(t, lidar, 63.0, 0.01, {.model = model}).s_ll;
  };
  const double point = s_ll(VolumeModel::kContinuous, 0.0);
  const double continuous = s_ll(VolumeModel::kContinuous, 30.0);
  const double three = s_ll(VolumeModel::kThreePoint, 30.0);
  t.model.v.sigma_mps = 0.0;
  const double share_of_v = std::pow(std::tan(rad_from_deg(20.0)), 2.0);
  const double v = share_of_v * density(stability_kaimal(Stability::kNeutral, 2.82).v, 0.01);
  EXPECT_NEAR(point - s_ll(VolumeModel::kContinuous, 0.0), v, 1e-9);
  EXPECT_NEAR(continuous - s_ll(VolumeModel::kContinuous, 30.0), 0.0, 1e-12);
  EXPECT_NEAR(three - s_ll(VolumeModel::kThreePoint, 30.0), 0.375 * v, 1e-9);
}

// Gates left out: as if the lidar did not have them.
TEST(KaimalCorrelation, HoldsTheSumsOfFewerGates) {
  const KaimalTurbulence t = turbulence(Stability::kStable, LateralCoherence::kSameAsU);
  LidarParams fewer = four_beams();
  fewer.gates_m.erase(fewer.gates_m.begin(), fewer.gates_m.begin() + 3);
  const Found all = spectra(t, four_beams(), 63.0, 0.02, {.range_points = 9}, 3);
  const Found far = spectra(t, fewer, 63.0, 0.02, {.range_points = 9});
  EXPECT_NEAR(all.s_ll / far.s_ll, 1.0, 1e-12);
  EXPECT_NEAR(all.abs_s_rl / far.abs_s_rl, 1.0, 1e-12);
}

// lidar_correlation.py kaimal CLASS --wavenumbers 0.002 0.05 5 (same coherence for v and w), its
// range weighting continued to five standard deviations.
TEST(KaimalCorrelation, AgreesWithTheScript) {
  struct Line {
    Stability stability;
    double k1_radpm;
    Found found;
  };
  for (const Line& line : {Line{Stability::kNeutral, 0.002, {214.577, 216.71, 208.748}},
                           Line{Stability::kNeutral, 0.01, {22.679, 23.4308, 19.7676}},
                           Line{Stability::kNeutral, 0.05, {0.256561, 0.349889, 0.108973}},
                           Line{Stability::kUnstable, 0.002, {300.545, 294.515, 280.044}},
                           Line{Stability::kUnstable, 0.05, {0.436438, 0.315142, 0.0835099}},
                           Line{Stability::kStable, 0.01, {18.5723, 19.9428, 16.2235}}}) {
    const KaimalTurbulence t = turbulence(line.stability, LateralCoherence::kSameAsU);
    const Found f = spectra(t, four_beams(), 63.0, line.k1_radpm, {.range_points = 41});
    EXPECT_NEAR(f.s_rr / line.found.s_rr, 1.0, 1e-4);
    EXPECT_NEAR(f.s_ll / line.found.s_ll, 1.0, 3e-4) << line.k1_radpm;
    EXPECT_NEAR(f.abs_s_rl / line.found.abs_s_rl, 1.0, 3e-4) << line.k1_radpm;
  }
}

/// A point on a beam with cosine 0.8 and sine 0.6 to the side.
LidarParams three_four_five() {
  return points_at({{std::atan2(0.6, 0.8), 0.0, 0.0, {}}}, {100.0});
}

// Lecture on lidar-assisted control: v_los = 0.8 u + 0.6 v. It counts motion towards the lidar, the
// beam's vector away from it.
TEST(KaimalCorrelation, ProjectsTheWindAsTheLectureDoes) {
  const LidarVolumes lidar = lidar_volumes(three_four_five(), {});
  const Vec3 beam_W = lidar.planes.front().volumes.front().beam_W;
  const double wind[][2] = {{10.0, 0.0}, {10.0, 1.0}, {8.0, -2.0}};
  for (const auto& [u, v] : wind)
    EXPECT_NEAR(-dot(beam_W, Vec3{u, v, 0.0}), 0.8 * u + 0.6 * v, 1e-12);
}

// Lecture: S_los = 16/25 S_uu + 9/25 S_vv; S_LL is that over n_x^2 = 16/25.
TEST(KaimalCorrelation, GivesTheLecturesSpectrumOfALineOfSightSpeed) {
  KaimalTurbulence air;
  air.model = iec_kaimal(2.0, 90.0);
  const KaimalCorrelation model(air, lidar_volumes(three_four_five(), {}), 0.0);
  for (const double f_hz : {0.003, 0.03, 0.3}) {
    const double s_ll = model.at(2.0 * kPi * f_hz / kSpeed_mps, {kSpeed_mps}).front().s_ll.front();
    const double s_uu = air.model.u.spectrum(f_hz, kSpeed_mps);
    const double s_vv = air.model.v.spectrum(f_hz, kSpeed_mps);
    EXPECT_NEAR(16.0 / 25.0 * 4.0 * kPi / kSpeed_mps * s_ll, 16.0 / 25.0 * s_uu + 9.0 / 25.0 * s_vv,
                1e-12 * s_uu);
  }
}

}  // namespace
}  // namespace lac::sim
