// SPDX-License-Identifier: Apache-2.0
// The master's own output file.
#include "wrapper/chain_fixture.hpp"

namespace lac::test {
namespace {

using testing::HasSubstr;

class Output : public ChainTest {
 protected:
  std::string chain(const std::string& keys) {
    return write_chain({{"a", "toy_script", "count 47\nset 3303 9.5\n", ""}}, keys);
  }
  static void fly(TestHost& host, int calls) {
    for (int i = 0; i < calls; ++i) {
      ASSERT_EQ(host.call(i == 0 ? 0 : 1), 0) << host.message();
    }
    ASSERT_EQ(host.call(-1), 0) << host.message();
  }
};

// Host and chain signals by name or number, every second call, under the host's root name.
TEST_F(Output, CsvWithDecimation) {
  const auto in = chain(
      "csv ! OutputFormat -\n2 ! OutputDecimation -\n"
      "generatorspeed TorqueDemand LidarRews rec61 ! OutputChannels -\n");
  TestHost host = host_for(in);
  fly(host, 5);
  EXPECT_EQ(folder.read("case.lac.csv"),
            "Time [s],GeneratorSpeed [rad/s],TorqueDemand [Nm],LidarRews [m/s],rec61 [-]\n"
            "0,122.9,1,9.5,3\n0.025,122.9,3,9.5,3\n0.05,122.9,5,9.5,3\n");
}

// Steps done again after a restore are not written again: rows stay equidistant in time.
TEST_F(Output, RedoneStepsStandOnce) {
  const auto in = write_chain({{"a", "toy_state", "", ""}},
                              "csv ! OutputFormat -\nTorqueDemand ! OutputChannels -\n");
  TestHost host = host_for(in);
  for (const int status : {0, 1, -11, 1, -10, 1, 1, -1}) ASSERT_GE(host.call(status), 0);
  const std::string text = folder.read("case.lac.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 4);
  EXPECT_THAT(text, HasSubstr("\n0.0375,"));
}

// A name of the user's, relative to the folder of the root name; the file is there at the end only.
TEST_F(Output, NamedOutb) {
  TestHost host =
      host_for(chain("outb ! OutputFormat -\nmine.outb ! OutputFile -\n"
                     "TorqueDemand ! OutputChannels -\n"));
  ASSERT_EQ(host.call(0), 0) << host.message();
  EXPECT_FALSE(std::filesystem::exists(folder.file("mine.outb")));
  host.call(-1);
  EXPECT_EQ(folder.read("mine.outb").substr(0, 2), std::string("\4\0", 2));
}

// While measured records are in doubt the file shows the demands that were in force.
TEST_F(Output, ShowsDemandsInForce) {
  TestHost host = host_for(chain("csv ! OutputFormat -\nTorqueDemand ! OutputChannels -\n"));
  host.call(0);
  host.set(Rec::RotorSpeed, std::numeric_limits<float>::infinity());
  host.call(1);
  host.set(Rec::RotorSpeed, 1.0f);
  host.call(1);
  host.call(-1);
  EXPECT_EQ(folder.read("case.lac.csv"), "Time [s],TorqueDemand [Nm]\n0,1\n0.0125,1\n0.025,2\n");
}

// A restarted run writes a file of its own that begins where the first ended.
TEST_F(Output, RestartHasItsOwnFile) {
  const auto in = chain("csv ! OutputFormat -\nTorqueDemand ! OutputChannels -\n");
  TestHost host = host_for(in);
  host.call(0);
  host.call(1);
  ASSERT_EQ(host.call_with(-8, folder.file("c.chkp")), 0) << host.message();
  host.call(-1);
  TestHost again = host_for(in);
  ASSERT_EQ(again.call_with(-9, folder.file("c.chkp")), 0) << again.message();
  again.call(1);
  again.call(-1);
  EXPECT_EQ(folder.read("case.lac.csv"), "Time [s],TorqueDemand [Nm]\n0,1\n0.0125,2\n");
  EXPECT_EQ(folder.read("case.lac.2.csv"), "Time [s],TorqueDemand [Nm]\n0.025,3\n");
}

// A run that fails at its start leaves no file behind.
TEST_F(Output, NothingHalfWritten) {
  const auto in = write_chain({{"a", "toy_script", "fail 0 no", ""}},
                              "csv ! OutputFormat -\nTorqueDemand ! OutputChannels -\n");
  TestHost host = host_for(in);
  EXPECT_EQ(host.call(0), -1);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_EQ(entry.path().filename().string().find("lac"), std::string::npos) << entry.path();
  }
}

}  // namespace
}  // namespace lac::test
