// SPDX-License-Identifier: Apache-2.0
// What the host hears when a secondary fails, warns or misbehaves.
#include "wrapper/chain_fixture.hpp"

namespace lac::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class Failures : public ChainTest {
 protected:
  std::string log() const { return folder.file("calls.log"); }
  Row logging(const std::string& name, const std::string& more = "") {
    return {name, "toy_script", "log " + log() + "\n" + more, ""};
  }
};

// The first negative stops the chain for this call, holds the last demands and names who.
TEST_F(Failures, FirstNegativeStopsTheChainAndHolds) {
  TestHost host = host_for(write_chain(
      {logging("a", "count 47"), {"f", "toy_state", "2 ! FailAtStep -", ""}, logging("c")}));
  ASSERT_EQ(host.call(0), 0) << host.message();
  ASSERT_EQ(host.call(1), 0);
  const float held = host.get(Rec::TorqueDemand);
  EXPECT_EQ(host.call(1), -1);
  EXPECT_EQ(host.message(),
            "wrapper: f (libtoy_state" LAC_LIBRARY_SUFFIX "): toy_state: step 2 is the end");
  EXPECT_EQ(host.get(Rec::TorqueDemand), held);
  EXPECT_EQ(host.call(-1), 0);
  EXPECT_EQ(folder.read("calls.log"), "a 0\nc 0\na 1\nc 1\na 1\na -1\nc -1\n");
}

// A failure at the first call ends those that had started and unloads all; nothing is demanded.
TEST_F(Failures, FailedFirstCallEndsThoseThatStarted) {
  TestHost host = host_for(
      write_chain({logging("a", "set 47 5"), logging("f", "fail 0 no such thing"), logging("c")}));
  EXPECT_EQ(host.call(0), -1);
  EXPECT_EQ(host.message(), "wrapper: f (libtoy_script" LAC_LIBRARY_SUFFIX "): no such thing");
  EXPECT_EQ(folder.read("calls.log"), "a 0\nf 0\na -1\n");
  EXPECT_EQ(host.get(Rec::TorqueDemand), 0.0f);
  EXPECT_EQ(host.call(-1), 0);
  EXPECT_EQ(host.call(1), -1);
  EXPECT_THAT(host.message(), HasSubstr("never made a first call"));
}

// The last call reaches all, even if one fails; the messages are collected.
TEST_F(Failures, LastCallReachesAll) {
  TestHost host = host_for(
      write_chain({logging("a", "fail -1 one"), logging("b"), logging("c", "fail -1 two")}));
  host.call(0);
  EXPECT_EQ(host.call(-1), -1);
  EXPECT_EQ(host.message(), "wrapper: a (libtoy_script" LAC_LIBRARY_SUFFIX
                            "): one; c (libtoy_script" LAC_LIBRARY_SUFFIX "): two");
  EXPECT_EQ(folder.read("calls.log"), "a 0\nb 0\nc 0\na -1\nb -1\nc -1\n");
}

// A standing warning is told once, and again after it had gone; warnings of several are merged.
TEST_F(Failures, StandingWarningIsToldOnce) {
  TestHost host = host_for(write_chain({{"a", "toy_script", "warn_at 20 100 200 too fast", ""},
                                        {"b", "toy_script", "warn 1 always", ""}}));
  host.set(Rec::GeneratorSpeed, 90.0f);
  EXPECT_EQ(host.call(0), 0);
  EXPECT_EQ(host.call(1), 1);
  EXPECT_EQ(host.message(), "wrapper: b (libtoy_script" LAC_LIBRARY_SUFFIX "): always");
  for (int i = 0; i < 50; ++i) EXPECT_EQ(host.call(1), 0);
  for (int episode = 0; episode < 2; ++episode) {
    host.set(Rec::GeneratorSpeed, 150.0f);
    EXPECT_EQ(host.call(1), 1);
    EXPECT_EQ(host.message(), "wrapper: a (libtoy_script" LAC_LIBRARY_SUFFIX "): too fast");
    for (int i = 0; i < 50; ++i) EXPECT_EQ(host.call(1), 0);
    host.set(Rec::GeneratorSpeed, 90.0f);
    EXPECT_EQ(host.call(1), 0);
  }
  EXPECT_EQ(host.call(-1), 0);
}

