// SPDX-License-Identifier: Apache-2.0
// The program lac as a user meets it: exit codes and texts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "sim_harness/run/probe_case.hpp"
#include "sim_harness/tables/outb_reader.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string error;
};

class LacProgramTest : public ::testing::Test {
 protected:
  Outcome lac(const std::string& arguments) {
    const std::string command = "cd '" + files_.folder.path().string() +
                                "' && '" LAC_BINARY_DIR "/lac' " + arguments +
                                " > out.txt 2> error.txt < /dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, files_.folder.read("out.txt"),
            files_.folder.read("error.txt")};
  }

  void expect_failure(const std::string& arguments, const std::string& text) {
    const Outcome o = lac(arguments);
    EXPECT_EQ(o.exit_code, 1) << arguments;
    EXPECT_THAT(o.error, AllOf(StartsWith("lac: "), HasSubstr(text), EndsWith("\n")));
    EXPECT_EQ(o.out, "") << arguments;
  }

  test::ProbeCase files_;
};

TEST_F(LacProgramTest, Version) {
  const Outcome o = lac("--version");
  EXPECT_EQ(o.exit_code, 0);
  for (const char* part : {"lac 0.", "SUNDIALS ", "3300", "native lidar", "1101"}) {
    EXPECT_THAT(o.out, HasSubstr(part));
  }
}

TEST_F(LacProgramTest, Help) {
  for (const char* arguments : {"", "--help", "run --help"}) {
    const Outcome o = lac(arguments);
    EXPECT_EQ(o.exit_code, 0) << arguments;
    EXPECT_THAT(o.out, HasSubstr("Usage: lac")) << arguments;
  }
  EXPECT_THAT(lac("run --help").out, HasSubstr("--set"));
}

// A wrong word says what was meant.
TEST_F(LacProgramTest, WrongWords) {
  expect_failure("rum case.yaml", "unknown command 'rum' (did you mean 'run'?)");
  expect_failure("--versoin", "unknown option '--versoin' (did you mean '--version'?)");
  expect_failure("run case.yaml --outptu=x", "'--outptu' (did you mean '--output'?)");
  expect_failure("rnu", "unknown command 'rnu' (did you mean 'run'?)");
  expect_failure("run", "case is required; 'lac run --help' lists what there is");
  expect_failure("run case.yaml more", "unknown word 'more'");
}

// lac run: table, files where they are asked for, overrides.
TEST_F(LacProgramTest, Run) {
  files_.file();
  const Outcome o = lac("run case.yaml --output elsewhere --set time.duration_s=10");
  EXPECT_EQ(o.exit_code, 0) << o.error;
  EXPECT_THAT(o.out, HasSubstr("Rotor speed, maximum"));
  EXPECT_THAT(o.out, HasSubstr("wrote elsewhere/first.outb"));
  EXPECT_EQ(read_outb(files_.folder.path() / "elsewhere/first.outb").rows(), 801U);
  EXPECT_FALSE(fs::exists(files_.folder.path() / "results"));
}

// Two --set in a row, one of them wrong.
TEST_F(LacProgramTest, RunWithWrongOverride) {
  files_.file();
  expect_failure("run case.yaml --set seed=3 --set wind.speed_mps=fast",
                 "--set wind.speed_mps=fast: wind.speed_mps: found 'fast', expected a number");
  expect_failure("run case.yaml --set seed", "--set seed: expected key=value");
}

TEST_F(LacProgramTest, RunFailures) {
  expect_failure("run none.yaml", "none.yaml: cannot be read: no such file; expected a YAML file");
  files_.file("speed_mps: 18", "sped: 18");
  expect_failure("run case.yaml", "case.yaml:6: wind.speed_mps: the key is missing");
  files_.file("/libtoy_recorder}", "/libnot_there}");
  const Outcome o = lac("run case.yaml");
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_THAT(o.error, HasSubstr("second: library '" LAC_TOY_DIR "/libnot_there' not found"));
}

// lac check on the shipped chain: order of calls, who reads and writes what.
TEST_F(LacProgramTest, Check) {
  const Outcome o = lac("check '" LAC_SOURCE_DIR "/config/nrel5mw/wrapper_lac.IN'");
  EXPECT_EQ(o.exit_code, 0) << o.error;
  EXPECT_LT(o.out.find("liblac_ldp"), o.out.find("liblac_ffp"));
  EXPECT_LT(o.out.find("liblac_ffp"), o.out.find("liblac_feedback"));
  EXPECT_THAT(o.out, ::testing::ContainsRegex("3303 +LidarRews +ldp +ffp"));
  EXPECT_THAT(o.out, ::testing::ContainsRegex("1101-1320 +native lidar +host +ldp, ti_estimator"));
  EXPECT_THAT(o.out, ::testing::ContainsRegex("3321 +FeedforwardPitchRate +ffp +feedback"));
  EXPECT_THAT(o.out, ::testing::ContainsRegex("20 +GeneratorSpeed +host +feedback"));
  EXPECT_THAT(o.out, HasSubstr("The chain is ready to fly."));
}

