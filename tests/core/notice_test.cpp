// SPDX-License-Identifier: Apache-2.0
#include "core/notice.hpp"

#include <gtest/gtest.h>

#include <string>

namespace lac {
namespace {

TEST(Notice, SilentAtFirst) {
  Notice n;
  EXPECT_EQ(n.level(), 0);
  EXPECT_EQ(n.text(), "");
}

// Texts are joined; a failure stays a failure.
TEST(Notice, JoinsTextsAndKeepsTheWorst) {
  Notice n;
  n.warn("%d beams", 4);
  EXPECT_EQ(n.level(), 1);
  n.fail("no %s", "gate");
  n.warn("late");
  EXPECT_EQ(n.level(), -1);
  EXPECT_EQ(n.text(), "4 beams; no gate; late");
  n.clear();
  EXPECT_EQ(n.level(), 0);
  EXPECT_EQ(n.text(), "");
}

// A text that does not fit says so, whatever the length at which the memory ends, and later texts
// change nothing any more.
TEST(Notice, EndsInDotsWhenFull) {
  for (std::size_t first = 4080; first <= 4100; ++first) {
    Notice n;
    n.warn("%s", std::string(first, 'a').c_str());
    n.warn("%s", std::string(50, 'b').c_str());
    ASSERT_LE(n.text().size(), 4095U);
    EXPECT_TRUE(n.text().ends_with("...")) << first;
    const std::string before(n.text());
    n.fail("c");
    EXPECT_EQ(n.text(), before);
    EXPECT_EQ(n.level(), -1);
  }
}

// Exactly as much as there is room for is kept whole.
TEST(Notice, FillsToTheLastCharacter) {
  Notice n;
  n.warn("%s", std::string(4095, 'a').c_str());
  EXPECT_EQ(n.text(), std::string(4095, 'a'));
}

}  // namespace
}  // namespace lac
