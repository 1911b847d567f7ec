// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "sim_harness/cli/commands.hpp"

namespace lac::sim {
namespace {

// The committed page is the one printed from the table: `lac records > docs/record_map.md`.
TEST(Information, RecordMapPageIsUpToDate) {
  std::ostringstream printed, committed;
  print_records(printed);
  committed << std::ifstream(LAC_SOURCE_DIR "/docs/record_map.md").rdbuf();
  EXPECT_EQ(printed.str(), committed.str());
}

// The version page names what a report of a problem needs.
TEST(Information, VersionNamesLibrariesAndLayouts) {
  std::ostringstream out;
  print_version(out);
  for (const char* word : {"SUNDIALS ", "native lidar layout 1", "chain", "3301"}) {
    EXPECT_NE(out.str().find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace lac::sim
