// SPDX-License-Identifier: Apache-2.0
#include "bridge/tower_signal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lac {
namespace {

constexpr double kStep_s = 0.0125;
constexpr double kGain = 0.01;

/// A tower damper as ROSCO has it: it reads single-precision records and integrates in double.
struct Damper {
  double heading_rad = 0.0;
  double angle_rad = 0.0;
  void step(const TowerSignal::Outputs& a) {
    const double x = static_cast<double>(a.fore_aft_mps2),
                 y = static_cast<double>(a.side_side_mps2);
    angle_rad += kStep_s * kGain * (x * std::cos(heading_rad) + y * std::sin(heading_rad));
  }
};

// One step of 0.02 rad/s is 2 m/s^2 at a gain of 0.01, along the nacelle.
TEST(TowerSignal, RateOverGain) {
  const TowerSignal signal(kGain, kStep_s);
  TowerSignal::State s;
  const TowerSignal::Outputs straight = signal.step(0.02 * kStep_s, 0.0, s);
  EXPECT_FLOAT_EQ(straight.fore_aft_mps2, 2.0F);
  EXPECT_EQ(straight.side_side_mps2, 0.0F);
  s = {};
  const TowerSignal::Outputs turned = signal.step(0.02 * kStep_s, 0.3, s);
  EXPECT_FLOAT_EQ(turned.fore_aft_mps2, static_cast<float>(2.0 * std::cos(0.3)));
  EXPECT_FLOAT_EQ(turned.side_side_mps2, static_cast<float>(2.0 * std::sin(0.3)));
}

// The damper's angle is the wanted one at every step, also after an hour and any nacelle
// direction: the rounding of the records (6e-8 of a step of at most 5e-4 rad) does not add up.
TEST(TowerSignal, TheDamperHoldsTheWantedAngle) {
  for (const double heading_rad : {0.0, 0.3, 1.5707963, 3.9}) {
    const TowerSignal signal(kGain, kStep_s);
    TowerSignal::State s;
    Damper damper{heading_rad, 0.0};
    double largest = 0.0;
    for (int i = 0; i < 288000; ++i) {
      const double wanted_rad = 0.08 * std::sin(0.5 * i * kStep_s);
      damper.step(signal.step(wanted_rad, heading_rad, s));
      largest = std::max(largest, std::abs(damper.angle_rad - wanted_rad));
    }
    EXPECT_LT(largest, 1e-10);
  }
}

// Nothing wanted, nothing given: nothing sent. After a fade the rest dies out.
TEST(TowerSignal, ZeroStaysZero) {
  const TowerSignal signal(kGain, kStep_s);
  TowerSignal::State s;
  EXPECT_EQ(signal.step(0.0, 1.0, s).fore_aft_mps2, 0.0F);
  signal.step(0.01, 1.0, s);
  for (int i = 0; i < 10; ++i) signal.step(0.0, 1.0, s);
  EXPECT_LT(std::abs(signal.step(0.0, 1.0, s).fore_aft_mps2), 1e-12F);
}

}  // namespace
}  // namespace lac
