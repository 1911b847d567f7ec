// SPDX-License-Identifier: Apache-2.0
#include "wrapper/warning_filter.hpp"

#include <gtest/gtest.h>

#include <string>

namespace lac {
namespace {

TEST(WarningFilter, StandingTextOnce) {
  WarningFilter f;
  EXPECT_TRUE(f.admit("a", 0.0));
  EXPECT_FALSE(f.admit("a", 0.1));
  EXPECT_TRUE(f.admit("b", 0.2));
  EXPECT_TRUE(f.admit("a", 0.3));
  f.quiet();
  EXPECT_TRUE(f.admit("a", 0.5));
  EXPECT_EQ(f.hidden(), 0);
}

// Five at once, the sixth when 10 s have passed; a text that still stands then is shown late.
TEST(WarningFilter, Credit) {
  WarningFilter f;
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(f.admit(std::to_string(i), 0.0));
  EXPECT_FALSE(f.admit("late", 1.0));
  EXPECT_FALSE(f.admit("late", 9.0));
  EXPECT_TRUE(f.admit("late", 10.5));
  EXPECT_FALSE(f.admit("more", 11.0));
  EXPECT_EQ(f.hidden(), 3);
}

// Long silence earns no more than a burst.
TEST(WarningFilter, CreditIsBounded) {
  WarningFilter f;
  int shown = 0;
  for (int i = 0; i < 100; ++i) shown += f.admit(std::to_string(i), 1.0e6) ? 1 : 0;
  EXPECT_EQ(shown, 5);
  EXPECT_EQ(f.hidden(), 95);
}

}  // namespace
}  // namespace lac
