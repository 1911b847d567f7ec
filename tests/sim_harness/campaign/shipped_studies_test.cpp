// SPDX-License-Identifier: Apache-2.0
// The studies under config/ can be flown.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "sim_harness/campaign/campaign.hpp"
#include "sim_harness/campaign/study_cases.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

std::vector<StudyCase> checked(const char* name) {
  const Study study = load_study(std::string(LAC_SOURCE_DIR "/config/studies/") + name);
  std::vector<StudyCase> cases = study_cases(study);
  check_cases(study, cases);
  return cases;
}

// 252 cases, two and two in one wind.
TEST(ShippedStudies, Dlc12) {
  const std::vector<StudyCase> cases = checked("dlc12.yaml");
  EXPECT_EQ(cases.size(), 252U);
  std::set<std::string> winds;
  for (const StudyCase& c : cases) winds.insert(c.wind);
  EXPECT_EQ(winds.size(), 126U);
}

// 480 cases; all faults of the lidar in one wind, the turned wind in another.
TEST(ShippedStudies, Robust) {
  const std::vector<StudyCase> cases = checked("robust.yaml");
  EXPECT_EQ(cases.size(), 480U);
  std::set<std::string> winds;
  for (const StudyCase& c : cases) winds.insert(c.wind);
  EXPECT_EQ(winds.size(), 48U);
}

// Two lidars, seven wind speeds, six seeds; the lidars share their winds.
TEST(ShippedStudies, HeldAndMann) {
  EXPECT_EQ(checked("hm.yaml").size(), 84U);
}

// Schlipf et al. (2020), confirmed with other winds, and beyond 16 m/s.
TEST(ShippedStudies, S20) {
  const std::vector<StudyCase> tuned = checked("s20.yaml");
  const std::vector<StudyCase> fresh = checked("s20_confirmation.yaml");
  ASSERT_EQ(tuned.size(), 12U);
  ASSERT_EQ(fresh.size(), 12U);
  for (const StudyCase& a : tuned)
    for (const StudyCase& b : fresh) EXPECT_NE(a.wind, b.wind);
  EXPECT_EQ(checked("s20_beyond.yaml").size(), 84U);
}

// The quick one to its end.
TEST(ShippedStudies, Quick) {
  EXPECT_EQ(checked("quick.yaml").size(), 18U);
  const test::TempFolder folder;
  CampaignOptions options;
  options.study = LAC_SOURCE_DIR "/config/studies/quick.yaml";
  options.output = folder.path("quick");
  std::ostringstream out;
  EXPECT_TRUE(run_campaign(options, out)) << out.str();
}

}  // namespace
}  // namespace lac::sim
