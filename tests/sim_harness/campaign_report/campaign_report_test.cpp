// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign_report/campaign_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim_harness/campaign_report/campaign_page.hpp"
#include "sim_harness/campaign_report/campaign_summary.hpp"
#include "sim_harness/tables/csv_table.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::Pair;

/// Two controllers, two speeds, three seeds, two classes; loads of B are 10 % lower when calm and
/// 20 % when rough, times a little that differs from seed to seed. One case has failed.
std::string campaign_table() {
  std::string text =
      csv_line({"case", "status", "reason", "mean_speed_mps", "seed", "class", "wind.stability",
                "fixed", "controller", "del_reference", "del_rainflow", "TwrBsMyt_del4 [kNm]",
                "TwrBsMyt_max [kNm]", "TwrBsMyt_max_time [s]", "GenPwr_mean [kW]"});
  for (const int speed : {12, 14}) {
    for (const int seed : {1, 2, 3}) {
      for (const char* kind : {"calm", "rough"}) {
        const double load = 1000.0 * speed + 10.0 * seed;
        const double share = (*kind == 'c' ? 0.9 : 0.8) + 0.001 * seed;
        const auto row = [&](const char* name, double del) {
          text += csv_line({"x", "done", "", std::to_string(speed), std::to_string(seed), kind,
                            std::string("of ") + kind, "7", name, "1hz", "astm", csv_number(del),
                            csv_number(2.0 * del), "3", csv_number(4000.0 + seed)});
        };
        row("fb", load);
        row("lac", share * load);
      }
    }
  }
  return text + "bad,failed,\"<b>hit, by \"\"a\"\" bird</b>\",14,4,calm,of calm,7,,,,,,,\n";
}

class CampaignReportTest : public ::testing::Test {
 protected:
  CampaignReport report(const std::string& text) {
    options_.inputs = {folder_.write("results.csv", text)};
    return campaign_report(options_);
  }
  test::TempFolder folder_;
  CampaignReportOptions options_;
};

// All runs and each class: the comparisons are compare_runs()'s own, 12 pairs and 6.
TEST_F(CampaignReportTest, ComparesAllRunsAndClasses) {
  const CampaignReport r = report(campaign_table());
  ASSERT_EQ(r.views.size(), 3U);
  EXPECT_EQ(r.views[0].name, "all runs");
  EXPECT_EQ(r.views[2].name, "class = rough");
  EXPECT_THAT(r.quantities, ElementsAre("TwrBsMyt_del4", "TwrBsMyt_max", "GenPwr_mean"));
  const CsvTable table(options_.inputs[0]);
  RunTableOptions rough;
  rough.where = {"class=rough"};
  const Comparison expected =
      compare_runs(runs_of_table(table, "fb", rough), runs_of_table(table, "lac", rough), {});
  const Comparison& found = r.views[2].comparisons.at(0).comparison;
  EXPECT_EQ(found.runs.size(), 6U);
  EXPECT_EQ(r.views[0].comparisons.at(0).comparison.runs.size(), 12U);
  const Change &a = *expected.quantities[1].at_speed[1], &b = *found.quantities[0].at_speed[1];
  EXPECT_EQ(expected.quantities[1].name, "TwrBsMyt_del4");
  EXPECT_EQ(a.relative_low, b.relative_low);
  EXPECT_NEAR(b.relative, -0.198, 1e-4);
  EXPECT_TRUE(b.significant);
}

// A key that a class sets, the controller's own keys, what is fixed, case and status are no
// parameters that vary; the rows of pairs belong to one wind.
TEST_F(CampaignReportTest, RowsAndParameters) {
  const CampaignReport r = report(campaign_table());
  std::vector<std::string> varied;
  for (const std::size_t c : r.varied) varied.push_back(r.rows.columns[c]);
  EXPECT_THAT(varied, ElementsAre("mean_speed_mps", "seed", "class"));
  EXPECT_THAT(fixed_parameters(r), ElementsAre(Pair("fixed", "7")));
  EXPECT_EQ(r.rows.cells.size(), 25U);
  const auto& pairs = r.views[0].comparisons[0].comparison.runs;
  for (const RunPair& p : pairs) {
    const auto &a = r.rows.cells[r.controllers[0].rows[p.a]],
               &b = r.rows.cells[r.controllers[1].rows[p.b]];
    for (const std::size_t c : r.varied) EXPECT_EQ(a[c], b[c]);
    EXPECT_EQ(a[r.rows.column("controller")], "fb");
    EXPECT_EQ(b[r.rows.column("controller")], "lac");
  }
}

