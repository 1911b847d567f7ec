// SPDX-License-Identifier: Apache-2.0
// `lac stats`, `lac compare`, `lac report` and `lac correlate` on the command line: options reach
// the commands.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class AnalysisProgramTest : public ::testing::Test {
 protected:
  AnalysisProgramTest() {
    folder_.write("a.out",
                  "Time Wind1VelX TwrBsMyt GenPwr\n(s) (m/s) (kNm) (kW)\n0 12 1 5000\n1 12 4 5000\n"
                  "2 13 2 5000\n3 12 3 5000\n");
    folder_.write("t.csv",
                  "mean_speed_mps,seed,class,controller,TwrBsMyt_del4 [kNm],GenPwr_mean [kW]\n"
                  "12,1,A,fb,100,5\n12,1,A,lac,90,5\n12,2,A,fb,110,5\n12,2,A,lac,101,5\n"
                  "12,1,B,fb,80,5\n12,1,B,lac,81,5\n12,2,B,fb,81,5\n12,2,B,lac,82,5\n");
  }

  /// The exit code; the texts in out.txt and error.txt.
  int lac(const std::string& arguments) {
    const std::string command = "cd '" + folder_.path().string() +
                                "' && '" LAC_BINARY_DIR "/lac' " + arguments +
                                " > out.txt 2> error.txt < /dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string out() const { return folder_.read("out.txt"); }
  std::string error() const { return folder_.read("error.txt"); }

  lac::test::TempFolder folder_;
};

// Lists in commas take no file behind them; every option arrives.
TEST_F(AnalysisProgramTest, Stats) {
  ASSERT_EQ(lac("stats --channels TwrBsMyt,GenPwr --woehler 3,12 a.out --from 1 --to 3.5 "
                "--reference 2e6in20y --rainflow four-point --csv s.csv"),
            0)
      << error();
  EXPECT_THAT(out(), HasSubstr("a.out: 3.0000 s"));
  EXPECT_THAT(out(), HasSubstr("DEL m=3  DEL m=12"));
  EXPECT_THAT(out(), HasSubstr("2e6 cycles in 20 years (N_ref = 2e6 T / 20 years); four-point"));
  EXPECT_THAT(out(), Not(HasSubstr("Wind1VelX")));
  EXPECT_THAT(folder_.read("s.csv"), HasSubstr("TwrBsMyt_del12 [kNm]"));
  EXPECT_EQ(lac("stats a.out --rainflow three"), 1);
  EXPECT_THAT(error(), HasSubstr("--rainflow"));
}

// One table; a part of it; other winds of a life.
TEST_F(AnalysisProgramTest, Compare) {
  ASSERT_EQ(lac("compare --quantities TwrBsMyt_del4 t.csv --iec-class III --confidence 0.9"), 0)
      << error();
  EXPECT_THAT(out(), HasSubstr("12            4"));
  EXPECT_THAT(out(), HasSubstr("not significant at 90 % at 12 m/s"));
  EXPECT_THAT(out(), HasSubstr("scale 8.46 m/s, shape 2"));
  EXPECT_THAT(out(), Not(HasSubstr("GenPwr")));
  ASSERT_EQ(lac("compare t.csv --where class=A --weibull 9 1.8 --csv c.csv"), 0) << error();
  EXPECT_THAT(out(), HasSubstr("TwrBsMyt_del4 [kNm]: significant at 12 m/s"));
  EXPECT_THAT(out(), HasSubstr("scale 9.00 m/s, shape 1.8"));
  EXPECT_THAT(folder_.read("c.csv"), HasSubstr("TwrBsMyt_del4,kNm,12,2,105,95.5,"));
  ASSERT_EQ(lac("compare t.csv t.csv --baseline fb --against fb"), 0) << error();
  EXPECT_EQ(lac("compare t.csv --baseline mpc"), 1);
  EXPECT_THAT(error(), HasSubstr("there are: fb, lac"));
}

// One controller over a life.
TEST_F(AnalysisProgramTest, Life) {
  ASSERT_EQ(lac("life t.csv --controller lac --quantities GenPwr_mean --where class=A"), 0)
      << error();
  EXPECT_THAT(out(), HasSubstr("12.0         2"));
  EXPECT_THAT(out(), HasSubstr("energy of a year from GenPwr_mean"));
  EXPECT_EQ(lac("life t.csv"), 1);
  EXPECT_THAT(error(), HasSubstr("has 2 controllers (fb, lac), expected 1; --controller names it"));
}

