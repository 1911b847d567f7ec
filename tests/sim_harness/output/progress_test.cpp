// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace lac::sim {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

// A run of ten seconds in 10000 steps, or the first of them, under a clock of its own.
std::string run(ProgressStyle style, int steps = 10000) {
  std::ostringstream out;
  double now_s = 0.0;
  {
    Progress progress("feedback-only", style, out, [&now_s] { return now_s; });
    for (int i = 1; i <= steps; ++i) {
      now_s = i / 1000.0;
      progress.update(i / 10000.0);
    }
    if (steps == 10000) progress.finish();
  }
  return out.str();
}

// Piped: a few whole lines with the time left, no control characters.
TEST(Progress, PlainLinesWhenPiped) {
  EXPECT_EQ(run({}),
            "feedback-only: 20 % done, 8 s left\n"
            "feedback-only: 40 % done, 6 s left\n"
            "feedback-only: 60 % done, 4 s left\n"
            "feedback-only: 80 % done, 2 s left\n"
            "feedback-only: done in 10.0 s\n");
}

// On a terminal: at most ten redraws a second, each on the same line, fitting the width.
TEST(Progress, BarOnATerminal) {
  const std::string text = run({true, false, 60});
  const auto redraws = std::count(text.begin(), text.end(), '\r');
  EXPECT_GT(redraws, 80);
  EXPECT_LE(redraws, 101);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_THAT(text, Not(HasSubstr("\033[36m")));
  EXPECT_THAT(text, EndsWith("\rfeedback-only: done in 10.0 s\033[K\n"));
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line, '\r');
  while (std::getline(lines, line, '\r')) {
    EXPECT_LT(line.substr(0, line.find("\033[K")).size(), 60U) << line;
  }
}

// Half the way: half a bar, and colour only where it is wanted.
TEST(Progress, BarShowsFractionAndColour) {
  const std::string half =
      "[\033[36m" + std::string(20, '=') + ">\033[0m" + std::string(19, ' ') + "]   5";
  EXPECT_THAT(run({true, true, 200}, 5240), HasSubstr(half));
}

// A narrow terminal: the numbers stay, the bar goes.
TEST(Progress, NarrowTerminalHasNoBar) {
  EXPECT_THAT(run({true, false, 30}), Not(HasSubstr("[=")));
}

// Left half-way by an exception: the next text starts on its own line.
TEST(Progress, GivenUpEndsTheLine) {
  EXPECT_THAT(run({true, false, 80}, 5000), EndsWith("left\033[K\n"));
  EXPECT_THAT(run({}, 5000), EndsWith("left\n"));
}

// Between two thousandths of the way the clock is not asked.
TEST(Progress, CheapBetweenLooks) {
  std::ostringstream out;
  int asked = 0;
  Progress progress("run", {}, out, [&asked] { return static_cast<double>(++asked); });
  for (int i = 0; i <= 1000000; ++i) progress.update(i / 1e6);
  EXPECT_LE(asked, 1002);
}

// Seconds, minutes, hours.
TEST(Progress, DurationTexts) {
  EXPECT_EQ(duration_text(3.6), "4 s");
  EXPECT_EQ(duration_text(59.9), "1 min 00 s");
  EXPECT_EQ(duration_text(200.0), "3 min 20 s");
  EXPECT_EQ(duration_text(3900.0), "1 h 05 min");
}

}  // namespace
}  // namespace lac::sim
