// SPDX-License-Identifier: Apache-2.0
// The program itself: killed in the middle of a campaign, wrong words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "sim_harness/campaign/study_folder.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;

constexpr int kCases = 40;

class CampaignProgramTest : public ::testing::Test {
 protected:
  CampaignProgramTest() {
    files_.study(
        "set: {time.duration_s: 100}\n"
        "ranges:\n"
        "  wind.speed_mps: {from: 14, to: 23.5, step: 0.5}\n"
        "  kind: {a: {}, b: {controllers.0.name: other}}\n");
  }

  pid_t start(const std::string& output) {
    const std::string study = files_.folder.file("study.yaml");
    const std::string folder = files_.folder.file(output);
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(STDOUT_FILENO);
      ::close(STDERR_FILENO);
      ::execl(LAC_BINARY_DIR "/lac", "lac", "campaign", study.c_str(), "--output", folder.c_str(),
              "--jobs", "2", nullptr);
      ::_exit(127);
    }
    return child;
  }

  int finish(const std::string& output) {
    int status = 0;
    ::waitpid(start(output), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  int done(const std::string& output) const {
    int count = 0;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(files_.folder.path(output) / "cases", none))
      count += fs::exists(entry.path() / "done");
    return count;
  }

  /// Sends the signal once so many cases are done; the status with which it ended.
  int stop_at(int signal, const std::string& output, int count) {
    const pid_t child = start(output);
    int status = 0;
    while (done(output) < count) {
      if (::waitpid(child, &status, WNOHANG) == child) return status;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ::kill(child, signal);
    ::waitpid(child, &status, 0);
    return status;
  }

  test::StudyFolder files_;
};

// Killed three times and resumed, the table is that of a campaign left in peace, byte for byte.
TEST_F(CampaignProgramTest, KilledThreeTimes) {
  ASSERT_EQ(finish("peace"), 0);
  for (const int count : {3, 11, 19}) {
    const int status = stop_at(SIGKILL, "war", count);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    ASSERT_FALSE(fs::exists(files_.folder.path("war/results.csv")));
    ASSERT_GE(done("war"), count);
    ASSERT_LT(done("war"), kCases);
  }
  ASSERT_EQ(finish("war"), 0);
  EXPECT_EQ(done("war"), kCases);
  EXPECT_EQ(files_.folder.read("war/results.csv"), files_.folder.read("peace/results.csv"));
  for (const char* name : {"speed_mps-14_a/toy.outb", "speed_mps-23.5_b/other.outb"})
    EXPECT_EQ(files_.folder.read(std::string("war/cases/") + name),
              files_.folder.read(std::string("peace/cases/") + name));
}

// Asked to stop: flights in the air are given up, not counted as failures, and the rest can go on.
TEST_F(CampaignProgramTest, AskedToStop) {
  const int status = stop_at(SIGTERM, "stop", 4);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
  const std::string table = files_.folder.read("stop/results.csv");
  EXPECT_NE(table.find(",open,"), std::string::npos);
  EXPECT_EQ(table.find(",failed,"), std::string::npos);
  EXPECT_EQ(finish("stop"), 0);
}

// The list of commands, run one by one by somebody else, leaves what the campaign then counts.
TEST_F(CampaignProgramTest, CommandsOfTheList) {
  files_.study("ranges: {wind.speed_mps: [16, 18]}\n");
  ASSERT_EQ(finish("list"), 0);
  const std::string table = files_.folder.read("list/results.csv");
  fs::remove_all(files_.folder.path("list/cases"));
  const std::string command = "sh '" + files_.folder.file("list/cases.txt") + "' > /dev/null 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(done("list"), 2);
  const auto written = fs::last_write_time(files_.folder.path("list/cases/speed_mps-16/done"));
  ASSERT_EQ(finish("list"), 0);
  EXPECT_EQ(files_.folder.read("list/results.csv"), table);
  EXPECT_EQ(fs::last_write_time(files_.folder.path("list/cases/speed_mps-16/done")), written);
}

// Options that mean nothing are refused before anything is flown.
TEST_F(CampaignProgramTest, WrongWords) {
  const auto error = [&](const std::string& arguments) {
    const std::string file = files_.folder.file("error.txt");
    const std::string command = "cd '" + files_.folder.path().string() +
                                "' && '" LAC_BINARY_DIR "/lac' " + arguments + " 2> '" + file + "'";
    EXPECT_NE(std::system(command.c_str()), 0) << arguments;
    return files_.folder.read("error.txt");
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(error("campaign study.yaml --only done"), HasSubstr("--only"));
  EXPECT_THAT(error("campaign study.yaml --jobs 0"), HasSubstr("--jobs"));
  EXPECT_THAT(error("campaign study.yaml --dryrun"), HasSubstr("did you mean '--dry-run'?"));
  EXPECT_THAT(error("campaign none.yaml"), HasSubstr("none.yaml: cannot be read: no such file"));
  EXPECT_THAT(error("run case.yaml --mark"), HasSubstr("--mark requires --output"));
  EXPECT_FALSE(fs::exists(files_.folder.path("results")));
}

}  // namespace
}  // namespace lac::sim