// Every chain that is shipped and needs nothing from elsewhere is ready to fly.
TEST_F(LacProgramTest, CheckShippedChains) {
  for (const char* chain :
       {"nrel5mw/wrapper_fb.IN", "nrel5mw/wrapper_point.IN", "openfast/wrapper.IN"}) {
    const Outcome o = lac("check '" LAC_SOURCE_DIR "/config/" + std::string(chain) + "'");
    EXPECT_EQ(o.exit_code, 0) << chain << ": " << o.error;
    EXPECT_THAT(o.out, ::testing::Not(HasSubstr("note: "))) << chain;
  }
}

// Two writers of one record are refused, with both names and the line that allows them.
TEST_F(LacProgramTest, CheckRefusesTwoWriters) {
  const auto row = [](const std::string& name, int number) {
    return "\"" + name + "\" \"" LAC_TOY_DIR "/libtoy_script\" \"" + name + ".IN\" ! Secondary_" +
           std::to_string(number) + " - \n";
  };
  files_.folder.write("one.IN", "set 47 0\nset 3350 1\nset 3351 1\n");
  files_.folder.write("two.IN", "set 47 1000\nadd 3350 3350 1\n");
  const std::string rows =
      row("one", 1) + row("two", 2) + "Flow 3350 ! Signal_1 - \n\"Idle\" 3352 ! Signal_2 - \n";
  files_.folder.write("chain.IN", rows);
  const Outcome o = lac("check chain.IN");
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_THAT(o.error, HasSubstr("record 47 (TorqueDemand): one, two"));
  EXPECT_THAT(o.error, HasSubstr("record 3350 (Flow): one, two"));
  EXPECT_THAT(o.error, HasSubstr("\n  TorqueDemand Flow ! SharedRecords"));
  EXPECT_THAT(o.error, ::testing::Not(HasSubstr("3351")));
  EXPECT_THAT(o.out, ::testing::ContainsRegex("3350 +Flow +one, two +two"));
  EXPECT_THAT(o.out, HasSubstr("signal Idle (record 3352) is written by nobody"));
  EXPECT_THAT(o.out, ::testing::Not(HasSubstr("ready to fly")));

  files_.folder.write("chain.IN", rows + "torquedemand rec3350 rec48 ! SharedRecords - \n");
  const Outcome allowed = lac("check chain.IN");
  EXPECT_EQ(allowed.exit_code, 0) << allowed.error;
  EXPECT_THAT(allowed.out,
              HasSubstr("SharedRecords names YawRateDemand, which no two secondaries"));
  EXPECT_THAT(allowed.out, HasSubstr("ready to fly"));
  files_.folder.write("chain.IN", rows + "TorqueDemnd ! SharedRecords - \n");
  expect_failure("check chain.IN", "SharedRecords: found 'TorqueDemnd'");
}

// With ExtendedDemands the host sends 2601-3000, without it nobody does.
TEST_F(LacProgramTest, CheckKnowsWhoSendsExtendedDemands) {
  files_.folder.write("toy.IN", "add 47 2700 0\n");
  const std::string row = "\"toy\" \"" LAC_TOY_DIR "/libtoy_script\" \"toy.IN\" ! Secondary_1 - \n";
  files_.folder.write("chain.IN", row + "true ! ExtendedDemands - \n");
  EXPECT_THAT(lac("check chain.IN").out, ::testing::ContainsRegex("2700 +- +host +toy\n"));
  files_.folder.write("chain.IN", row);
  const Outcome o = lac("check chain.IN");
  EXPECT_THAT(o.out, ::testing::ContainsRegex("2700 +- +nobody +toy\n"));
  EXPECT_THAT(o.out, HasSubstr("note: record 2700 is read by toy, but written by nobody"));
}

// lac trace: what OpenFAST sent, from a recording.
TEST_F(LacProgramTest, Trace) {
  const Outcome o = lac("trace '" LAC_SOURCE_DIR "/tests/data/openfast/feedback.lactrace'");
  EXPECT_EQ(o.exit_code, 0) << o.error;
  for (const char* text :
       {"3300 records", "Calls: 403 (status: calls, -8: 1, -1: 1, 0: 1, 1: 400)", "step 0.025",
        "record 50: 11, terminator counted", "Message: 8197", "Lidar: none"}) {
    EXPECT_THAT(o.out, HasSubstr(text));
  }
  EXPECT_THAT(o.out, ::testing::ContainsRegex("61 +NumberOfBlades +- +3 +3 +3 +1\n"));
  EXPECT_THAT(o.out, ::testing::ContainsRegex("47 +TorqueDemand +Nm +43093.55"));
  EXPECT_THAT(lac("trace '" LAC_SOURCE_DIR "/tests/data/openfast/lidar.lactrace'").out,
              HasSubstr("sensor type 3 (pulsed), 1 beams, 5 gates"));
  expect_failure("trace none.lactrace", "none.lactrace: cannot be read");
}

