// SPDX-License-Identifier: Apache-2.0
// ROSCO's real Python class as host of our master, by the script that docs/hosts/rosco_toolbox.md
// gives to users.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "support/temp_folder.hpp"

namespace lac::test {
namespace {

constexpr int kCannotRun = 77;

/// The first Python block of the page.
std::string script_of_the_page() {
  std::ifstream in(LAC_SOURCE_DIR "/docs/hosts/rosco_toolbox.md");
  std::string text, line;
  while (std::getline(in, line) && line != "```python") {
  }
  while (std::getline(in, line) && line != "```") text += line + '\n';
  return text;
}

class RoscoToolboxClass : public testing::Test {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a library with a sanitizer cannot be loaded into Python";
#endif
    folder.write("run.py", script_of_the_page());
  }
  /// Exit code; what was printed is in out.txt.
  int run(const std::string& chain) {
    const std::string command = "cd '" + folder.path().string() +
                                "' && python3 '" LAC_SOURCE_DIR
                                "/tests/rosco/toolbox_class.py' '" LAC_ROSCO_DIR
                                "' run.py '" LAC_LIBRARY_DIR "/liblac_wrapper.so' '" +
                                chain + "' > out.txt 2>&1 < /dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  TempFolder folder;
};

// Feedback-only: rated speed is held, before and after a step of the wind.
TEST_F(RoscoToolboxClass, FeedbackChainHoldsRatedSpeed) {
  const int code = run(LAC_SOURCE_DIR "/config/nrel5mw/wrapper_fb.IN");
  if (code == kCannotRun) GTEST_SKIP() << folder.read("out.txt");
  ASSERT_EQ(code, 0) << folder.read("out.txt");
  std::istringstream out(folder.read("out.txt"));
  std::vector<double> speeds_rpm, pitches_deg;
  std::string word;
  for (std::string last; out >> word; last = word) {
    if (word == "rpm") speeds_rpm.push_back(std::stod(last));
    if (word == "deg") pitches_deg.push_back(std::stod(last));
  }
  ASSERT_EQ(speeds_rpm.size(), 12U) << folder.read("out.txt");
  EXPECT_NEAR(speeds_rpm[5], 12.1, 0.02);   // at 60 s
  EXPECT_NEAR(speeds_rpm[11], 12.1, 0.02);  // at 120 s
  EXPECT_GT(pitches_deg[11], pitches_deg[5] + 1.0);
}

// A lidar chain: the script ends with the master's reason.
TEST_F(RoscoToolboxClass, LidarChainIsRefused) {
  const int code = run(LAC_SOURCE_DIR "/config/nrel5mw/wrapper_lac.IN");
  if (code == kCannotRun) GTEST_SKIP() << folder.read("out.txt");
  EXPECT_EQ(code, 1);
  EXPECT_THAT(folder.read("out.txt"),
              testing::AllOf(testing::HasSubstr("LidarLayout native needs records 1101-1320"),
                             testing::HasSubstr("only 164 records of the host's array")));
}

}  // namespace
}  // namespace lac::test
