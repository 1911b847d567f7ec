// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/box_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"
#include "tests/sim_harness/wind/wind_bytes.hpp"

namespace lac::sim {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// 2 planes of 3 rows with 2 heights.
const GridSpec kSpec{3, 2, 2, 10.0, 12.0, 0.5, 84.0, 90.0, 16.0, true};

class BoxFile : public testing::Test {
 protected:
  /// The numbers 0 ... 11 in the order of the file, a hundred more in v, two hundred in w.
  BoxFiles hand_made() {
    for (int c = 0; c < 3; ++c) {
      std::string bytes;
      for (int i = 0; i < 12; ++i) append(bytes, 100.0F * c + i);
      folder_.write(files_[c].filename().string(), bytes);
    }
    return files_;
  }
  std::string error() {
    return test::error_text([&] { read_box(files_, kSpec); });
  }

  test::TempFolder folder_;
  BoxFiles files_ = box_files(folder_.path() / "box.bin");
};

// Names as TurbSim has them, and those of others from that of u.
TEST_F(BoxFile, Names) {
  const auto names = [](const char* name) {
    const BoxFiles files = box_files(name);
    return files[0].string() + " " + files[1].string() + " " + files[2].string();
  };
  EXPECT_EQ(names("a/box.bin"), "a/box-u.bin a/box-v.bin a/box-w.bin");
  EXPECT_EQ(names("a/box-u.bin"), "a/box-u.bin a/box-v.bin a/box-w.bin");
  EXPECT_EQ(names("turbu.turb"), "turbu.turb turbv.turb turbw.turb");
  EXPECT_EQ(names("b_8x4x4.u"), "b_8x4x4.u b_8x4x4.v b_8x4x4.w");
}

// z fastest, then y from the left, the first plane first: what InflowWind makes of
// VelRaw(IZ, NYGrids:1:-1) plane by plane. The mean speed comes to u alone.
TEST_F(BoxFile, OrderOfHawc2AndInflowWind) {
  const GriddedWind wind = read_box(hand_made(), kSpec);
  EXPECT_EQ(wind.velocity({0.0, 10.0, 84.0}, 0.0), (Vec3{16.0, 100.0, 200.0}));
  EXPECT_EQ(wind.velocity({0.0, 10.0, 96.0}, 0.0), (Vec3{17.0, 101.0, 201.0}));
  EXPECT_EQ(wind.velocity({0.0, 0.0, 84.0}, 0.0), (Vec3{18.0, 102.0, 202.0}));
  EXPECT_EQ(wind.velocity({0.0, -10.0, 96.0}, 0.0), (Vec3{21.0, 105.0, 205.0}));
  EXPECT_EQ(wind.velocity({0.0, 10.0, 84.0}, 0.5), (Vec3{22.0, 106.0, 206.0}));
}

// Mann's own frame, x down-wind and y to the left: the last plane meets the rotor first, so the
// plane that is further down-wind in the box is further down-wind in space.
TEST_F(BoxFile, OrderOfTheMannFrame) {
  const GriddedWind wind = read_box(hand_made(), kSpec, BoxOrder::mann_frame());
  EXPECT_EQ(wind.velocity({0.0, -10.0, 84.0}, 0.0), (Vec3{22.0, 106.0, 206.0}));
  EXPECT_EQ(wind.velocity({0.0, 10.0, 96.0}, 0.5), (Vec3{21.0, 105.0, 205.0}));
  EXPECT_EQ(wind.velocity({-8.0, -10.0, 84.0}, 0.0), (Vec3{16.0, 100.0, 200.0}));
}

// Write and read gives the field back to float rounding of the mean, in either order.
TEST_F(BoxFile, RoundTrip) {
  for (const BoxOrder order : {BoxOrder{}, BoxOrder::mann_frame(), BoxOrder{true, false}}) {
    const GriddedWind wind = wavy(true);
    write_box(files_, wind, order);
    const GriddedWind back = read_box(files_, wind.grid().spec(), order);
    for (int it = 0; it < 50; ++it) {
      for (int k = 0; k < 36; ++k)
        EXPECT_NEAR(back.grid().plane(it)[k], wind.grid().plane(it)[k], 2e-6);
    }
  }
}

// What is written is less the mean speed, and mirrored: the first number of a plane belongs to the
// left, lowest point.
TEST_F(BoxFile, WritesLessTheMean) {
  const GriddedWind wind = wavy(true);
  write_box(files_, wind);
  const std::string u = folder_.read("box-u.bin"), v = folder_.read("box-v.bin");
  ASSERT_EQ(u.size(), 4u * 50 * 12);
  float first_u, first_v;
  std::memcpy(&first_u, u.data(), 4);
  std::memcpy(&first_v, v.data(), 4);
  EXPECT_FLOAT_EQ(first_u, wind.grid().at(0, 0, 3, 0) - 12.5F);
  EXPECT_EQ(first_v, wind.grid().at(0, 0, 3, 1));
}

// Wrong sizes and numbers that are no wind: which file, where, what instead.
TEST_F(BoxFile, RefusesForeignFiles) {
  hand_made();
  const std::string v = folder_.read("box-v.bin");
  folder_.write("box-v.bin", v.substr(0, 40));
  EXPECT_THAT(error(), AllOf(HasSubstr("box-v.bin: offset 0: velocities: found 40 bytes"),
                             HasSubstr("expected 48"), HasSubstr("truncated")));
  folder_.write("box-v.bin", v + v);
  EXPECT_THAT(error(), HasSubstr("longer than a turbulence box of this many points"));
  folder_.write("box-v.bin", with_value(v, 44, 1e9F));
  EXPECT_THAT(error(), HasSubstr("box-v.bin: offset 44: velocity [m/s]: found 1e+09, expected "
                                 "-300 to 300 in a turbulence box"));
  folder_.write("box-v.bin", with_value(v, 4, std::nanf("")));
  EXPECT_THAT(error(), HasSubstr("offset 4: velocity [m/s]: found nan"));
  std::filesystem::remove(files_[1]);
  EXPECT_THAT(error(), HasSubstr("box-v.bin: cannot be opened"));
}

}  // namespace
}  // namespace lac::sim