// Faults of a chain: the master's input, a secondary that is not there, a secondary's own input.
TEST_F(LacProgramTest, CheckFailures) {
  expect_failure("check none.IN", "none.IN");
  const auto chain = [&](const std::string& library, const std::string& input) {
    files_.folder.write("chain.IN", "\"a\" \"" + library + "\" \"" + input +
                                        "\" ! Secondary_1 - \nnone ! LidarLayout - \n"
                                        "none ! OutputFormat - \n");
    return std::string("check chain.IN");
  };
  files_.folder.write("ldp.IN", "1.0 ! ScanTimes - \n");
  expect_failure(chain("liblac_nothing", "ldp.IN"), "liblac_nothing");
  expect_failure(chain("liblac_ldp", "gone.IN"), "gone.IN");
  expect_failure(chain("liblac_ldp", "ldp.IN"), "ldp.IN");
  files_.folder.write("chain.IN", "none ! LidarLayuot - \n");
  expect_failure("check chain.IN", "chain.IN");
}

// A trial leaves the user's results alone, also those with an absolute name.
TEST_F(LacProgramTest, CheckLeavesResultsAlone) {
  const std::string result = files_.folder.write("result.csv", "an hour of work\n");
  files_.folder.write("toy.IN", "set 47 1000\n");
  const std::string rows = "\"toy\" \"" LAC_TOY_DIR
                           "/libtoy_script\" \"toy.IN\" ! Secondary_1 - \n"
                           "csv ! OutputFormat - \nGeneratorSpeed ! OutputChannels - \n";
  files_.folder.write("chain.IN", rows + "\"" + result + "\" ! OutputFile - \n");
  const Outcome o = lac("check chain.IN");
  EXPECT_EQ(o.exit_code, 0) << o.error;
  EXPECT_EQ(files_.folder.read("result.csv"), "an hour of work\n");
  EXPECT_FALSE(fs::exists(result + ".part"));
  files_.folder.write("chain.IN", rows + "/not/there/result.csv ! OutputFile - \n");
  expect_failure("check chain.IN", "OutputFile: /not/there/result.csv cannot be created");
}

// A secondary that fails after the first call, in every way there is: not ready to fly.
TEST_F(LacProgramTest, CheckFindsLateFailures) {
  const auto row = [](const std::string& name, int number) {
    return "\"" + name + "\" \"" LAC_TOY_DIR "/libtoy_script\" \"" + name + ".IN\" ! Secondary_" +
           std::to_string(number) + " - \n";
  };
  files_.folder.write("chain.IN", row("bad", 1) + row("good", 2));
  files_.folder.write("good.IN", "add 45 20 0\n");
  const std::pair<const char*, const char*> cases[] = {
      {"fail 1 the fuse blew\n", "bad was not observed to the end: the fuse blew"},
      {"nan 47 1\n", "bad was not observed to the end: demand in record 47 is not finite"},
  };
  for (const auto& [script, text] : cases) {
    files_.folder.write("bad.IN", script);
    const Outcome o = lac("check chain.IN");
    EXPECT_EQ(o.exit_code, 1) << script;
    EXPECT_THAT(o.error, AllOf(StartsWith("lac: "), HasSubstr(text)));
    EXPECT_THAT(o.out, ::testing::ContainsRegex("20 +GeneratorSpeed +host +good"));
    EXPECT_THAT(o.out, ::testing::Not(HasSubstr("ready to fly")));
  }
  files_.folder.write("bad.IN", "fail -1 no landing\n");
  expect_failure("check chain.IN", "no landing");
  files_.folder.write("bad.IN", "throw\n");
  expect_failure("check chain.IN", "the library threw a C++ exception");
}

// A chain that needs the lidar, without the key that passes it on: said, with the key's name.
TEST_F(LacProgramTest, CheckNamesMissingLidarLayout) {
  files_.folder.write("chain.IN", "\"ldp\" \"liblac_ldp\" \"" LAC_SOURCE_DIR
                                  "/config/nrel5mw/ldp.IN\" ! Secondary_1 - \n");
  const Outcome o = lac("check chain.IN");
  EXPECT_EQ(o.exit_code, 0) << o.error;
  EXPECT_THAT(o.out, HasSubstr("LidarLayout is none, but ldp reads the native lidar block"));
  EXPECT_THAT(lac("check '" LAC_SOURCE_DIR "/config/nrel5mw/wrapper_lac.IN'").out,
              ::testing::Not(HasSubstr("LidarLayout")));
}

}  // namespace
}  // namespace lac::sim
