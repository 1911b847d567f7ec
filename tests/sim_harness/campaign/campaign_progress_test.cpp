// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/campaign_progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace lac::sim {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

// Forty cases, one a second, the eighth fails, under a clock of its own.
std::string fly(ProgressStyle style) {
  std::ostringstream out;
  double now_s = 0.0;
  {
    CampaignProgress progress("speeds", 40, style, out, [&now_s] { return now_s; });
    for (int i = 1; i <= 40; ++i) {
      now_s = i;
      i == 8 ? progress.case_failed("seed-8", "no wind") : progress.case_done();
      progress.tick();
    }
  }
  return out.str();
}

// Piped: a line every tenth of the way, and each failure with its reason.
TEST(CampaignProgress, PlainLinesWhenPiped) {
  const std::string text = fly({});
  EXPECT_THAT(text, HasSubstr("speeds: 4 of 40 cases, 0 failed, 36 s left\n"
                              "failed: seed-8: no wind\n"
                              "speeds: 8 of 40 cases, 1 failed, 32 s left\n"));
  EXPECT_THAT(text, EndsWith("speeds: 40 of 40 cases, 1 failed, 0 s left\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);
}

// On a terminal: one line that redraws itself and fits the width; failures stay above it.
TEST(CampaignProgress, OneLineOnATerminal) {
  const std::string text = fly({true, false, 30});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_THAT(text,
              HasSubstr("\r\033[Kfailed: seed-8: no wind\n\rspeeds: 8 of 40 cases, 1 fail\033"));
  EXPECT_THAT(text, EndsWith("\033[K\n"));
}

// Many failures: the first twenty are told, all are counted.
TEST(CampaignProgress, ManyFailures) {
  std::ostringstream out;
  double now_s = 0.0;
  CampaignProgress progress("speeds", 50, {}, out, [&now_s] { return now_s; });
  for (int i = 1; i <= 50; ++i) {
    now_s = i;
    progress.case_failed("x", "y");
  }
  EXPECT_THAT(out.str(), HasSubstr("speeds: 50 of 50 cases, 50 failed"));
  EXPECT_THAT(out.str(), HasSubstr("(later failures are counted only)\n"));
  const std::string text = out.str();
  std::size_t told = 0;
  for (std::size_t at = 0; (at = text.find("failed: x", at)) != std::string::npos; ++at) ++told;
  EXPECT_EQ(told, 20U);
}

}  // namespace
}  // namespace lac::sim
