// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/result_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim_harness/campaign/study_folder.hpp"
#include "support/error_text.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string table_of(const test::StudyFolder& files, const std::string& lines,
                     const std::vector<CaseMarker>& markers) {
  const Study study = load_study(files.study(lines));
  const auto file = files.folder.path("table.csv");
  write_result_table(file, study, study_cases(study), markers);
  return files.folder.read("table.csv");
}

// Every parameter and figure, one row per case and controller; no figures where nothing was done.
TEST(ResultTable, Rows) {
  const test::StudyFolder files;
  const CaseMarker done{
      CaseState::kDone, "f", {{"A [m]", "B"}, {"x", "y"}, {{"1", ""}, {"3", "4"}}}, ""};
  const CaseMarker failed{CaseState::kFailed, "f", {}, "too windy, \"really\"\nindeed"};
  EXPECT_EQ(table_of(files,
                     "set: {time.duration_s: 30}\n"
                     "ranges: {wind.speed_mps: [12, 14], kind: {a: {seed: 1}, b: {name: n}}}\n"
                     "exclude: [{wind.speed_mps: 14, kind: b}]\n",
                     {done, failed, {}}),
            "case,status,reason,speed_mps,kind,seed,name,time.duration_s,controller,A [m],B\n"
            "speed_mps-12_a,done,,12,a,1,,30,x,1,\n"
            "speed_mps-12_a,done,,12,a,1,,30,y,3,4\n"
            "speed_mps-12_b,failed,\"too windy, \"\"really\"\" indeed\",12,b,,n,30,,,\n"
            "speed_mps-14_a,open,,14,a,1,,30,,,\n");
}

// The last word of a key names the column, unless something else is called so.
TEST(ResultTable, ColumnNames) {
  const test::StudyFolder files;
  EXPECT_THAT(table_of(files, "ranges: {seed: [1], a.x: [1], b.x: [2], c.status: [1]}\n", {{}}),
              StartsWith("case,status,reason,seed,a.x,b.x,c.status,controller\n"));
  const Study study = load_study(files.study("ranges:\n  seed: [1]\n  controller: {a: {}}\n"));
  EXPECT_THAT(test::error_text([&] { check_columns(study); }),
              HasSubstr("study.yaml:4: ranges.controller: the table of results has another"));
}

}  // namespace
}  // namespace lac::sim