// What was flown, what failed and why, what the loads are: always said; not known is said too.
TEST_F(CampaignReportTest, Summary) {
  CampaignReport r = report(campaign_table());
  EXPECT_THAT(campaign_summary(r),
              AllOf(Contains(Pair("Cases", "2: 1 done, 1 failed")),
                    Contains(Pair("Controllers", "fb (12 runs), lac (12 runs)")),
                    Contains(Pair("seed", "1, 2, 3, 4")),
                    Contains(Pair(HasSubstr("Loads"), HasSubstr("ASTM E1049")))));
  ASSERT_EQ(cases_not_done(r).size(), 1U);
  EXPECT_EQ(cases_not_done(r)[0].reason, "<b>hit, by \"a\" bird</b>");
  r = report("file,RtVAvgxh_mean [m/s],A_del4 [kN]\na,9,1\nb,11,2\n");
  EXPECT_THAT(campaign_summary(r),
              AllOf(Contains(Pair("Cases", "2 runs")),
                    Contains(Pair(HasSubstr("Loads"), HasSubstr("convention not known")))));
}

// Names that look like markup are text, in HTML and in the data of the scripts; nothing is fetched.
TEST_F(CampaignReportTest, PageIsSelfContainedAndEscaped) {
  std::string text = campaign_table();
  for (std::size_t at; (at = text.find("rough")) != std::string::npos;)
    text.replace(at, 5, "</script><i>");
  options_.title = "<!--lac:data-->";
  const std::string page = campaign_page(report(text));
  EXPECT_THAT(page, AllOf(HasSubstr("<h1>&lt;!--lac:data--&gt;</h1>"), Not(HasSubstr("<i>")),
                          Not(HasSubstr("<b>")), Not(HasSubstr("<!--lac:"))));
  EXPECT_THAT(page, AllOf(HasSubstr("class = &lt;/script&gt;&lt;i&gt;"),
                          HasSubstr("\\u003c/script\\u003e\\u003ci\\u003e")));
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;hit, by &quot;a&quot; bird&lt;/b&gt;"));
  for (const char* forbidden : {"http://", "https://", " src=", "@import", "url(", "<link"})
    EXPECT_THAT(page, Not(HasSubstr(forbidden)));
}

// The tables of the page say what the terminal says, with true minus signs.
TEST_F(CampaignReportTest, TablesOfThePage) {
  const std::string page = campaign_page(report(campaign_table()));
  EXPECT_THAT(page, AllOf(HasSubstr("12 m/s, 6 pairs"), HasSubstr("\u221214.8 \u00b1"),
                          HasSubstr("not significant at 95 %"), HasSubstr("energy of a year"),
                          HasSubstr("would be called significant by chance")));
  EXPECT_THAT(page, AllOf(HasSubstr("From A = fb to B = lac: class = calm"),
                          HasSubstr("rainflow counting after ASTM E1049")));
}

// Not a number and an empty cell are null for the scripts; a comparison goes on without them.
TEST_F(CampaignReportTest, MissingFigures) {
  std::string text = campaign_table();
  text.replace(text.find(",12010,"), 7, ",nan,");
  text.replace(text.find(",24020,"), 7, ",,");
  const CampaignReport r = report(text);
  EXPECT_EQ(r.views[0].comparisons[0].comparison.quantities[0].at_speed[0]->pairs, 5U);
  EXPECT_THAT(campaign_data_json(r), AllOf(HasSubstr(",null,null,3,"), Not(HasSubstr("nan"))));
}

// One controller: no comparison, but its figures; three: each with the one that is named.
TEST_F(CampaignReportTest, OneAndThreeControllers) {
  options_.runs.where = {"controller=lac"};
  CampaignReport r = report(campaign_table());
  EXPECT_THAT(r.views[0].comparisons, IsEmpty());
  EXPECT_EQ(r.views[0].lives.size(), 1U);
  EXPECT_THAT(campaign_page(r), HasSubstr("<details open>"));
  options_.runs.where.clear();
  std::string text = campaign_table();
  text += "y,done,,12,1,calm,of calm,7,third,1hz,astm,1,2,3,4\n";
  options_.baseline = "lac";
  r = report(text);
  ASSERT_EQ(r.views[0].comparisons.size(), 2U);
  EXPECT_EQ(r.controllers[0].name, "lac");
  EXPECT_EQ(r.views[0].comparisons[1].comparison.b, "third");
  EXPECT_EQ(r.views[0].comparisons[1].comparison.unpaired_a, 11U);
  options_.baseline = "lacc";
  EXPECT_THAT(test::error_text([&] { report(text); }),
              AllOf(HasSubstr("results.csv: no controller 'lacc' (did you mean 'lac'?)"),
                    HasSubstr("there are: fb, lac, third")));
}

