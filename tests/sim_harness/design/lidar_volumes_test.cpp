// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/lidar_volumes.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

LidarParams four_beams() {
  return load_lidar(std::filesystem::path(LAC_SOURCE_DIR) / "config/lidars/four_beam_pulsed.yaml");
}

/// One beam, one gate 100 m along the beam.
LidarParams one_beam(double azimuth_deg, double elevation_deg) {
  LidarParams lidar;
  lidar.scan.beams = {{rad_from_deg(azimuth_deg), rad_from_deg(elevation_deg), 0.0, {}}};
  lidar.gates_m = {100.0};
  return lidar;
}

// GUO Table 3: ten planes with four volumes each; y = x tan(14.4 deg), to the right (-y) for a
// beam to the left of the viewing axis, which looks up-wind.
TEST(LidarVolumes, SortsTheFourBeamLidarIntoTenPlanes) {
  const LidarVolumes v = lidar_volumes(four_beams(), {});
  ASSERT_THAT(v.planes, SizeIs(10));
  EXPECT_EQ(v.count(0), 40u);
  EXPECT_EQ(v.count(1), 36u);
  EXPECT_NEAR(v.planes.front().distance_m, 50.0, 1e-9);
  EXPECT_NEAR(v.planes.back().distance_m, 170.0, 1e-9);
  const double across = std::tan(rad_from_deg(14.4));
  for (const ProbeVolume& p : v.planes.back().volumes) {
    EXPECT_NEAR(std::abs(p.centre_W.y), 170.0 * across, 1e-9);
    EXPECT_NEAR(p.centre_W.x, 0.0, 1e-9);
    EXPECT_NEAR(p.weight.x, 1.0, 1e-12);
    EXPECT_NEAR(p.weight.y, p.centre_W.y / -170.0, 1e-12);
  }
  EXPECT_LT(lidar_volumes(one_beam(14.4, 0.0), {}).planes[0].volumes[0].centre_W.y, 0.0);
}

// Nodes carry all of a volume: their sum is 1, their variance that of the Gaussian (12.74 m), of
// three points W^2/8.
TEST(LidarVolumes, HasNodesWithTheMomentsOfTheWeighting) {
  for (const VolumeModel model : {VolumeModel::kContinuous, VolumeModel::kThreePoint}) {
    const LidarVolumes v = lidar_volumes(one_beam(10.0, 0.0), {.model = model});
    double sum = 0.0, variance = 0.0;
    for (const RangeNode& n : v.planes[0].volumes[0].nodes) {
      sum += n.weight;
      variance += n.weight * n.offset_m * n.offset_m;
    }
    const double expected =
        model == VolumeModel::kThreePoint ? 900.0 / 8.0 : 900.0 / 8.0 / std::log(2.0);
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(variance, expected, 0.03 * expected);
  }
}

// The transforms of all weightings, against sums over their nodes where these are fine enough.
TEST(LidarVolumes, HasTheTransformOfEachWeighting) {
  LidarParams lidar = one_beam(0.0, 0.0);
  for (const ProbeKind kind : {ProbeKind::kGaussian, ProbeKind::kPulse, ProbeKind::kLorentzian}) {
    lidar.weighting.kind = kind;
    lidar.weighting.rayleigh_length_m = 5.0;
    lidar.weighting.reach_rayleigh = 20.0;
    const LidarVolumes v = lidar_volumes(lidar, {.range_points = 401});
    for (const double k : {0.01, 0.05, 0.15}) {
      double sum = 0.0;
      for (const RangeNode& n : v.planes[0].volumes[0].nodes)
        sum += n.weight * std::cos(k * n.offset_m);
      EXPECT_NEAR(v.transform(k, 100.0), sum, kind == ProbeKind::kLorentzian ? 0.05 : 0.006)
          << static_cast<int>(kind) << ", " << k;
    }
  }
  lidar.weighting = {};
  lidar.weighting.fwhm_m = 0.0;
  EXPECT_EQ(lidar_volumes(lidar, {}).transform(3.0, 100.0), 1.0);
  const LidarVolumes three = lidar_volumes(one_beam(0.0, 0.0), {.model = VolumeModel::kThreePoint});
  EXPECT_NEAR(three.transform(kPi / 30.0, 100.0), 0.5, 1e-12);
}

// Yaw misalignment: the volume turns about the rotor centre, the wind sees another beam, and the
// estimate keeps its delay and its n_x.
TEST(LidarVolumes, TurnsAgainstTheWind) {
  const double psi = rad_from_deg(10.0);
  const LidarVolumes v = lidar_volumes(one_beam(0.0, 0.0), {.yaw_error_rad = psi});
  const ProbeVolume& p = v.planes[0].volumes[0];
  EXPECT_NEAR(v.planes[0].distance_m, 100.0, 1e-9);
  EXPECT_NEAR(p.beam_W.x, -std::cos(psi), 1e-12);
  EXPECT_NEAR(p.beam_W.y, std::sin(psi), 1e-12);
  EXPECT_NEAR(p.centre_W.y, 100.0 * std::sin(psi), 1e-9);
  EXPECT_NEAR(p.centre_W.x, 100.0 * (1.0 - std::cos(psi)), 1e-9);
  EXPECT_NEAR(p.weight.x, std::cos(psi), 1e-12);
  EXPECT_NEAR(p.weight.y, -std::sin(psi), 1e-12);
}

// Beams that point up and down from a tilted lidar are in planes of their own.
TEST(LidarVolumes, SeparatesPlanesOfATiltedLidar) {
  LidarParams lidar = four_beams();
  lidar.mounting.tilt_rad = rad_from_deg(3.0);
  EXPECT_THAT(lidar_volumes(lidar, {}).planes, SizeIs(20));
}

TEST(LidarVolumes, RefusesWhatItCannotModel) {
  LidarParams behind = one_beam(0.0, 0.0);
  behind.mounting.offset_m.x = 120.0;
  EXPECT_THAT([&] { lidar_volumes(behind, {}); },
              ThrowsMessage<Error>(HasSubstr("20 m behind the rotor plane")));
  LidarParams wave = one_beam(0.0, 0.0);
  wave.weighting.kind = ProbeKind::kLorentzian;
  EXPECT_THAT([&] { lidar_volumes(wave, {.model = VolumeModel::kThreePoint}); },
              ThrowsMessage<Error>(HasSubstr("Gaussian range weighting only")));
}

}  // namespace
}  // namespace lac::sim
