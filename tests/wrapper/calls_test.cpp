// SPDX-License-Identifier: Apache-2.0
// Who is called when, and with which strings and records.
#include "support/process_state.hpp"
#include "wrapper/chain_fixture.hpp"

namespace lac::test {
namespace {

using testing::HasSubstr;

class Calls : public ChainTest {
 protected:
  std::string log() const { return folder.file("calls.log"); }
  Row logging(const std::string& name, const std::string& more = "") {
    return {name, "toy_script", "log " + log() + "\n" + more, ""};
  }
};

// The rows are called in the order of their numbers, not of their lines, with every status.
TEST_F(Calls, OrderFollowsTheNumbers) {
  folder.write("s.txt", "log " + log());
  const std::string row = "\" \"" + toy("toy_script") + "\" s.txt ! Secondary_";
  const auto in = folder.write("chain.IN", "\"second" + row + "2 -\n\"first" + row + "1 -\n");
  TestHost host = host_for(in);
  EXPECT_EQ(host.call(0), 0) << host.message();
  EXPECT_EQ(host.call(1), 0);
  EXPECT_EQ(host.call(-1), 0);
  EXPECT_EQ(folder.read("calls.log"),
            "first 0\nsecond 0\nfirst 1\nsecond 1\nfirst -1\nsecond -1\n");
}

// Unknown statuses reach no secondary, and neither do -10 and -11 if it is not one of ours.
TEST_F(Calls, UnknownStatusesReachNobody) {
  TestHost host = host_for(write_chain({logging("a")}));
  host.call(0);
  for (const int status : {2, -2, -7, -12, 77}) EXPECT_EQ(host.call(status), 0);
  EXPECT_EQ(host.call(-11), 1);
  EXPECT_THAT(host.message(), HasSubstr("a (libtoy_script" LAC_LIBRARY_SUFFIX
                                        ") does not know statuses -11 and -10"));
  EXPECT_EQ(host.call(-10), 0);
  host.call(-1);
  EXPECT_EQ(folder.read("calls.log"), "a 0\na -1\n");
}

// What a secondary sees of its strings and of records 49-51, 62-66 and 129; the bytes at the
// counted terminators are zero, the message buffer is zeroed and aviFAIL preset, also after a
// call that left rubbish behind.
TEST_F(Calls, EachHasItsOwnStringsAndRecords) {
  const std::string script = "echo " + folder.file("echo") + "\nleave_rubbish\n";
  const auto in =
      write_chain({{"one", "toy_script", script, ""}, {"two", "toy_script", script, ""}});
  TestHost host = host_for(in);
  ASSERT_EQ(host.call(0), 0) << host.message();
  host.call(1);
  const auto line = [&](const std::string& name, int status) {
    const std::string file = folder.file("chain.IN_" + name + ".txt");
    const std::string root = folder.file("case." + name + ".SrvD");
    return "in=" + file + " end=0 out=" + root +
           " end=0 zeroed=1 fail=0 1=" + std::to_string(status) + " 49=2049 " +
           "62=300 63=3401 64=12601 65=0 66=1001 129=3820\n";
  };
  EXPECT_EQ(folder.read("echo"), line("one", 0) + line("two", 0) + line("one", 1) + line("two", 1));
}

// Record 65 counts values in the private logging area, which the host does not have.
TEST_F(Calls, LogCountDoesNotReachTheHost) {
  TestHost host = host_for(write_chain({{"a", "toy_script", "set 65 7", ""}}));
  host.set(Rec::LogCount, 3.0f);
  host.call(0);
  EXPECT_EQ(host.get(Rec::LogCount), 0.0f);
}

// The master cannot be its own secondary.
TEST_F(Calls, MasterUnderMasterIsRefused) {
  const auto inner = write_chain({logging("a")}, "", "inner.IN");
  const auto outer = folder.write(
      "outer.IN", "\"w\" \"" + master_path() + "\" \"inner.IN\" ! Secondary_1 - wrapper\n");
  TestHost host = host_for(outer);
  EXPECT_EQ(host.call(0), -1);
  EXPECT_THAT(host.message(), HasSubstr("the wrapper is called by a wrapper"));
}

// Another entry name; a name that does not exist differs only in case.
TEST_F(Calls, EntryNameIsTakenFromTheRow) {
  TestHost host = host_for(write_chain({{"a", "toy_empty", "", "my_controller"}}));
  ASSERT_EQ(host.call(0), 0) << host.message();
  EXPECT_EQ(host.get(Rec::TorqueDemand), 4711.0f);
  host.call(-1);
  TestHost other = host_for(write_chain({{"a", "toy_empty", "", "My_Controller"}}, "", "b.IN"));
  EXPECT_EQ(other.call(0), -1);
  EXPECT_THAT(other.message(), HasSubstr("b.IN:2: Secondary_1: " + toy("toy_empty") +
                                         ": has no entry 'My_Controller'"));
}

// A library name without prefix path is searched beside the input file, suffix or not.
TEST_F(Calls, LibraryBesideTheInputFile) {
  std::filesystem::copy(toy("toy_empty"), folder.path("libmine" LAC_LIBRARY_SUFFIX));
  for (const std::string name : {"libmine", "libmine" LAC_LIBRARY_SUFFIX, "./libmine"}) {
    TestHost host = host_for(write_chain({{"a", folder.file(name), "", ""}}, "", "a.IN"));
    EXPECT_EQ(host.call(0), 0) << host.message();
    host.call(-1);
    folder.write("e.txt", "");
    folder.write("b.IN", "a " + name + " e.txt ! Secondary_1 -\n");
    TestHost bare = host_for(folder.file("b.IN"));
    EXPECT_EQ(bare.call(0), 0) << bare.message();
    bare.call(-1);
  }
}

// After -1 no library is left in memory, shared image or own.
TEST_F(Calls, LibrariesAreUnloadedAtTheEnd) {
  TestHost host = host_for(
      write_chain({logging("a"), {"b", "toy_state", "", ""}, {"c", "toy_static", "", ""}}));
  const int before = loaded_libraries();
  ASSERT_EQ(host.call(0), 0) << host.message();
  EXPECT_TRUE(is_loaded(toy("toy_script")) && is_loaded(toy("toy_state")));
  EXPECT_GT(loaded_libraries(), before);
  host.call(-1);
  EXPECT_FALSE(is_loaded(toy("toy_script")) || is_loaded(toy("toy_state")));
  EXPECT_EQ(loaded_libraries(), before);
}

// Two runs in one process with a library that refuses a second start in one image.
TEST_F(Calls, SecondRunStartsFresh) {
  TestHost host = host_for(write_chain({{"a", "toy_static", "", ""}}));
  for (int run = 0; run < 2; ++run) {
    ASSERT_EQ(host.call(0), 0) << host.message();
    EXPECT_EQ(host.call(1), 0);
    EXPECT_EQ(host.get(Rec::TorqueDemand), 2.0f);
    EXPECT_EQ(host.call(-1), 0);
  }
}

// A first call that is repeated without an end replaces the run.
TEST_F(Calls, RepeatedFirstCallReplacesTheRun) {
  TestHost host = host_for(write_chain({logging("a"), {"s", "toy_state", "", ""}}));
  host.call(0);
  host.call(1);
  EXPECT_EQ(host.call(0), 0);
  EXPECT_EQ(host.get(Rec::PitchDemandCollective), 0.0f);
  host.call(-1);
  EXPECT_EQ(folder.read("calls.log"), "a 0\na 1\na -1\na 0\na -1\n");
}

}  // namespace
}  // namespace lac::test
