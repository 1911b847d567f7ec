// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/report_data.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lac::sim {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsNan;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Levels of -1, 0, 1 and "no value" are 0, 32767, 65534 and 65535; their little-endian bytes
// 00 00 ff 7f fe ff ff ff are AAD/f/7///8= in base64 (checked with Python's base64).
TEST(ReportJson, WholeText) {
  HtmlReport report;
  report.runs = {"A"};
  report.start_time_s = 60.0;
  report.time_step_s = 0.5;
  report.run_in_until_s = 61.0;
  report.traces = {{"Pitch", "deg", {{"demand", 0, {-1.0, 0.0, 1.0, kNan}}}}};
  report.spectra = {{"Pitch", "deg2/Hz", {{"all", kAllRuns, {0.1, 0.2}, {1e-6, 12345.678}}}}};
  EXPECT_EQ(report_json(report),
            R"({"runs":["A"],"t0":60,"dt":0.5,"n":4,"runIn":61,)"
            R"("traces":[{"title":"Pitch","unit":"deg","series":[{"name":"demand","run":0,)"
            R"("low":-1,"high":1,"data":"AAD/f/7///8="}]}],)"
            R"("spectra":[{"title":"Pitch","unit":"deg2/Hz","series":[{"name":"all","run":-1,)"
            R"("f":[0.1,0.2],"s":[1e-06,12346]}]}]})");
}

// Text cannot end the script element or the string it stands in.
TEST(ReportJson, TextIsEscaped) {
  HtmlReport report;
  report.runs = {"</script><!-- \"a\\b\"\n&"};
  const std::string json = report_json(report);
  EXPECT_THAT(json, HasSubstr(R"(\u003c/script\u003e\u003c!-- \u0022a\u005cb\u0022\u000a\u0026)"));
  EXPECT_EQ(json.find_first_of("<>&\n"), std::string::npos);
}

// Both extremes of each stretch stay, in the order in which they occurred; gaps stay gaps.
TEST(Thinned, KeepsExtremes) {
  const std::vector<double> values{1.0, 5.0,  -2.0, 3.0,  0.0,  kNan, 7.0,
                                   7.0, kNan, kNan, kNan, kNan, 4.0};
  EXPECT_THAT(thinned(values, 2),
              ElementsAre(DoubleEq(5.0), DoubleEq(-2.0), DoubleEq(0.0), DoubleEq(7.0), IsNan(),
                          IsNan(), DoubleEq(4.0), DoubleEq(4.0)));
  EXPECT_EQ(thinned(std::vector<double>{1.0, 2.0}, 1).size(), 2U);
}

// The thinned trace keeps a single spike of a long record and stays below the limit; time step
// and number of values follow.
TEST(ReportJson, LongTracesAreThinned) {
  HtmlReport report;
  report.time_step_s = 0.5;
  report.most_samples_per_trace = 1000;
  std::vector<double> values(52800, 0.0);
  values[31234] = 9.0;
  report.traces = {{"T", "u", {{"spike", kAllRuns, values}}}};
  EXPECT_EQ(thinning_factor(report), 53U);
  const std::string json = report_json(report);
  EXPECT_THAT(json, HasSubstr("\"dt\":26.5,\"n\":998,"));
  EXPECT_THAT(json, HasSubstr("\"low\":0,\"high\":9,"));
}

}  // namespace
}  // namespace lac::sim