// A text that changes in every step: five at once, then one in 10 s; the rest is counted. In 60 s
// of 0.0125 s steps: 4800 texts, 5 + 6 told (the last when exactly 60 s have passed).
TEST_F(Failures, ChangingWarningDoesNotFlood) {
  TestHost host = host_for(write_chain({{"a", "toy_script", "warn_time", ""}}));
  host.call(0);
  int told = 0;
  for (int i = 0; i < 4800; ++i) told += host.call(1);
  EXPECT_NEAR(told, 11, 1);
  EXPECT_EQ(host.call(-1), 1);
  EXPECT_EQ(host.message(), "wrapper: a (libtoy_script" LAC_LIBRARY_SUFFIX "): " +
                                std::to_string(4800 - told) + " more warnings were not shown");
}

// Writing next to what was lent is noticed at once and laid to the right library.
TEST_F(Failures, WritingOutOfBoundsIsNoticed) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"below", "wrote outside of the swap array"},
      {"above", "wrote outside of the swap array"},
      {"message", "wrote behind the end of the message buffer"},
      {"root", "wrote behind the end of the root name"}};
  for (const auto& [what, text] : cases) {
    TestHost host = host_for(write_chain({{"ok", "toy_script", "", ""},
                                          {"bad", "toy_script", what, ""},
                                          {"after", "toy_script", "", ""}}));
    EXPECT_EQ(host.call(0), -1);
    EXPECT_THAT(host.message(),
                HasSubstr("bad (libtoy_script" LAC_LIBRARY_SUFFIX "): the library " + text));
  }
}

// A message without terminator ends where its buffer ends; the host's ends where its own does.
TEST_F(Failures, MessageWithoutTerminator) {
  TestHost host = host_for(write_chain({{"a", "toy_script", "full_message", ""}}));
  EXPECT_EQ(host.call(0), 1);
  EXPECT_EQ(host.message().size(), 1024U);
  EXPECT_TRUE(host.message_was_terminated());
  EXPECT_THAT(host.message(), HasSubstr("a (libtoy_script" LAC_LIBRARY_SUFFIX "): mmmm"));
  host.call(-1);
  for (const std::size_t capacity : {0U, 1U, 2U, 3U}) {
    host.message_capacity = capacity;
    EXPECT_EQ(host.call(0), 1);
    EXPECT_TRUE(host.message_was_terminated());
    EXPECT_EQ(host.message(), std::string("wr").substr(0, capacity > 0 ? capacity - 1 : 0));
    host.call(-1);
  }
}

// The terminator of the input file's name, counted in record 50, inside an error text (ROSCO):
// the text goes on behind it.
TEST_F(Failures, NameInsideAMessage) {
  TestHost host = host_for(write_chain({{"a", "toy_script", "name_inside", ""}}));
  EXPECT_EQ(host.call(0), 1);
  EXPECT_EQ(host.message(), "wrapper: a (libtoy_script" LAC_LIBRARY_SUFFIX "): in \"" +
                                folder.file("chain.IN_a.txt") + "\": line 7 is wrong");
}

// A C++ exception of a secondary ends in the master.
TEST_F(Failures, ExceptionOfASecondary) {
  TestHost host = host_for(write_chain({{"a", "toy_script", "throw", ""}}));
  EXPECT_EQ(host.call(0), -1);
  EXPECT_THAT(host.message(),
              HasSubstr("a (libtoy_script" LAC_LIBRARY_SUFFIX "): the library threw"));
}

// Status 1 before 0, -1 before 0, and record 3 of zero.
TEST_F(Failures, CallsOutOfOrder) {
  const auto in = write_chain({logging("a")});
  TestHost host = host_for(in);
  EXPECT_EQ(host.call(-1), 0);
  EXPECT_EQ(host.call(1), -1);
  EXPECT_THAT(host.message(),
              HasSubstr("call with status 1 for a turbine that never made a first"));
  for (const float step : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    host.set(Rec::TimeStep, step);
    EXPECT_EQ(host.call(0), -1);
    EXPECT_THAT(host.message(), HasSubstr("record 3 (communication interval) is"));
  }
  EXPECT_EQ(folder.read("calls.log"), "");
}

// Hosts that count no terminator and send none.
TEST_F(Failures, StringsWithoutTerminator) {
  TestHost host = host_for(write_chain({logging("a")}));
  host.counts_terminator = false;
  EXPECT_EQ(host.call(0), 0) << host.message();
  EXPECT_EQ(host.call(1), 0);
  EXPECT_EQ(host.call(-1), 0);
}

}  // namespace
}  // namespace lac::test
