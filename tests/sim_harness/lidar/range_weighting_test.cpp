// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/range_weighting.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "sim_harness/lidar/beam_samples.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

BeamSamples samples_of(const RangeWeighting& weighting, std::vector<double> gates_m) {
  LidarParams lidar;
  lidar.scan.beams = {{}};
  lidar.gates_m = std::move(gates_m);
  lidar.weighting = weighting;
  return make_beam_samples(lidar).front();
}

/// What a wave exp(i k s) about the centre of a gate becomes.
double transfer(const BeamSamples& beam, std::size_t g, double k_radpm) {
  const GateSamples& gate = beam.gates[g];
  std::complex<double> sum;
  for (std::size_t j = 0; j < gate.weights.size(); ++j) {
    const double s_m = beam.points_m[gate.first_point + j] - gate.range_m;
    sum += gate.weights[j] * std::polar(1.0, k_radpm * s_m);
  }
  return std::abs(sum);
}

RangeWeighting lorentzian(double rayleigh_m, double at_m, double reach, int points) {
  RangeWeighting w;
  w.kind = ProbeKind::kLorentzian;
  w.rayleigh_length_m = rayleigh_m;
  w.rayleigh_at_m = at_m;
  w.reach_rayleigh = reach;
  w.points = points;
  return w;
}

// Gaussian: exp(-(k sigma)^2/2). The quadrature ends at three standard deviations, which leaves
// 0.27 % of the volume out.
TEST(RangeWeightingTest, Gaussian) {
  RangeWeighting w;
  const BeamSamples beam = samples_of(w, {50.0, 63.3, 170.0});
  const double sigma_m = 30.0 / 2.354820045;
  for (std::size_t g = 0; g < 3; ++g) {
    for (double k = 0.0; k <= 0.15; k += 0.01) {
      EXPECT_NEAR(transfer(beam, g, k), std::exp(-0.5 * std::pow(k * sigma_m, 2)), 5e-3) << k;
    }
  }
}

// Pulse of 30 m (FWHM) through a gate of 40 m: exp(-(k sigma)^2/2) sin(k g/2)/(k g/2); with the
// points that the reader chooses and with as many as a fine quadrature.
TEST(RangeWeightingTest, PulseThroughAGate) {
  const test::TempFolder folder;
  for (const char* points : {"", "weighting_points: 51\n"}) {
    YamlReader in = YamlReader::load(folder.write(
        "w.yaml", std::string("probe: pulse\npulse_length_m: 30\ngate_length_m: 40\n") + points));
    const BeamSamples beam = samples_of(read_range_weighting(in), {60.0, 100.0, 140.0, 233.0});
    const double sigma_m = 30.0 / 2.354820045;
    for (std::size_t g = 0; g < 4; ++g) {
      EXPECT_NEAR(transfer(beam, g, 0.0), 1.0, 1e-12);
      for (double k = 0.01; k <= 0.15; k += 0.01) {
        const double box = std::sin(20.0 * k) / (20.0 * k);
        EXPECT_NEAR(transfer(beam, g, k), std::abs(std::exp(-0.5 * std::pow(k * sigma_m, 2)) * box),
                    4e-3)
            << k << " " << points;
      }
    }
  }
}

// Continuous wave with tails far out: exp(-|k| z_R) for all k z_R up to 3, within the bound on
// what is cut off (1.3 %).
TEST(RangeWeightingTest, LorentzianWithLongTails) {
  const BeamSamples beam = samples_of(lorentzian(1.0, 200.0, 100.0, 101), {200.0});
  for (double k = 0.0; k <= 3.0; k += 0.05) {
    EXPECT_NEAR(transfer(beam, 0, k), std::exp(-k), 0.013) << k;
  }
}

// Cut at 10 z_R with the usual 21 nodes: within the stated bound t (1 + exp(-k z_R))/(1 - t) of
// the whole Lorentzian and within 0.005 (k z_R <= 1) and 0.02 (<= 2) of the cut one, here by a
// trapezoidal rule with 200 000 steps.
TEST(RangeWeightingTest, CutLorentzian) {
  const BeamSamples beam = samples_of(lorentzian(2.0, 50.0, 10.0, 21), {50.0});
  EXPECT_NEAR(beam.nearest_m(), 30.0, 1e-9);
  EXPECT_NEAR(beam.farthest_m(), 70.0, 1e-9);
  const double cut = 2.0 / 3.14159265358979 * std::atan(0.1);
  EXPECT_NEAR(cut, 0.0635, 1e-4);
  for (double kz = 0.0; kz <= 2.0; kz += 0.1) {
    double whole = 0.0, wave = 0.0;
    for (int i = -100000; i <= 100000; ++i) {
      const double s = 1e-4 * i;
      const double phi = 1.0 / (1.0 + s * s) * (std::abs(i) == 100000 ? 0.5 : 1.0);
      whole += phi;
      wave += phi * std::cos(kz * s);
    }
    const double gain = transfer(beam, 0, kz / 2.0);
    EXPECT_NEAR(gain, std::abs(wave / whole), kz <= 1.0 ? 0.005 : 0.02) << kz;
    EXPECT_LE(std::abs(gain - std::exp(-kz)), cut * (1.0 + std::exp(-kz)) / (1.0 - cut)) << kz;
  }
}

