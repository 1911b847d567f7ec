// SPDX-License-Identifier: Apache-2.0
#include "core/swap_view.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace lac {
namespace {

std::vector<float> array_with(float signature, float size) {
  std::vector<float> a(164);
  a[65] = signature;
  a[128] = size;
  return a;
}

// Record 129 is the length only together with the signature in record 66, and only if it is one.
TEST(SwapView, KnownArraySize) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(known_array_size(array_with(1001.0f, 3300.0f).data()), 3300);
  EXPECT_EQ(known_array_size(array_with(1001.0f, 164.0f).data()), 164);
  for (const float size : {0.0f, 163.0f, -5.0f, 1.0e7f, kNan}) {
    EXPECT_EQ(known_array_size(array_with(1001.0f, size).data()), 164) << size;
  }
  for (const float signature : {0.0f, 1000.0f, kNan}) {
    EXPECT_EQ(known_array_size(array_with(signature, 3300.0f).data()), 164) << signature;
  }
}

// Counted from 1: record 1 is element 0.
TEST(SwapView, CountsFromOne) {
  std::vector<float> a(164);
  SwapView view(a.data(), 164);
  view.set(Rec::GeneratorSpeed, 122.5);
  view.put(1, -1.0);
  EXPECT_EQ(a[19], 122.5f);
  EXPECT_EQ(a[0], -1.0f);
  EXPECT_TRUE(view.holds(1) && view.holds(164));
  EXPECT_FALSE(view.holds(0) || view.holds(165));
  EXPECT_TRUE(view.holds(kHostBlock));
  EXPECT_FALSE(view.holds(kPlatformBlock));
}

// Rounds to the nearest, half away from zero, and has an answer for everything else.
TEST(SwapView, IntegerRounds) {
  std::vector<float> a(164);
  SwapView view(a.data(), 164);
  const auto integer = [&](float v) {
    a[0] = v;
    return view.integer(1, 77);
  };
  EXPECT_EQ(integer(-1.0f), -1);
  EXPECT_EQ(integer(0.5f), 1);
  EXPECT_EQ(integer(-0.5f), -1);
  EXPECT_EQ(integer(0.49999997f), 0);  // the largest float below one half
  EXPECT_EQ(integer(-10.9f), -11);
  EXPECT_EQ(integer(8388609.0f), 8388609);
  EXPECT_EQ(integer(2.0e9f), 77);
  EXPECT_EQ(integer(std::numeric_limits<float>::quiet_NaN()), 77);
  EXPECT_EQ(integer(-std::numeric_limits<float>::infinity()), 77);
}

}  // namespace
}  // namespace lac
