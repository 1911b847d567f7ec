// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/case_marker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const CaseFigures kFigures{
    {"A [m]", "B [-]", "C [-]"}, {"one", "two"}, {{"1", "", "3"}, {"4", "5", ""}}};

// What is written is read, cells without a number included.
TEST(CaseMarker, Done) {
  const test::TempFolder folder;
  EXPECT_EQ(read_marker(folder.path()).state, CaseState::kOpen);
  MarkerWriter(folder.path(), "ab12").done(kFigures);
  const CaseMarker m = read_marker(folder.path());
  EXPECT_EQ(m.state, CaseState::kDone);
  EXPECT_EQ(m.fingerprint, "ab12");
  EXPECT_EQ(m.figures, kFigures);
}

TEST(CaseMarker, Failed) {
  const test::TempFolder folder;
  MarkerWriter(folder.path("new"), "ab12").failed("no wind\ntoday");
  const CaseMarker m = read_marker(folder.path("new"));
  EXPECT_EQ(m.state, CaseState::kFailed);
  EXPECT_EQ(m.fingerprint, "ab12");
  EXPECT_EQ(m.reason, "no wind\ntoday");
}

// A marker that lacks as much as its last byte is none.
TEST(CaseMarker, CutOffIsOpen) {
  const test::TempFolder folder;
  MarkerWriter(folder.path(), "ab12").done(kFigures);
  const std::string whole = folder.read("done");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    folder.write("done", whole.substr(0, size));
    ASSERT_EQ(read_marker(folder.path()).state, CaseState::kOpen) << size;
  }
  folder.write("done", whole);
  EXPECT_EQ(read_marker(folder.path()).state, CaseState::kDone);
}

// Before the next flight the older marker is gone, and nothing comes if the flight gives up.
TEST(CaseMarker, OlderIsRemovedFirst) {
  const test::TempFolder folder;
  MarkerWriter(folder.path(), "ab12").done(kFigures);
  { const MarkerWriter next(folder.path(), "cd34"); }
  EXPECT_EQ(read_marker(folder.path()).state, CaseState::kOpen);
  EXPECT_TRUE(fs::is_empty(folder.path()));
  MarkerWriter(folder.path(), "cd34").failed("x");
  MarkerWriter(folder.path(), "ab12").done(kFigures);
  EXPECT_EQ(read_marker(folder.path()).state, CaseState::kDone);
  EXPECT_FALSE(fs::exists(folder.path("failed")));
}

// One process at a time; what stays of a killed one does no harm.
TEST(CaseMarker, OneAtATime) {
  const test::TempFolder folder;
  folder.write("done.part", "left by a flight that was killed");
  MarkerWriter first(folder.path(), "ab12");
  EXPECT_THAT(test::error_text([&] { MarkerWriter(folder.path(), "ab12"); }),
              HasSubstr("another run is writing this file"));
  first.done(kFigures);
  EXPECT_EQ(read_marker(folder.path()).figures, kFigures);
}

}  // namespace
}  // namespace lac::sim
