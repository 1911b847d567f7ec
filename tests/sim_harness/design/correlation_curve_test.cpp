// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/correlation_curve.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace lac::sim {
namespace {

using testing::SizeIs;

/// S_RR = 4, S_LL = 2, S_RL = i; with a plane left out S_LL = 3; all over k1 U.
class PlainModel : public CorrelationModel {
 public:
  std::vector<RotorLidarSpectra> at(double k1_radpm,
                                    const std::vector<double>& speeds_mps) const override {
    std::vector<RotorLidarSpectra> all;
    for (const double u : speeds_mps) {
      const double scale = 1.0 / (k1_radpm * u);
      all.push_back({4.0 * scale, {2.0 * scale, 3.0 * scale}, {{0.0, scale}, {0.0, scale}}});
    }
    return all;
  }
};

CurveSettings settings(double scan_time_s, int threads = 1) {
  return {.first_k1_radpm = 0.001,
          .last_k1_radpm = 0.1,
          .points = 21,
          .threads = threads,
          .scan_time_s = scan_time_s};
}

// Two-sided in k1 to one-sided in f: 4 pi / U; ratios do not care.
TEST(CorrelationCurves, AreOneSidedInFrequency) {
  const CorrelationCurves curves(PlainModel(), {8.0, 20.0}, settings(0.0, 2));
  const CorrelationCurve c = curves.curve(1);
  ASSERT_THAT(c.k1_radpm, SizeIs(21));
  EXPECT_NEAR(c.k1_radpm[10], 0.01, 1e-15);
  EXPECT_NEAR(c.frequency_hz(10), 0.2 / (2.0 * kPi), 1e-15);
  EXPECT_NEAR(c.s_rr[10], 4.0 / (0.01 * 20.0) * 4.0 * kPi / 20.0, 1e-9);
  EXPECT_NEAR(c.coherence()[10], 1.0 / 8.0, 1e-12);
  EXPECT_NEAR(c.gain()[10], 0.5, 1e-12);
  EXPECT_NEAR(curves.curve(1, 1).gain()[10], 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(c.lateness_s()[10], 0.5 * kPi / (0.01 * 20.0), 1e-9);
}

// The average over a scan costs S_LL sinc^2 and S_RL sinc: the coherence stays, the gain grows.
TEST(CorrelationCurves, AverageOverAScan) {
  const CorrelationCurve c = CorrelationCurves(PlainModel(), {20.0}, settings(2.0)).curve(0);
  const double x = kPi * c.frequency_hz(20) * 2.0;
  EXPECT_NEAR(c.coherence()[20], 1.0 / 8.0, 1e-12);
  EXPECT_NEAR(c.gain()[20], 0.5 * x / std::sin(x), 1e-12);
}

TEST(CorrelationCurves, RefuseSettingsOutOfRange) {
  const PlainModel model;
  CurveSettings falling = settings(0.0);
  falling.last_k1_radpm = 0.0005;
  EXPECT_THROW(CorrelationCurves(model, {8.0}, falling), Error);
  EXPECT_THROW(CorrelationCurves(model, {0.0}, settings(0.0)), Error);
}

}  // namespace
}  // namespace lac::sim