// The Rayleigh length grows with the square of the distance: 1.5 m at 40 m are 6 m at 80 m, and
// of a focus at 400 m (150 m) the volume ends at the lidar.
TEST(RangeWeightingTest, RayleighLengthGrowsWithTheSquare) {
  const RangeWeighting w = lorentzian(1.5, 40.0, 10.0, 21);
  EXPECT_DOUBLE_EQ(w.rayleigh_m(80.0), 6.0);
  const BeamSamples beam = samples_of(w, {40.0, 80.0, 400.0});
  EXPECT_NEAR(transfer(beam, 1, 0.1), transfer(beam, 0, 0.4), 1e-12);
  EXPECT_NEAR(beam.nearest_m(), 0.0, 1e-9);
  EXPECT_NEAR(beam.farthest_m(), 800.0, 1e-9);
  double sum = 0.0;
  for (const double weight : beam.gates[2].weights) sum += weight;
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

// Pulsed gates 13.3 m apart share points: far fewer than nine for each of ten gates.
TEST(RangeWeightingTest, NeighbouringGatesSharePoints) {
  std::vector<double> gates_m;
  for (int g = 0; g < 10; ++g) gates_m.push_back(50.0 + 13.3 * g);
  const BeamSamples beam = samples_of({}, gates_m);
  EXPECT_LE(beam.points_m.size(), 22U);
  for (std::size_t i = 1; i < beam.points_m.size(); ++i) {
    EXPECT_NEAR(beam.points_m[i] - beam.points_m[i - 1], 2.0 * 3.0 * 30.0 / 2.354820045 / 8.0,
                1e-9);
  }
}

// Each shape wants its own keys; too few points for a long gate are refused.
TEST(RangeWeightingTest, Faults) {
  const test::TempFolder folder;
  const auto error_of = [&](const std::string& text) {
    return test::error_text([&] {
      YamlReader in = YamlReader::load(folder.write("w.yaml", text));
      read_range_weighting(in);
      in.finish();
    });
  };
  EXPECT_EQ(error_of("probe: point\n"), "no error");
  EXPECT_THAT(error_of("probe: puls\n"),
              HasSubstr("probe: found 'puls', expected gaussian, pulse, continuous_wave or point"));
  EXPECT_THAT(error_of("probe: pulse\nfwhm_m: 30\ngate_length_m: 30\n"),
              HasSubstr("pulse_length_m: the key is missing"));
  EXPECT_THAT(
      error_of("probe: pulse\npulse_length_m: 30\ngate_length_m: 100\nweighting_points: 9\n"),
      HasSubstr("w.yaml:4: weighting_points: found 9, expected a number from 11 to 201"));
  EXPECT_THAT(error_of("probe: pulse\npulse_length_m: 1\ngate_length_m: 1000\n"),
              HasSubstr("w.yaml:3: gate_length_m: the gate is so much longer"));
  EXPECT_THAT(error_of("probe: continuous_wave\nrayleigh_length_m: -2\nrayleigh_at_m: 40\n"),
              HasSubstr("w.yaml:2: rayleigh_length_m: found -2"));
  EXPECT_THAT(error_of("probe: continuous_wave\nrayleigh_length_m: 2\nrayleigh_at_m: 40\n"
                       "reach_rayleigh_lengths: 0.5\n"),
              HasSubstr("w.yaml:4: reach_rayleigh_lengths: found 0.5"));
  EXPECT_THAT(error_of("fwhm_m: .nan\n"), HasSubstr("w.yaml:1: fwhm_m: found"));
}

// Lengths so short that numbers overflow on the way are refused at their key, and so is a gate with
// more points than an int can count.
TEST(RangeWeightingTest, LengthsTooShort) {
  const test::TempFolder folder;
  const auto error_of = [&](const std::string& text) {
    return test::error_text([&] {
      YamlReader in = YamlReader::load(folder.write("a.yaml", text));
      read_range_weighting(in);
    });
  };
  EXPECT_THAT(error_of("fwhm_m: 1e-8\n"), HasSubstr("a.yaml:1: fwhm_m: expected 0 (a point) or"));
  EXPECT_EQ(error_of("fwhm_m: 0\n"), "no error");
  EXPECT_EQ(error_of("fwhm_m: 0.01\n"), "no error");
  EXPECT_THAT(error_of("{probe: pulse, pulse_length_m: 1e-9, gate_length_m: 30}\n"),
              HasSubstr("pulse_length_m: found 1e-9, expected a number from 0.01"));
  EXPECT_THAT(error_of("{probe: pulse, pulse_length_m: 0.01, gate_length_m: 1e5}\n"),
              HasSubstr("gate_length_m: the gate is so much longer than the pulse"));
  EXPECT_THAT(error_of("{probe: continuous_wave, rayleigh_length_m: 9, rayleigh_at_m: 1e-160}\n"),
              HasSubstr("rayleigh_at_m: found 1e-160, expected a number from 0.01"));
  EXPECT_THAT(error_of("{probe: continuous_wave, rayleigh_length_m: 1e-160, rayleigh_at_m: 9}\n"),
              HasSubstr("rayleigh_length_m: found 1e-160, expected a number from 0.01"));
}

}  // namespace
}  // namespace lac::sim
