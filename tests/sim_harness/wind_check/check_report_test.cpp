// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/check_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lac::sim {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// One band of each kind; the coherence of v is nothing, in theory.
TheoryCheck example(bool inside) {
  TheoryCheck c;
  c.tests = 12;
  c.outside = inside ? 0 : 1;
  c.lowest_hz = 0.0015;
  c.highest_hz = 4.99;
  c.lattice_points = 729;
  for (int component = 0; component < 3; ++component) {
    c.sigmas.push_back({0.0015, 1.8, 2.0, 1.7, 2.3, true});
    c.spectra.push_back({component, 0.0, 0.0, {{0.1, 10.0, 11.0, 9.0, 13.0, true}}});
  }
  c.coherences.push_back({0, 20.0, 0.0, {{0.1, 0.5, 0.6, 0.55, 0.65, inside}}});
  c.coherences.push_back({1, 20.0, 0.0, {{0.1, 1e-3, 0.0, -0.01, 0.01, true}}});
  return c;
}

const CheckTitle kTitle{"field.bts", "Kaimal", 10.0};

// All inside: standard deviations, turbulence intensities, and that.
TEST(CheckReport, TableOfAGoodField) {
  const std::string text = check_table(example(true), kTitle, {});
  EXPECT_THAT(text, HasSubstr("field.bts against Kaimal\n"));
  EXPECT_THAT(text, ::testing::ContainsRegex("u +1.800 +2.000 +1.700 +2.300 +18.00 % +20.00 %"));
  EXPECT_THAT(text, HasSubstr("12 tests from 0.0015 to 4.990 Hz: all inside (99.0 % of fields"));
  EXPECT_THAT(text, Not(HasSubstr("outside")));
}

// Something outside is named, with its numbers.
TEST(CheckReport, TableOfABadField) {
  EXPECT_THAT(check_table(example(false), kTitle, {}),
              HasSubstr("outside: root coherence of u, 20.0 m across at 0.1000 Hz: 0.5000, theory "
                        "0.6000, 95 % from 0.5500 to 0.6500\n12 tests from 0.0015 to 4.990 Hz: 1 "
                        "outside"));
}

// Hundreds of bands outside are counted, not listed.
TEST(CheckReport, LongListsAreCut) {
  TheoryCheck check = example(true);
  check.spectra[0].points.assign(25, {0.1, 20.0, 11.0, 9.0, 13.0, false});
  EXPECT_THAT(check_table(check, kTitle, {}), HasSubstr("  ... and 5 more bands\n"));
}

// The page: a panel per curve with something to draw, found, theory and band in each.
TEST(CheckReport, Page) {
  const HtmlReport page = check_page(example(true), kTitle, {});
  ASSERT_EQ(page.spectra.size(), 4u);
  EXPECT_EQ(page.spectra[0].title, "Spectrum of u");
  EXPECT_EQ(page.spectra[3].title, "Root coherence of u, 20.0 m across");
  ASSERT_EQ(page.spectra[0].series.size(), 4u);
  EXPECT_EQ(page.spectra[0].series[1].density, std::vector<double>{11.0});
  EXPECT_EQ(page.spectra[0].series[3].density, std::vector<double>{13.0});
  EXPECT_NEAR(page.results[0].relative_change, -0.1, 1e-12);
  EXPECT_THAT(page.results[0].quantity, HasSubstr("(95 % from 17.00 to 23.00)"));
  EXPECT_THAT(html_report(page), HasSubstr("<title>Wind against theory</title>"));
}

}  // namespace
}  // namespace lac::sim