// Two tables of one controller each, with columns of their own; runs that do not pair are said.
TEST_F(CampaignReportTest, SeveralTables) {
  const char head[] = "file,mean_speed_mps,A_std [kN]";
  options_.inputs = {folder_.write("old.csv", head + std::string("\nr/1.outb,9,1\nr/2.outb,9,2\n")),
                     folder_.write("new.csv", head + std::string(",B_std [m]\ns/1.out,9,3,4\n"))};
  CampaignReport r = campaign_report(options_);
  EXPECT_THAT(r.rows.columns,
              ElementsAre("table", "file", "mean_speed_mps", "A_std [kN]", "B_std [m]"));
  EXPECT_THAT(r.rows.cells[0], ElementsAre("old", "r/1.outb", "9", "1", ""));
  EXPECT_THAT(r.quantities, ElementsAre("A_std"));
  EXPECT_THAT(r.views[0].comparisons, IsEmpty());  // the parameters of one run do not differ
  ASSERT_EQ(r.notes.size(), 1U);
  EXPECT_THAT(r.notes[0], HasSubstr("not compared: no run of 'old' (2) has a partner"));
  options_.inputs[1] = options_.inputs[0];
  EXPECT_THAT(test::error_text([&] { campaign_report(options_); }),
              HasSubstr("is called 'old' as "));
  EXPECT_EQ(table_name("study/results.csv"), "study");
}

// Folders: the table of a campaign in them, the page beside it. No table, no run: said.
TEST_F(CampaignReportTest, FoldersAndErrors) {
  EXPECT_THAT(test::error_text([&] { result_table_of(folder_.path()); }),
              HasSubstr("has no results.csv, expected the folder of a campaign"));
  folder_.write("results.csv", "");
  EXPECT_EQ(page_beside(folder_.path()), folder_.path("report.html"));
  EXPECT_EQ(page_beside(folder_.path("b.csv")), folder_.path("b.html"));
  const std::string head = "case,status,reason,mean_speed_mps,controller,A_std [kN]\n";
  EXPECT_THAT(test::error_text([&] { report(head + "c,failed,why,9,,\n"); }),
              HasSubstr("no run in it is done"));
  EXPECT_THAT(test::error_text([&] { report("case,mean_speed_mps\nc,9\n"); }),
              AllOf(HasSubstr("results.csv: no figure is common"), HasSubstr(" has: none")));
  std::string many = head.substr(0, head.size() - 1);
  for (int i = 0; i < 25; ++i) many += ",Q" + std::to_string(i) + "_std [kN]";
  options_.quantities = {"zz"};
  const std::string row = "\nc,done,,9,fb,1" + std::string(25, ',') + "\n";
  EXPECT_THAT(test::error_text([&] { report(many + row); }), HasSubstr("Q18_std and 6 more"));
  options_.quantities.clear();
  options_.quantities = {"A_st"};
  EXPECT_THAT(test::error_text([&] { report(head + "c,done,,9,fb,1\n"); }),
              AllOf(HasSubstr("results.csv: no quantity 'A_st' (did you mean 'A_std'?)"),
                    HasSubstr("common to all controllers are: A_std")));
}

// 252 rows of 400 columns of figures stay far below 5 MB.
TEST_F(CampaignReportTest, SizeOfALargeCampaign) {
  std::vector<std::string> names{"case",           "status", "reason",
                                 "mean_speed_mps", "seed",   "controller"};
  for (int i = 0; i < 400; ++i) names.push_back("Channel" + std::to_string(i) + "_std [kNm]");
  std::string text = csv_line(names);
  for (int i = 0; i < 252; ++i) {
    std::vector<std::string> cells{"case_" + std::to_string(i),
                                   "done",
                                   "",
                                   std::to_string(12 + i / 2 % 7),
                                   std::to_string(i / 14),
                                   i % 2 == 0 ? "fb" : "lac"};
    for (int k = 0; k < 400; ++k) cells.push_back(csv_number(std::sin(i + 0.01 * k) * 1234.5678));
    text += csv_line(cells);
  }
  const std::string page = campaign_page(report(text));
  EXPECT_LT(page.size(), 3'000'000U);
  EXPECT_GT(page.size(), 252U * 400U * 5U);
}

}  // namespace
}  // namespace lac::sim
