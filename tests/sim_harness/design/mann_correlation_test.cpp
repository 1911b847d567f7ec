// SPDX-License-Identifier: Apache-2.0
// Closed relations to the spectra of the tensor, and numbers of python/lidar_correlation.py, which
// shares no code.
#include "sim_harness/design/mann_correlation.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/wind/stability.hpp"
#include "tests/sim_harness/design/design_lidars.hpp"

namespace lac::sim {
namespace {

using testing::SizeIs;

constexpr double kSpeed_mps = 16.0;

MannParams neutral(double evolution_s = std::numeric_limits<double>::infinity()) {
  MannParams p = stability_mann(Stability::kNeutral);
  p.evolution_s = evolution_s;
  return p;
}

RotorLidarSpectra spectra(const MannParams& turbulence, const LidarParams& lidar, double radius_m,
                          double k1_radpm, const MannQuadrature& q = {},
                          double speed_mps = kSpeed_mps) {
  return MannCorrelation(turbulence, lidar_volumes(lidar, {}), radius_m, q)
      .at(k1_radpm, {speed_mps})[0];
}

double coherence(const RotorLidarSpectra& s, std::size_t first_plane = 0) {
  return std::norm(s.s_rl[first_plane]) / (s.s_rr * s.s_ll[first_plane]);
}

// A point on the axis, a rotor without extent, frozen turbulence: the same signal.
TEST(MannCorrelation, IsPerfectForAPointOfFrozenTurbulence) {
  for (const double k1 : {0.002, 0.05, 0.5}) {
    const RotorLidarSpectra s = spectra(neutral(), points_at({{}}, {100.0}), 0.0, k1);
    EXPECT_NEAR(coherence(s), 1.0, 1e-12);
    EXPECT_NEAR(std::abs(s.s_rl[0]) / s.s_ll[0], 1.0, 1e-12);
  }
}

// Three points on the axis: sums of F_uu(k1, dt) of the tensor, dt = dx / U.
TEST(MannCorrelation, EvolvesFromPlaneToPlane) {
  const MannParams turbulence = neutral(400.0);
  const MannTensor tensor(turbulence);
  const double gates_m[] = {40.0, 100.0, 190.0};
  for (const double k1 : {0.005, 0.03}) {
    const RotorLidarSpectra s = spectra(turbulence, points_at({{}}, {40.0, 100.0, 190.0}), 0.0, k1,
                                        {.nodes = 301, .reach = 600.0});
    const auto f_uu = [&](double dx_m) {
      return tensor.cross_spectra(k1, {0.0, 0.0, dx_m / kSpeed_mps})[kUu].real();
    };
    double s_ll = 0.0, s_rl = 0.0;
    for (const double a : gates_m) {
      s_rl += f_uu(a) / 3.0;
      for (const double b : gates_m) s_ll += f_uu(std::abs(a - b)) / 9.0;
    }
    EXPECT_NEAR(s.s_ll[0] / s_ll, 1.0, 1e-9);
    EXPECT_NEAR(std::abs(s.s_rl[0]) / s_rl, 1.0, 1e-9);
    EXPECT_NEAR(s.s_ll[2] / f_uu(0.0), 1.0, 1e-9);  // the farthest alone
    EXPECT_NEAR(std::abs(s.s_rl[2]) / f_uu(190.0), 1.0, 1e-9);
  }
}

// Two points off the axis, not symmetric: the full cross-spectral matrices of the tensor, with the
// right signs of uv, uw and vw, and of the place of the points.
TEST(MannCorrelation, SeesAllComponentsOffTheAxis) {
  const MannTensor tensor(neutral());
  const LidarParams lidar = points_at({{rad_from_deg(20.0), rad_from_deg(5.0), 0.0, {}},
                                       {rad_from_deg(-8.0), rad_from_deg(16.0), 0.0, {}}},
                                      {100.0});
  const LidarVolumes volumes = lidar_volumes(lidar, {});
  const double k1 = 0.02;
  const auto pair = [&](const ProbeVolume& a, const ProbeVolume& b) {
    const Vec3 d = b.centre_W - a.centre_W;
    const CrossSpectra f = tensor.cross_spectra(k1, {d.y, d.z, 0.0}, 601);
    const Vec3 m = a.weight, n = b.weight;
    return m.x * n.x * f[kUu] + m.y * n.y * f[kVv] + m.z * n.z * f[kWw] +
           (m.x * n.y + m.y * n.x) * f[kUv] + (m.x * n.z + m.z * n.x) * f[kUw] +
           (m.y * n.z + m.z * n.y) * f[kVw];
  };
  std::complex<double> s_ll = 0.0, s_rl = 0.0;
  const ProbeVolume rotor{{}, {}, {1.0, 0.0, 0.0}, 0.0, {}};
  for (const ProbeVolume& a : volumes.planes[0].volumes) {
    s_rl += pair(rotor, a) / 2.0;
    for (const ProbeVolume& b : volumes.planes[0].volumes) s_ll += pair(a, b) / 4.0;
  }
  const RotorLidarSpectra s = spectra(neutral(), lidar, 0.0, k1, {.nodes = 601, .reach = 600.0});
  EXPECT_NEAR(s.s_ll[0] / s_ll.real(), 1.0, 1e-9);
  EXPECT_NEAR(std::abs(s.s_rl[0] - s_rl) / std::abs(s_rl), 0.0, 1e-9);
}

// A symmetric scan needs half of the wave vectors; an error of angle far below anything that
// matters makes it take all of them.
TEST(MannCorrelation, HalvesTheWorkOfSymmetricScans) {
  LidarParams askew = four_beams();
  askew.scan.beams[0].azimuth_rad += 1e-9;
  for (const double k1 : {0.005, 0.03}) {
    const RotorLidarSpectra half = spectra(neutral(400.0), four_beams(), 63.0, k1);
    const RotorLidarSpectra whole = spectra(neutral(400.0), askew, 63.0, k1);
    EXPECT_NEAR(half.s_rr / whole.s_rr, 1.0, 1e-12);
    EXPECT_NEAR(half.s_ll[0] / whole.s_ll[0], 1.0, 1e-7);
    EXPECT_NEAR(std::abs(half.s_rl[0] - whole.s_rl[0]) / std::abs(whole.s_rl[0]), 0.0, 1e-7);
  }
}

// What the sums hold for fewer planes is what a lidar with fewer gates gives.
TEST(MannCorrelation, HoldsTheSumsOfFewerGates) {
  LidarParams fewer = four_beams();
  fewer.gates_m.erase(fewer.gates_m.begin(), fewer.gates_m.begin() + 3);
  const RotorLidarSpectra all = spectra(neutral(400.0), four_beams(), 63.0, 0.02);
  const RotorLidarSpectra far = spectra(neutral(400.0), fewer, 63.0, 0.02);
  ASSERT_THAT(all.s_ll, SizeIs(10));
  EXPECT_NEAR(all.s_ll[3] / far.s_ll[0], 1.0, 1e-12);
  EXPECT_NEAR(std::abs(all.s_rl[3] / far.s_rl[0] - 1.0), 0.0, 1e-12);
}

// Several wind speeds share the tensor, not the result.
TEST(MannCorrelation, TakesEachSpeedForItself) {
  const MannCorrelation model(neutral(400.0), lidar_volumes(four_beams(), {}), 63.0);
  const auto both = model.at(0.02, {8.0, 24.0});
  EXPECT_EQ(both[1].s_ll, model.at(0.02, {24.0})[0].s_ll);
  EXPECT_LT(coherence(both[0]), coherence(both[1]));  // more time to change
}

// The default quadrature against one four times as fine that reaches four times as far.
TEST(MannCorrelation, HasAConvergedQuadrature) {
  for (const Stability stability :
       {Stability::kUnstable, Stability::kNeutral, Stability::kStable}) {
    for (const double k1 : {0.001, 0.02, 0.05}) {
      const MannParams turbulence = stability_mann(stability);
      const RotorLidarSpectra fine =
          spectra(turbulence, four_beams(), 63.0, k1, {.nodes = 401, .reach = 120.0});
      const RotorLidarSpectra s = spectra(turbulence, four_beams(), 63.0, k1);
      EXPECT_NEAR(s.s_rr / fine.s_rr, 1.0, 2e-5);
      EXPECT_NEAR(s.s_ll[0] / fine.s_ll[0], 1.0, 1e-4);
      EXPECT_NEAR(std::abs(s.s_rl[0] / fine.s_rl[0] - 1.0), 0.0, 1e-6);
    }
  }
}

// The same script: phases of S_RL [rad].
TEST(MannCorrelation, AgreesWithTheScriptInPhase) {
  for (const auto& [k1, phase] : {std::pair{0.002, 0.0154412}, std::pair{0.01, 0.0887463},
                                  std::pair{0.0223607, 0.2171}, std::pair{0.05, 0.392434}})
    EXPECT_NEAR(std::arg(spectra(neutral(400.0), four_beams(), 63.0, k1).s_rl[0]), phase, 3e-5);
}

// Beams that spread, in isotropic turbulence at low wavenumbers: where u changes, v and w do so
// that nothing is compressed, and a point rotor on the axis sees the estimate late by half of
// (n_y^2 + n_z^2)/n_x^2 of the distance.
TEST(MannCorrelation, SpreadingBeamsAreLate) {
  MannParams isotropic = neutral();
  isotropic.gamma = 0.0;
  isotropic.length_m = 2000.0;
  const double tangent = std::tan(rad_from_deg(6.0));
  LidarParams lidar = points_at({}, {100.0});
  for (const auto& [y, z] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
    lidar.scan.beams.push_back({y * rad_from_deg(6.0), z * rad_from_deg(6.0), 0.0, {}});
  const double k1 = 0.002;
  const double shift_m =
      std::arg(spectra(isotropic, lidar, 0.0, k1, {.nodes = 401, .reach = 600.0}).s_rl[0]) / k1;
  EXPECT_NEAR(shift_m, 0.5 * tangent * tangent * 100.0, 0.1 * shift_m);
}

/// One line of lidar_correlation.py: one-sided in f.
struct ScriptLine {
  double k1_radpm, s_rr, s_ll, abs_s_rl;
};

void expect_line(const ScriptLine& line, const RotorLidarSpectra& s, double speed_mps) {
  const double one_sided = 4.0 * kPi / speed_mps;
  EXPECT_NEAR(one_sided * s.s_rr / line.s_rr, 1.0, 1e-4) << line.k1_radpm;
  EXPECT_NEAR(one_sided * s.s_ll[0] / line.s_ll, 1.0, 2e-4) << line.k1_radpm;
  EXPECT_NEAR(one_sided * std::abs(s.s_rl[0]) / line.abs_s_rl, 1.0, 1e-4) << line.k1_radpm;
}

// lidar_correlation.py mann CLASS --wavenumbers 0.002 0.05 5
TEST(MannCorrelation, AgreesWithTheScriptForTheFourBeamLidar) {
  const ScriptLine unstable[] = {{0.002, 259.649, 259.959, 253.922},
                                 {0.01, 20.1007, 20.1864, 17.9428},
                                 {0.05, 0.143878, 0.194403, 0.0458173}};
  const ScriptLine neutral_class[] = {{0.002, 194.368, 198.398, 194.483},
                                      {0.01, 17.8511, 19.9973, 18.04},
                                      {0.05, 0.0998011, 0.371192, 0.0715662}};
  const ScriptLine stable[] = {{0.002, 82.8313, 86.4361, 83.0477},
                               {0.01, 17.6597, 20.3648, 17.8568},
                               {0.05, 0.164224, 0.673941, 0.125311}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (const auto& [stability, lines] :
         {std::pair{Stability::kUnstable, unstable}, std::pair{Stability::kNeutral, neutral_class},
          std::pair{Stability::kStable, stable}}) {
      const double k1 = lines[i].k1_radpm;
      expect_line(lines[i], spectra(stability_mann(stability), four_beams(), 63.0, k1), kSpeed_mps);
    }
  }
}

// ... mann neutral --speed 24 --radius 120 --azimuth 20 -20 0 --elevation 5 5 -12 --gates 80 200 4
// Left and right alike, up and down not; a rotor wider than the scan.
TEST(MannCorrelation, AgreesWithTheScriptForThreeBeams) {
  LidarParams lidar = points_at({{rad_from_deg(20.0), rad_from_deg(5.0), 0.0, {}},
                                 {rad_from_deg(-20.0), rad_from_deg(5.0), 0.0, {}},
                                 {0.0, rad_from_deg(-12.0), 0.0, {}}},
                                {80.0, 120.0, 160.0, 200.0});
  lidar.weighting.fwhm_m = 30.0;
  for (const ScriptLine& line :
       {ScriptLine{0.002, 90.7976, 121.014, 100.067}, ScriptLine{0.01, 3.05837, 12.177, 4.09013},
        ScriptLine{0.0223607, 0.191064, 2.61563, 0.140264}}) {
    expect_line(line, spectra(neutral(400.0), lidar, 120.0, line.k1_radpm, {}, 24.0), 24.0);
  }
}

// ... mann neutral --planes frozen --rayleigh 8 --radius 26 --gates 58.966 58.966 1 --azimuth
// 12.9416 12.9416 -12.9416 -12.9416 --elevation 12.6193 -12.6193 12.6193 -12.6193: continuous wave.
TEST(MannCorrelation, AgreesWithTheScriptForAContinuousWave) {
  const double azimuth = rad_from_deg(12.9416), elevation = rad_from_deg(12.6193);
  LidarParams lidar = points_at({{azimuth, elevation, 0.0, {}},
                                 {azimuth, -elevation, 0.0, {}},
                                 {-azimuth, elevation, 0.0, {}},
                                 {-azimuth, -elevation, 0.0, {}}},
                                {58.966});
  lidar.weighting.kind = ProbeKind::kLorentzian;
  lidar.weighting.rayleigh_length_m = 8.0;
  lidar.weighting.rayleigh_at_m = 58.966 / (std::cos(azimuth) * std::cos(elevation));
  for (const ScriptLine& line :
       {ScriptLine{0.002, 244.914, 231.268, 237.782}, ScriptLine{0.01, 42.1137, 35.5439, 38.5185},
        ScriptLine{0.05, 1.02046, 0.736444, 0.707959}}) {
    expect_line(line, spectra(neutral(), lidar, 26.0, line.k1_radpm), kSpeed_mps);
  }
}

TEST(MannCorrelation, RefusesParametersOutOfRange) {
  const LidarVolumes lidar = lidar_volumes(four_beams(), {});
  EXPECT_THROW(MannCorrelation(neutral(), lidar, -1.0), Error);
  EXPECT_THROW(MannCorrelation(neutral(), lidar, 63.0, {.nodes = 101, .reach = 0.0}), Error);
  EXPECT_THROW(
      MannCorrelation(neutral(), lidar, 63.0, {.nodes = 100, .reach = 30.0}).at(0.02, {16.0}),
      Error);
}

}  // namespace
}  // namespace lac::sim
