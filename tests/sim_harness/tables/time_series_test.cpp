// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/time_series.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

// The ending decides, in any case; another one is refused.
TEST(ReadTimeSeries, ByEnding) {
  const test::TempFolder folder;
  Recording r({{"a", "-"}}, 0.0, 1.0, 2);
  for (const float v : {0.0F, 1.0F}) r.append(&v);
  r.write(folder.file("a.outb"));
  r.write(folder.file("b.csv"));
  folder.write("c.OUT", "Time a\n(s) (-)\n0 0\n1 1\n");
  for (const char* name : {"a.outb", "b.csv", "c.OUT"}) {
    EXPECT_THAT(read_time_series(folder.path(name)).column("a"), ::testing::ElementsAre(0.0, 1.0));
  }
  EXPECT_THAT(test::error_text([] { read_time_series("a.bts"); }),
              ::testing::HasSubstr("a.bts: ends in '.bts', expected time series in .outb, .out"));
}

// A folder stands for its series, each once: the binary one of two.
TEST(TimeSeriesOf, Folder) {
  const test::TempFolder folder;
  for (const char* name : {"b.csv", "b.outb", "a.csv", "c.out", "c.csv", "page.html", "d.bts"})
    folder.write(name, "");
  EXPECT_THAT(
      time_series_of(folder.path()),
      ::testing::ElementsAre(folder.path("a.csv"), folder.path("b.outb"), folder.path("c.out")));
  EXPECT_THAT(time_series_of(folder.path("d.bts")), ::testing::ElementsAre(folder.path("d.bts")));
  EXPECT_THAT(test::error_text([&] { time_series_of(folder.path("none")); }),
              ::testing::HasSubstr("none: no such file or folder"));
  const test::TempFolder empty;
  EXPECT_THAT(test::error_text([&] { time_series_of(empty.path()); }),
              ::testing::HasSubstr("holds no time series"));
}

// What is beside a run, and texts, are no runs; a single file is taken as it is named.
TEST(TimeSeriesOf, OnlyRuns) {
  const test::TempFolder folder;
  for (const char* name : {"fb.outb", "fb.lac.outb", "demo.wind.outb", "notes.txt"})
    folder.write(name, "");
  EXPECT_THAT(time_series_of(folder.path()), ::testing::ElementsAre(folder.path("fb.outb")));
  EXPECT_THAT(time_series_of(folder.path("fb.lac.outb")), ::testing::SizeIs(1));
}

// The folder of a campaign holds a table, and its series further down.
TEST(TimeSeriesOf, Campaign) {
  const test::TempFolder folder;
  folder.write("results.csv", "case,status\n");
  folder.write("cases.txt", "");
  EXPECT_THAT(test::error_text([&] { time_series_of(folder.path()); }),
              ::testing::HasSubstr("is the folder of a campaign, expected one of time series; the "
                                   "table of its runs is " +
                                   folder.file("results.csv")));
}

}  // namespace
}  // namespace lac::sim
