// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/blade_blockage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

constexpr int kAzimuths = 36000;
constexpr double kResolution = 6.0 / kAzimuths;  // each blade's two edges, one step each

/// The same section from 1 to 60 m.
BladeBlockage blades(double chord_m, double thickness_m = 0.0, double twist_rad = 0.0,
                     double beam_radius_m = 0.0, int number = 3) {
  const std::vector<double> r{1.0, 60.0};
  const auto both = [&](double v) { return LookupTable(r, {v, v}); };
  BladeBlockageParams p;
  p.enabled = true;
  p.blade = {both(chord_m), both(thickness_m), both(twist_rad)};
  p.beam_radius_m = beam_radius_m;
  return {p, number};
}

/// From `behind_m` behind the rotor on its axis to (0, y, z).
LidarRay ray_through(double y_m, double z_m, double behind_m = 4.0) {
  const Vec3 way{-behind_m, y_m, z_m};
  return {{behind_m, 0.0, 0.0}, (1.0 / norm(way)) * way};
}

double share_blocked(const BladeBlockage& b, const LidarRay& ray, double pitch_rad = 0.0) {
  int count = 0;
  for (int i = 0; i < kAzimuths; ++i) {
    count += b.blocked(ray, 2.0 * kPi * i / kAzimuths, pitch_rad);
  }
  return static_cast<double>(count) / kAzimuths;
}

// Averaged over a revolution: (blades / pi) asin((c/2)/r), whatever the direction and however far
// behind; for a narrow blade blades c / (2 pi r).
TEST(BladeBlockage, ShareOfARevolution) {
  for (const double r : {5.0, 20.0, 50.0}) {
    const double expected = 3.0 / kPi * std::asin(1.5 / r);
    EXPECT_NEAR(share_blocked(blades(3.0), ray_through(0.6 * r, -0.8 * r)), expected, kResolution);
    EXPECT_NEAR(share_blocked(blades(3.0), ray_through(r, 0.0, 9.0)), expected, kResolution);
  }
  EXPECT_NEAR(share_blocked(blades(3.0), ray_through(0.0, 50.0)), 3 * 3.0 / (2 * kPi * 50.0),
              kResolution);
  EXPECT_NEAR(share_blocked(blades(3.0, 0, 0, 0, 2), ray_through(0.0, 50.0)),
              2 * 3.0 / (2 * kPi * 50.0), kResolution);
}

// A beam of radius 0.1 m widens each edge by that much across the beam: seen along the blade it
// passes the axis at d sin(Delta) tan(theta) / hypot(1, tan(theta) sin(Delta)); steep rays through
// r = 20 m, 400 m behind make that r sin(Delta) to 0.1 %.
TEST(BladeBlockage, BeamRadius) {
  EXPECT_NEAR(share_blocked(blades(3.0, 0.0, 0.0, 0.1), ray_through(20.0, 0.0, 400.0)),
              3.0 / kPi * std::asin(1.6 / 20.0), kResolution);
}

// Pitch and twist turn the chord out of the plane: a flat section at 60 deg seen along the axis
// (far behind) is half as wide, and a circular one as wide as ever.
TEST(BladeBlockage, SeenWidth) {
  const LidarRay far = ray_through(0.0, 20.0, 1e6);
  const double half = 3.0 / kPi * std::asin(0.75 / 20.0);
  EXPECT_NEAR(share_blocked(blades(3.0), far, rad_from_deg(60.0)), half, kResolution);
  EXPECT_NEAR(share_blocked(blades(3.0, 0.0, rad_from_deg(20.0)), far, rad_from_deg(40.0)), half,
              kResolution);
  EXPECT_NEAR(share_blocked(blades(3.0, 3.0), far, rad_from_deg(60.0)),
              3.0 / kPi * std::asin(1.5 / 20.0), kResolution);
}

// Feathered blades, leading edge up-wind, seen 40 deg off the axis. The lidar sits beside the axis
// and looks across it, along the way of rotation of blade 1, up: that blade shows its flat side,
// 3 m sin 40 deg wide across the beam, centred on its axis.
TEST(BladeBlockage, ObliqueBeamOnAFeatheredBlade) {
  const double sin = std::sin(rad_from_deg(40.0)), cos = std::cos(rad_from_deg(40.0));
  const double behind_m = 10.0;
  const auto blocked_at = [&](double aside_m) {  // of the axis, in the rotor plane
    const LidarRay ray{{behind_m, behind_m * sin / cos + aside_m, 20.0}, {-cos, -sin, 0.0}};
    return blades(3.0).blocked(ray, 0.0, 0.5 * kPi);
  };
  const double edge_m = 1.5 * sin / cos;  // in the rotor plane
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(blocked_at(sign * (edge_m - 0.01)));
    EXPECT_FALSE(blocked_at(sign * (edge_m + 0.01)));
  }
}

