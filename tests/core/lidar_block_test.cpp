// SPDX-License-Identifier: Apache-2.0
#include "core/lidar_block.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lac {
namespace {

LidarMeasurement sample() {
  LidarMeasurement m;
  m.time_s = 12.25;
  m.beam_id = 2;
  m.beam_dir_L = beam_direction(rad_from_deg(-14.4), rad_from_deg(14.0));
  m.position_I_m = {-1.5, 0.25, 92.0};
  m.roll_rad = 0.01;
  m.pitch_rad = -0.02;
  m.yaw_rad = 3.0;
  m.velocity_I_mps = {0.5, -0.25, 0.125};
  m.gate_count = 10;
  for (int g = 0; g < 10; ++g) {
    m.gates[static_cast<std::size_t>(g)] = {50.0 + g, 16.0 + 0.5 * g, g != 3, -8.0 - g};
  }
  return m;
}

// What goes into the native block comes out, to float precision, inside the block's records.
TEST(LidarBlock, NativeRoundTrip) {
  std::vector<float> array(kExtendedArraySize, -7.0f);
  const SwapView swap(array.data(), kExtendedArraySize);
  write_native_lidar(swap, sample(), true);
  ASSERT_TRUE(native_lidar_present(swap));
  ASSERT_TRUE(native_lidar_is_new(swap));
  LidarMeasurement back;
  read_native_lidar(swap, back);
  const LidarMeasurement m = sample();
  EXPECT_EQ(back.time_s, m.time_s);
  EXPECT_EQ(back.beam_id, 2);
  EXPECT_EQ(back.gate_count, 10);
  EXPECT_NEAR(norm(back.beam_dir_L - m.beam_dir_L), 0.0, 1e-7);
  EXPECT_NEAR(norm(back.beam_dir_I() - m.beam_dir_I()), 0.0, 1e-6);
  EXPECT_EQ(back.velocity_I_mps, m.velocity_I_mps);
  EXPECT_EQ(back.position_I_m, m.position_I_m);
  EXPECT_EQ(back.gates[9].speed_mps, 20.5);
  EXPECT_FALSE(back.gates[3].valid);
  EXPECT_TRUE(back.gates[4].valid);
  EXPECT_EQ(back.gates[5].cnr_db, -13.0);
  for (int r = 1; r <= kExtendedArraySize; ++r) {
    const bool inside = r >= kNativeLidarBlock.first && r <= kNativeLidarBlock.last();
    if (!inside) {
      ASSERT_EQ(array[static_cast<std::size_t>(r - 1)], -7.0f) << "record " << r;
    }
  }
}

// Between measurements only the flag falls.
TEST(LidarBlock, FlagFallsAndTheRestStays) {
  std::vector<float> array(kExtendedArraySize, 0.0f);
  const SwapView swap(array.data(), kExtendedArraySize);
  write_native_lidar(swap, sample(), true);
  write_native_lidar(swap, {}, false);
  EXPECT_FALSE(native_lidar_is_new(swap));
  LidarMeasurement back;
  read_native_lidar(swap, back);
  EXPECT_EQ(back.beam_id, 2);
}

// Records of Guo's block with one gate at 165, as listed for the public chain.
TEST(LidarBlock, GuoLayoutAtItsPublishedRecords) {
  std::vector<float> array(464, 0.0f);
  SwapView swap(array.data(), 464);
  swap.set(Rec::LogStart, 165);
  const float block[] = {1, 3, 1, 14.5f, 0.01f, 0.02f, 3.14f, 0.1f, 0.2f, 0.3f};
  std::copy(std::begin(block), std::end(block), array.begin() + 164);
  const GuoBlock found = find_guo_block(array.data());
  EXPECT_EQ(found.first, 165);
  EXPECT_EQ(found.gates, 1);
  EXPECT_TRUE(guo_lidar_is_new(array.data(), found));
  LidarMeasurement m;
  read_guo_lidar(array.data(), found, m);
  EXPECT_EQ(m.beam_id, 3);
  EXPECT_EQ(m.gates[0].speed_mps, 14.5);
  EXPECT_FLOAT_EQ(static_cast<float>(m.yaw_rad), 3.14f);
  EXPECT_FLOAT_EQ(static_cast<float>(m.velocity_I_mps.z), 0.3f);
}

// Record 63 of a host without such a block, or a senseless gate count, is not followed.
TEST(LidarBlock, NonsenseAtRecord63IsNotFollowed) {
  std::vector<float> array(kExtendedArraySize, 0.0f);
  SwapView swap(array.data(), kExtendedArraySize);
  for (const float start : {0.0f, 63.0f, -5.0f, 3.0e9f, 3299.0f}) {
    swap.set(Rec::LogStart, static_cast<double>(start));
    EXPECT_EQ(find_guo_block(array.data()).first, 0) << start;
  }
  swap.set(Rec::LogStart, 3280);  // room for 8 gates and no more
  array[3281] = 8.0f;
  EXPECT_EQ(find_guo_block(array.data()).gates, 8);
  array[3281] = 9.0f;
  EXPECT_EQ(find_guo_block(array.data()).first, 0);
  swap.set(Rec::LogStart, 165);
  for (const float gates : {0.0f, -1.0f, 51.0f, 1.0e20f, std::nanf("")}) {
    array[166] = gates;
    EXPECT_EQ(find_guo_block(array.data()).first, 0) << gates;
  }
}

// OpenFAST's block at the records in which it was received: five gates, four beams, one point.
TEST(LidarBlock, OpenFastLayoutAtItsObservedRecords) {
  std::vector<float> array(kExtendedArraySize, 0.0f);
  for (int r = 2001; r <= 2024; ++r) array[static_cast<std::size_t>(r - 1)] = static_cast<float>(r);
  const SwapView swap(array.data(), kExtendedArraySize);
  EXPECT_EQ(read_openfast_header(swap), (OpenFastHeader{2001, 2002, 2003}));
  EXPECT_EQ(openfast_speed(swap, 0), 2005.0);
  EXPECT_EQ(openfast_speed(swap, 4), 2009.0);
  EXPECT_EQ(openfast_x(swap, 0, 5), 2010.0);
  EXPECT_EQ(openfast_x(swap, 4, 5), 2014.0);
  EXPECT_EQ(openfast_x(swap, 0, 4), 2009.0);
  EXPECT_EQ(openfast_x(swap, 0, 1), 2006.0);
  EXPECT_EQ((OpenFastHeader{3, 1, 5}).points(), 5);
  EXPECT_EQ((OpenFastHeader{1, 4, 1}).points(), 4);
  EXPECT_EQ((OpenFastHeader{1, 4, 2}).points(), 0);
  EXPECT_EQ((OpenFastHeader{1, 6, 1}).points(), 0);
}

// z-y'-x'': positive pitch turns x towards -z, yaw of pi looks up-wind and mirrors y.
TEST(LidarBlock, RotationOrderAndSigns) {
  const Vec3 x{1, 0, 0};
  EXPECT_NEAR((rotation_from_roll_pitch_yaw(0, 0.1, 0) * x).z, -std::sin(0.1), 1e-15);
  const Vec3 left = rotation_from_roll_pitch_yaw(0, 0, kPi) * beam_direction(0.2, 0.0);
  EXPECT_NEAR(left.x, -std::cos(0.2), 1e-15);
  EXPECT_NEAR(left.y, -std::sin(0.2), 1e-15);
  // Rz(90 deg) Ry(90 deg) Rx(90 deg): x -> -z, y -> ... computed by hand from the three matrices.
  const Rotation r = rotation_from_roll_pitch_yaw(kPi / 2, kPi / 2, kPi / 2);
  EXPECT_NEAR(norm(r * Vec3{1, 0, 0} - Vec3{0, 0, -1}), 0.0, 1e-15);
  EXPECT_NEAR(norm(r * Vec3{0, 1, 0} - Vec3{0, 1, 0}), 0.0, 1e-15);
  EXPECT_NEAR(norm(r * Vec3{0, 0, 1} - Vec3{1, 0, 0}), 0.0, 1e-15);
}

}  // namespace
}  // namespace lac
