// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/iec_wind.hpp"

#include <gtest/gtest.h>

#include "core/kaimal.hpp"

namespace lac::sim {
namespace {

constexpr IecClass kClassIA{WindClass::kI, TurbulenceCategory::kA};

// Turbulence intensities at 16 m/s that Schlipf et al. 2020 print: NTM A 17.6 %, ETM IA 24.6 %.
TEST(IecWind, PublishedTurbulenceIntensities) {
  EXPECT_NEAR(ntm_sigma_mps(TurbulenceCategory::kA, 16.0) / 16.0, 0.176, 5e-4);
  EXPECT_NEAR(etm_sigma_mps(kClassIA, 16.0) / 16.0, 0.246, 5e-4);
}

// NTM at the demo's wind speed by hand: I_ref (0.75 18 + 5.6) for the three categories.
TEST(IecWind, NormalTurbulenceAt18) {
  EXPECT_NEAR(ntm_sigma_mps(TurbulenceCategory::kA, 18.0), 3.056, 1e-12);
  EXPECT_NEAR(ntm_sigma_mps(TurbulenceCategory::kB, 18.0), 2.674, 1e-12);
  EXPECT_NEAR(ntm_sigma_mps(TurbulenceCategory::kC, 18.0), 2.292, 1e-12);
}

// ETM by hand in another class: c I (0.072 (V_ave/c + 3)(V/c - 4) + 10), V_ave = 7.5 m/s, IIIC.
TEST(IecWind, ExtremeTurbulenceInClassThree) {
  const IecClass iec{WindClass::kIII, TurbulenceCategory::kC};
  EXPECT_NEAR(etm_sigma_mps(iec, 20.0), 0.24 * (0.072 * 6.75 * 6.0 + 10.0), 1e-12);
}

// The scale 0.7 z_hub stops at 60 m, and is the one behind the Kaimal length scales.
TEST(IecWind, TurbulenceScale) {
  EXPECT_DOUBLE_EQ(turbulence_scale_m(50.0), 35.0);
  EXPECT_DOUBLE_EQ(turbulence_scale_m(90.0), 42.0);
  EXPECT_DOUBLE_EQ(8.1 * turbulence_scale_m(50.0), iec_kaimal(1.0, 50.0).u.length_scale_m);
}

// Gust magnitude by hand: turbulence decides at 18 m/s, V_e1 close to it.
TEST(IecWind, GustMagnitude) {
  EXPECT_NEAR(eog_magnitude_mps(kClassIA, 18.0, 90.0, 126.0), 3.3 * 3.056 / 1.3, 1e-12);
  EXPECT_NEAR(eog_magnitude_mps(kClassIA, 54.0, 90.0, 126.0), 1.35 * 2.0, 1e-12);
}

// Closed form of the gust: peak 0.74 V_gust at T/2, symmetric, nothing before and after.
TEST(IecWind, GustShape) {
  EXPECT_NEAR(eog_deviation_mps(10.0, 5.25), 7.4, 1e-12);
  EXPECT_NEAR(eog_deviation_mps(10.0, 2.0), eog_deviation_mps(10.0, 8.5), 1e-12);
  EXPECT_EQ(eog_deviation_mps(10.0, -0.01), 0.0);
  EXPECT_EQ(eog_deviation_mps(10.0, 10.51), 0.0);
  EXPECT_NEAR(eog_deviation_mps(10.0, 0.01), 0.0, 1e-5);
}

// The lowest value lies where the derivative is zero, sin^2(pi t/T) = 9/20:
// 0.37 * 2 * 0.45^1.5 * (3 - 4 * 0.45) below the mean.
TEST(IecWind, GustDip) {
  double lowest = 0.0, at_s = 0.0;
  for (int i = 0; i < 52500; ++i) {
    const double t = 1e-4 * i;
    const double v = eog_deviation_mps(1.0, t);
    if (v < lowest) lowest = v, at_s = t;
  }
  EXPECT_NEAR(lowest, -0.74 * std::pow(0.45, 1.5) * 1.2, 1e-8);
  EXPECT_NEAR(at_s, 10.5 / kPi * std::asin(std::sqrt(0.45)), 2e-4);
}

}  // namespace
}  // namespace lac::sim