// A page beside the table or where it is wanted; what it is made from.
TEST_F(AnalysisProgramTest, Report) {
  ASSERT_EQ(lac("report t.csv --quantities TwrBsMyt_del4 --title Two --confidence 0.9 "
                "--iec-class III"),
            0)
      << error();
  EXPECT_THAT(out(), HasSubstr("wrote t.html"));
  const std::string page = folder_.read("t.html");
  EXPECT_THAT(page, HasSubstr("<title>Two</title>"));
  EXPECT_THAT(page, HasSubstr("From A = fb to B = lac: class = A"));
  EXPECT_THAT(page, HasSubstr("90 % interval"));
  EXPECT_THAT(page, HasSubstr("scale 8.46 m/s"));
  ASSERT_EQ(lac("report t.csv -o p.html --baseline lac --where class=B"), 0) << error();
  EXPECT_THAT(folder_.read("p.html"), HasSubstr("From A = lac to B = fb: all runs"));
  EXPECT_EQ(lac("report ."), 1);
  EXPECT_THAT(error(), HasSubstr("has no results.csv"));
}

// Tables of loads of two conventions do not compare.
TEST_F(AnalysisProgramTest, ConventionsOfLoads) {
  ASSERT_EQ(lac("stats a.out --csv one.csv"), 0) << error();
  ASSERT_EQ(lac("stats a.out --csv two.csv --reference 2e6in20y"), 0) << error();
  EXPECT_THAT(folder_.read("two.csv"), HasSubstr("a.out,2e6in20y,astm,"));
  const std::string load = " --quantities TwrBsMyt_del4";
  EXPECT_EQ(lac("compare one.csv two.csv" + load), 1);
  EXPECT_THAT(error(), HasSubstr("of different conventions"));
  ASSERT_EQ(lac("compare one.csv one.csv" + load), 0) << error();
  EXPECT_THAT(out(), HasSubstr("DEL: R the full range, reference one cycle per second"));
  ASSERT_EQ(lac("life two.csv" + load), 0) << error();
  EXPECT_THAT(out(), HasSubstr("DEL: R the full range, reference 2e6 cycles in 20 years"));
}

// What nothing would come of is refused: of tables and of folders.
TEST_F(AnalysisProgramTest, OptionsWithoutEffect) {
  for (const char* option :
       {"--from 1", "--to 3", "--woehler 4", "--reference 1hz", "--rainflow astm"}) {
    EXPECT_EQ(lac(std::string("compare t.csv ") + option), 1) << option;
    EXPECT_THAT(error(), HasSubstr(" has no effect: the figures of a table are computed already"));
    EXPECT_EQ(lac(std::string("life t.csv --controller fb ") + option), 1) << option;
    EXPECT_THAT(error(), HasSubstr(" has no effect: the figures of a table are computed already"));
  }
  std::filesystem::create_directory(folder_.path("runs"));
  folder_.write("runs/a.out", folder_.read("a.out"));
  for (const char* option : {"--where a=b", "--pair-by seed", "--column name"}) {
    EXPECT_EQ(lac(std::string("compare runs runs ") + option), 1) << option;
    EXPECT_THAT(error(), HasSubstr(" has no effect: it is for tables"));
    EXPECT_EQ(lac(std::string("life runs ") + option), 1) << option;
    EXPECT_THAT(error(), HasSubstr(" has no effect: it is for tables"));
  }
  EXPECT_EQ(lac("life runs --controller fb"), 1);
  EXPECT_THAT(error(), HasSubstr("--controller has no effect: runs is a folder"));
  EXPECT_EQ(lac("compare runs runs --against fb"), 1);
  EXPECT_THAT(error(), HasSubstr("--against has no effect: runs is a folder"));
  ASSERT_EQ(lac("compare runs runs --from 1 --quantities GenPwr_mean"), 0) << error();
}

// Options reach the command; a record too short for its windows, a wrong channel and numbers that
// cannot be are errors.
TEST_F(AnalysisProgramTest, Correlate) {
  const std::string channels = " --power GenPwr --pitch GenPwr --load TwrBsMyt --rate 1";
  const std::string wind = "correlate a.out --wind Wind1VelX --ranges 50";
  ASSERT_EQ(lac(wind + " --window 4 --max-delay 0" + channels), 0) << error();
  EXPECT_THAT(out(), HasSubstr("Wind1VelX: 4 samples: 0 missing"));
  EXPECT_EQ(lac(wind + " --window 75" + channels), 1);
  EXPECT_THAT(error(), HasSubstr("no complete window: the series have 4.0 s, a window of 75.0 s"));
  for (const char* option : {"--fill -1", "--ti 0", "--rated-power -5", "--availability 1.5",
                             "--window 0", "--block -3"}) {
    EXPECT_EQ(lac(wind + channels + " " + option), 1) << option;
    EXPECT_THAT(error(), HasSubstr(std::string(option).substr(0, 4)));
  }
  EXPECT_EQ(lac("correlate a.out --wind Wind1VelY" + channels), 1);
  EXPECT_THAT(error(), HasSubstr("(did you mean 'Wind1VelX'?)"));
}

}  // namespace
}  // namespace lac::sim
