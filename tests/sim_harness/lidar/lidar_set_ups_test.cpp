// SPDX-License-Identifier: Apache-2.0
// The lidars in config/lidars against the numbers of their sources.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "core/lidar_block.hpp"
#include "core/units.hpp"
#include "sim_harness/lidar/beam_samples.hpp"
#include "sim_harness/lidar/lidar_params.hpp"

namespace lac::sim {
namespace {

struct Figures {
  std::size_t beams;
  double scan_s;
  std::size_t gates;
  double first_m, last_m;
  double first_beam_off_axis_deg, last_beam_off_axis_deg;
  double last_range_m;     // of the last gate along the last beam
  double half_transfer_m;  // wavelength over 2 pi at which half of a wave is left, 0: a point
  const char* description;
};

double off_axis_deg(const LidarBeam& beam) {
  return deg_from_rad(std::acos(beam_direction(beam.azimuth_rad, beam.elevation_rad).x));
}

/// 14.4 and 14 deg are 20.0 deg off the axis, 15 and 12.5 deg 19.4 deg.
const double kGuo_deg =
    deg_from_rad(std::acos(std::cos(rad_from_deg(14.4)) * std::cos(rad_from_deg(14.0))));
const double kS20_deg =
    deg_from_rad(std::acos(std::cos(rad_from_deg(15.0)) * std::cos(rad_from_deg(12.5))));
/// A Gaussian of 30 m passes half of exp(ikx) where k = sqrt(2 ln 2)/sigma = 4 ln 2/30 m; a
/// Lorentzian where k = ln 2/z_R.
const double kPulsed_m = 30.0 / (4.0 * std::log(2.0));

double lorentzian_m(double focus_m) {
  return 1.55e-6 * focus_m * focus_m / (kPi * 0.024 * 0.024) / std::log(2.0);
}

const std::map<std::string, Figures> kSetUps{
    {"four_beam_pulsed.yaml",
     {4, 1.0, 10, 50.0, 170.0, kGuo_deg, kGuo_deg, 170.0 / std::cos(rad_from_deg(kGuo_deg)),
      kPulsed_m, "4 beams, 10 gates from 50 to 170 m, scan 1 s"}},
    {"four_beam_nacelle.yaml",
     {4, 1.0, 10, 58.0, 178.0, kGuo_deg, kGuo_deg, 178.0 / std::cos(rad_from_deg(kGuo_deg)),
      kPulsed_m, "4 beams, 10 gates from 58 to 178 m, scan 1 s"}},
    {"s20_four_beam.yaml",
     {4, 1.0, 10, 40.0, 170.0, kS20_deg, kS20_deg, 170.0 / std::cos(rad_from_deg(kS20_deg)),
      kPulsed_m, "4 beams, 10 gates from 40 to 170 m, scan 1 s"}},
    {"g18_five_beam.yaml",
     {5, 0.25, 10, 50.0, 185.0, 0.0, 15.0, 185.0 / std::cos(rad_from_deg(15.0)), kPulsed_m,
      "5 beams, 10 gates from 50 to 185 m, scan 0.25 s"}},
    {"hm_two_beam_cw.yaml",
     {2, 1.0, 1, 37.0, 37.0, 30.0, 30.0, 37.0, lorentzian_m(37.0),
      "2 beams, 1 gate at 37 m, continuous wave, scan 1 s"}},
    {"hm_four_beam_cw.yaml",
     {4, 1.0, 1, 62.0, 62.0, 18.0, 18.0, 62.0, lorentzian_m(62.0),
      "4 beams, 1 gate at 62 m, continuous wave, scan 1 s"}},
    {"circular_cw.yaml",
     {50, 1.0, 1, 100.0, 100.0, 15.0, 15.0, 100.0, lorentzian_m(100.0),
      "50 beams, 1 gate at 100 m, continuous wave, scan 1 s"}},
    {"point_preview.yaml",
     {1, 0.0125, 1, 170.0, 170.0, 0.0, 0.0, 170.0, 0.0,
      "1 beam, 1 gate at 170 m, points, scan 0.0125 s"}},
};

/// What is left of a wave exp(i k s) in the last gate of the last beam.
double transfer(const LidarParams& lidar, double k_radpm) {
  const BeamSamples beam = make_beam_samples(lidar).back();
  const GateSamples& gate = beam.gates.back();
  double sum = 0.0;
  for (std::size_t j = 0; j < gate.weights.size(); ++j) {
    sum +=
        gate.weights[j] * std::cos(k_radpm * (beam.points_m[gate.first_point + j] - gate.range_m));
  }
  return sum;
}

// Every file of the folder is known here, can be read and has the numbers of its source: beams,
// scan time, gates, angles, slant range, volume (the cut Lorentzian passes up to 7 % more).
TEST(LidarSetUpsTest, HaveTheNumbersOfTheirSources) {
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LAC_SOURCE_DIR "/config/lidars")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string name = entry.path().filename().string();
    SCOPED_TRACE(name);
    ASSERT_TRUE(kSetUps.count(name)) << "no expectation for this file";
    const Figures& expected = kSetUps.at(name);
    const LidarParams lidar = load_lidar(entry.path());
    const BeamSamples last = make_beam_samples(lidar).back();
    EXPECT_EQ(lidar.scan.beams.size(), expected.beams);
    EXPECT_NEAR(lidar.scan.scan_time_s(), expected.scan_s, 1e-12);
    EXPECT_EQ(lidar.gates_m.size(), expected.gates);
    EXPECT_EQ(lidar.gates_m.front(), expected.first_m);
    EXPECT_EQ(lidar.gates_m.back(), expected.last_m);
    EXPECT_NEAR(off_axis_deg(lidar.scan.beams.front()), expected.first_beam_off_axis_deg, 1e-3);
    EXPECT_NEAR(off_axis_deg(lidar.scan.beams.back()), expected.last_beam_off_axis_deg, 1e-3);
    EXPECT_NEAR(last.gates.back().range_m, expected.last_range_m, 1e-3);
    if (expected.half_transfer_m > 0.0) {
      EXPECT_NEAR(transfer(lidar, 1.0 / expected.half_transfer_m), 0.5, 0.07 * 0.5);
    } else {
      EXPECT_EQ(last.points_m.size(), 1U);
    }
    EXPECT_EQ(describe(lidar), expected.description);
    ++found;
  }
  EXPECT_EQ(found, kSetUps.size());
}

// The corners of the four-beam lidars lie in the four quadrants.
TEST(LidarSetUpsTest, BeamsInEveryQuadrant) {
  for (const char* name : {"four_beam_pulsed", "s20_four_beam", "hm_four_beam_cw"}) {
    const LidarParams lidar =
        load_lidar(std::string(LAC_SOURCE_DIR "/config/lidars/") + name + ".yaml");
    int quadrants = 0;
    for (const LidarBeam& beam : lidar.scan.beams) {
      const int left = beam.azimuth_rad > 0.1 ? 1 : 0, up = beam.elevation_rad > 0.1 ? 2 : 0;
      EXPECT_GT(std::abs(beam.azimuth_rad), 0.1);
      EXPECT_GT(std::abs(beam.elevation_rad), 0.1);
      quadrants |= 1 << (left + up);
    }
    EXPECT_EQ(quadrants, 15) << name;
  }
}

}  // namespace
}  // namespace lac::sim
