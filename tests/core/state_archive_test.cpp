// SPDX-License-Identifier: Apache-2.0
#include "core/state_archive.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

namespace lac {
namespace {

enum class Mode { Off, On };

struct Inner {
  double x = 0.0;
  void visit(StateArchive& a) { a(x); }
};
struct State {
  double d = 0.0;
  float f = 0.0f;
  bool b = false;
  int i = 0;
  Mode mode = Mode::Off;
  std::vector<double> v = std::vector<double>(3);
  std::array<Inner, 2> inner{};
  void visit(StateArchive& a) { a(d), a(f), a(b), a(i), a(mode), a(v), a(inner); }
};

State sample() {
  State s;
  s.d = -0.1;
  s.f = std::numeric_limits<float>::denorm_min();
  s.b = true;
  s.i = -7;
  s.mode = Mode::On;
  s.v = {1.0, std::numeric_limits<double>::infinity(), -0.0};
  s.inner = {Inner{3.0}, Inner{std::numeric_limits<double>::quiet_NaN()}};
  return s;
}

// Every kind of field comes back bit by bit, signed zero and not-a-number included.
TEST(StateArchive, RoundTrip) {
  State from = sample(), to;
  std::vector<std::byte> bytes{std::byte{1}};  // old content is dropped
  StateArchive save(bytes);
  from.visit(save);
  StateArchive load{std::span<const std::byte>(bytes)};
  to.visit(load);
  EXPECT_TRUE(load.complete());
  EXPECT_EQ(to.d, from.d);
  EXPECT_EQ(to.f, from.f);
  EXPECT_TRUE(to.b);
  EXPECT_EQ(to.i, -7);
  EXPECT_EQ(to.mode, Mode::On);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(to.v[k]), std::bit_cast<std::uint64_t>(from.v[k]));
  }
  EXPECT_EQ(std::bit_cast<std::uint64_t>(to.inner[1].x),
            std::bit_cast<std::uint64_t>(from.inner[1].x));
}

// Too short, too long, or a vector of another length: not complete, and nothing is read astray.
TEST(StateArchive, MismatchIsNoticed) {
  State from = sample();
  std::vector<std::byte> bytes;
  StateArchive save(bytes);
  from.visit(save);
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    State to;
    StateArchive load{std::span<const std::byte>(bytes).first(n)};
    to.visit(load);
    EXPECT_FALSE(load.complete()) << n;
  }
  bytes.push_back({});
  State to;
  StateArchive longer{std::span<const std::byte>(bytes)};
  to.visit(longer);
  EXPECT_FALSE(longer.complete());
  bytes.pop_back();
  State other;
  other.v.assign(4, 9.0);
  StateArchive resized{std::span<const std::byte>(bytes)};
  other.visit(resized);
  EXPECT_FALSE(resized.complete());
  EXPECT_EQ(other.v[0], 9.0);
  EXPECT_EQ(other.inner[0].x, 0.0);
}

}  // namespace
}  // namespace lac
