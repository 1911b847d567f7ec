// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/html_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "core/error.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

HtmlReport two_runs() {
  HtmlReport report;
  report.title = "Demo";
  report.metadata = {{"Turbine", "NREL 5 MW"}};
  report.runs = {"Feedback only", "Lidar-assisted"};
  report.time_step_s = 0.0125;
  report.results = {{"Rotor speed", "rpm", {0.5, 0.3}, -0.4, 2, Better::kLower},
                    {"Mean power", "kW", {5000.0, 4900.0}, -0.02, 0, Better::kHigher},
                    {"Tower DEL", "kNm", {-12345.6, std::nan("")}}};
  report.traces = {{"Speed", "rpm", {{"a", 0, {1.0, 2.0}}, {"b", 1, {2.0, 3.0}}}}};
  report.spectra = {{"Speed", "rpm²/Hz", {{"a", 0, {0.1, 0.2}, {1.0, 2.0}}}}};
  report.notes = {"First note."};
  return report;
}

// Heading, metadata, table with verdicts, notes and data are all there; no placeholder is left.
TEST(HtmlReport, HasEveryPart) {
  const std::string page = html_report(two_runs());
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_THAT(page, Not(HasSubstr("<!--lac:")));
  EXPECT_THAT(page,
              AllOf(HasSubstr("<title>Demo</title>"), HasSubstr("<h1>Demo</h1>"),
                    HasSubstr("<dt>Turbine</dt><dd>NREL 5 MW</dd>"),
                    HasSubstr("<li>First note.</li>"), HasSubstr("\"runs\":[\"Feedback only\"")));
  EXPECT_THAT(page, HasSubstr("<td>0.50</td><td>0.30</td><td class=\"change better\">"));
  EXPECT_THAT(page, HasSubstr("</span>\u221240.0 %</td>"));
  EXPECT_THAT(page, HasSubstr("<td>5000</td><td>4900</td><td class=\"change worse\">"));
  EXPECT_THAT(page, HasSubstr("<td>\u221212\u202f345.600</td><td>n/a</td>"
                              "<td class=\"change none\">n/a</td>"));
}

// Nothing is fetched from elsewhere: no address, no source, no import, and a policy against it.
TEST(HtmlReport, IsSelfContained) {
  const std::string page = html_report(two_runs());
  for (const char* forbidden :
       {"http://", "https://", "//cdn", " src=", "@import", "url(", "<link"}) {
    EXPECT_THAT(page, Not(HasSubstr(forbidden)));
  }
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

// User text is text, also where it looks like markup or like a placeholder of the page.
TEST(HtmlReport, EscapesText) {
  HtmlReport report = two_runs();
  report.title = "<b>\"A\" & 'B'</b>";
  report.notes = {"<!--lac:data--> <script>alert(1)</script>"};
  report.runs[0] = "<i>run</i>";
  const std::string page = html_report(report);
  EXPECT_THAT(page, HasSubstr("<h1>&lt;b&gt;&quot;A&quot; &amp; &#39;B&#39;&lt;/b&gt;</h1>"));
  EXPECT_THAT(page, HasSubstr("<li>&lt;!--lac:data--&gt; &lt;script&gt;alert(1)"));
  EXPECT_THAT(page, AllOf(HasSubstr("&lt;i&gt;run"), Not(HasSubstr("<i>run"))));
}

// One run alone has no column of changes.
TEST(HtmlReport, SingleRunHasNoChangeColumn) {
  HtmlReport report = two_runs();
  report.runs = {"Only"};
  report.results = {{"Rotor speed", "rpm", {0.5}}};
  report.traces.clear();
  report.spectra.clear();
  EXPECT_THAT(html_report(report), Not(HasSubstr("Relative change")));
}

// Two runs of 660 s at 80 Hz in six panels stay below 3 MB, whole.
TEST(HtmlReport, SizeOfAFullPage) {
  HtmlReport report = two_runs();
  std::vector<double> values(52800);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::sin(0.01 * static_cast<double>(i));
  report.traces.assign(6, {"Panel", "u", {{"a", 0, values}, {"b", 1, values}}});
  const std::string page = html_report(report);
  EXPECT_LT(page.size(), 2'000'000U);
  EXPECT_THAT(page, HasSubstr("\"n\":52800,"));
  report.most_samples_per_trace = 5000;
  EXPECT_LT(html_report(report).size(), 250'000U);
  EXPECT_THAT(html_report(report), HasSubstr("minimum and the maximum of every 22 samples"));
}

// Lengths and runs that do not fit together are named.
TEST(HtmlReport, InconsistentInputIsRefused) {
  const auto refused = [](HtmlReport report, const char* text) {
    EXPECT_THAT([&] { html_report(report); }, ThrowsMessage<Error>(HasSubstr(text)));
  };
  HtmlReport report = two_runs();
  report.traces[0].series[1].values.pop_back();
  refused(report, "trace 'b' of 'Speed' has 1 values, expected 2");
  report = two_runs();
  report.traces[0].series[1].run = 2;
  refused(report, "series 'b' belongs to run 2, but there are 2 runs");
  report = two_runs();
  report.results[0].values.push_back(1.0);
  refused(report, "result 'Rotor speed' has 3 values, expected 2");
  report = two_runs();
  report.spectra[0].series[0].density.pop_back();
  refused(report, "spectrum 'a' of 'Speed' has 1 values, expected 2");
  report = two_runs();
  report.time_step_s = 0.0;
  refused(report, "time step");
}

// The file is the page; a bad path names file and reason; a refused report leaves no file.
TEST(HtmlReport, WritesTheFileOrNothing) {
  const fs::path folder = fs::path(::testing::TempDir()) / "lac_html_report";
  fs::remove_all(folder);
  fs::create_directories(folder);
  HtmlReport report = two_runs();
  write_html_report(folder / "report.html", report);
  std::ifstream in(folder / "report.html", std::ios::binary);
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>(in), {}}), html_report(report));
  EXPECT_THAT([&] { write_html_report(folder / "no" / "report.html", report); },
              ThrowsMessage<Error>(AllOf(HasSubstr("no/report.html"), HasSubstr("No such file"))));
  report.time_step_s = 0.0;
  EXPECT_THROW(write_html_report(folder / "bad.html", report), Error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace lac::sim