// Partly pitched, the leading edge is up-wind: a beam that slants along the chord passes by its
// edge, one that slants the other way sees the flat side.
TEST(BladeBlockage, SideOfPitch) {
  const double sin = std::sin(rad_from_deg(60.0)), cos = std::cos(rad_from_deg(60.0));
  const auto width_seen = [&](double slant, double thickness_m) {
    int hits = 0;
    for (int i = -300; i <= 300; ++i) {
      const LidarRay ray{{10.0, slant * 10.0 * sin / cos + 0.01 * i / cos, 20.0},
                         {-cos, -slant * sin, 0.0}};
      hits += blades(3.0, thickness_m).blocked(ray, 0.0, rad_from_deg(30.0));
    }
    return 0.01 * hits;
  };
  EXPECT_NEAR(width_seen(1.0, 0.0), 0.0, 0.02);         // looks along the chord
  EXPECT_NEAR(width_seen(-1.0, 0.0), 3.0 * sin, 0.02);  // 60 deg to it
  EXPECT_NEAR(width_seen(1.0, 2.0), 2.0, 0.02);         // along the chord: the thickness
  EXPECT_NEAR(width_seen(-1.0, 2.0), std::hypot(3.0 * sin, 2.0 * cos), 0.02);
}

// A beam that looks away from the rotor passes no blade.
TEST(BladeBlockage, LookingDownWind) {
  EXPECT_FALSE(blades(3.0).blocked({{4.0, 0.0, 20.0}, {0.8, 0.0, 0.6}}, 0.0, 0.0));
}

// Blade 1 points up at azimuth 0 and turns clockwise seen from up-wind, towards -y.
TEST(BladeBlockage, Azimuth) {
  const BladeBlockage one = blades(2.0, 0.0, 0.0, 0.0, 1);
  EXPECT_TRUE(one.blocked(ray_through(0.0, 20.0), 0.0, 0.0));
  EXPECT_FALSE(one.blocked(ray_through(0.0, -20.0), 0.0, 0.0));
  EXPECT_TRUE(one.blocked(ray_through(-20.0, 0.0), 0.5 * kPi, 0.0));
  EXPECT_FALSE(one.blocked(ray_through(20.0, 0.0), 0.5 * kPi, 0.0));
}

// Never: on the spinner or in the rotor plane, inside the root, beyond the tip, switched off.
TEST(BladeBlockage, NeverBlocked) {
  const BladeBlockage b = blades(3.0);
  const Vec3 out = (1.0 / std::sqrt(2.0)) * Vec3{-1.0, 0.0, 1.0};
  EXPECT_EQ(share_blocked(b, {{-2.0, 0.0, 0.0}, out}), 0.0);
  EXPECT_EQ(share_blocked(b, {{0.0, 0.0, 0.0}, out}), 0.0);
  EXPECT_EQ(share_blocked(b, ray_through(0.0, 0.9, 400.0)), 0.0);
  EXPECT_EQ(share_blocked(b, ray_through(0.0, 60.5, 400.0)), 0.0);
  EXPECT_EQ(share_blocked({{}, 3}, ray_through(0.0, 20.0)), 0.0);
}

constexpr char kBlade[] =
    "radius_m: [1, 60]\nchord_m: [3, 1]\nrelative_thickness: [1, 0.2]\ntwist_deg: [13, 0]\n";

TEST(BladeBlockage, BladeFile) {
  const test::TempFolder folder;
  const BladeShape b = load_blade(folder.write("blade.yaml", kBlade));
  EXPECT_EQ(b.root_m(), 1.0);
  EXPECT_EQ(b.tip_m(), 60.0);
  EXPECT_NEAR(b.thickness_m.at(60.0), 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(b.twist_rad.at(30.5), rad_from_deg(6.5));
  const auto error = [&](const std::string& from, const std::string& to) {
    std::string text = kBlade;
    text.replace(text.find(from), from.size(), to);
    return test::error_text([&] { load_blade(folder.write("blade.yaml", text)); });
  };
  EXPECT_THAT(error("[3, 1]", "[3]"),
              HasSubstr("blade.yaml:2: chord_m: found 1 values, expected 2, one per value of"));
  EXPECT_THAT(error("[1, 60]", "[60, 1]"), HasSubstr("radius_m: expected radii that rise"));
}

// The shipped blade is that of the report: chord at 15.85 m, tip at 63 m.
TEST(BladeBlockage, ShippedBlade) {
  const BladeShape b = load_blade(LAC_SOURCE_DIR "/config/turbines/nrel5mw/blade.yaml");
  EXPECT_DOUBLE_EQ(b.chord_m.at(15.85), 4.652);
  EXPECT_DOUBLE_EQ(b.tip_m(), 63.0);
}

}  // namespace
}  // namespace lac::sim
