// SPDX-License-Identifier: Apache-2.0
#include "core/call_strings.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lac {
namespace {

// As hosts send it: with and without the terminator counted, rubbish or nothing behind it,
// padded with blanks.
TEST(CallStrings, ReadsWhatHostsSend) {
  const std::vector<char> exact{'a', '.', 'I', 'N'};  // not terminated at all
  EXPECT_EQ(read_string(exact.data(), 4), "a.IN");
  EXPECT_EQ(read_string("a.IN\0rubbish", 5), "a.IN");
  EXPECT_EQ(read_string("a.IN\0rubbish", 12), "a.IN");
  EXPECT_EQ(read_string("a b.IN    ", 10), "a b.IN");
  EXPECT_EQ(read_string("a.IN", 2), "a.");
}

// Nothing sensible gives nothing.
TEST(CallStrings, NothingSensible) {
  EXPECT_EQ(read_string(nullptr, 5), "");
  EXPECT_EQ(read_string("abc", 0), "");
  EXPECT_EQ(read_string("abc", -3), "");
  EXPECT_EQ(read_string("abc", kLongestString + 1), "");
  EXPECT_EQ(read_string("   ", 3), "");
}

// Never more than the capacity, always terminated, nothing where there is no room.
TEST(CallStrings, WritesWithinCapacity) {
  for (int capacity = 0; capacity <= 8; ++capacity) {
    std::vector<char> target(9, '#');
    write_string(target.data(), capacity, "hello");
    const std::string expected =
        capacity == 0 ? "" : std::string("hello").substr(0, static_cast<std::size_t>(capacity) - 1);
    if (capacity > 0) {
      EXPECT_STREQ(target.data(), expected.c_str());
    }
    for (std::size_t i = static_cast<std::size_t>(capacity); i < target.size(); ++i) {
      EXPECT_EQ(target[i], '#') << capacity;
    }
  }
  write_string(nullptr, 10, "hello");
}

}  // namespace
}  // namespace lac
