// SPDX-License-Identifier: Apache-2.0
// The built probe between a host and a controller.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/discon_caller.hpp"
#include "support/temp_folder.hpp"
#include "support/test_host.hpp"
#include "tools/host_probe/host_trace.hpp"

namespace lac::test {
namespace {

using testing::HasSubstr;

class HostProbeTest : public testing::Test {
 protected:
  std::string probe_input(const std::string& library, const std::string& controller_input) const {
    return folder_.write("probe.IN", "\"" LAC_TOY_DIR "/" + library + "\" ! Controller - \n\"" +
                                         controller_input + "\" ! ControllerInput - \n");
  }
  std::unique_ptr<DisconCaller> caller(const std::string& library, const std::string& input,
                                       const std::string& root) const {
    return std::make_unique<DisconCaller>(library, input, kExtendedArraySize, folder_.file(root));
  }
  static std::vector<float> array_of(DisconCaller& c) {
    return {c.swap().data(), c.swap().data() + c.swap().size()};
  }

  TempFolder folder_;
};

// Arrays, warnings, messages and the controller's own strings: as without the probe. And the trace
// says what passed.
TEST_F(HostProbeTest, ChangesNothingAndWritesAll) {
  folder_.write("toy.IN", "count 120\nadd 47 20 1000\nwarn_at 120 3 3 three\necho " +
                              folder_.file("echo.txt") + "\n");
  const auto direct = caller(LAC_TOY_DIR "/libtoy_script", folder_.file("toy.IN"), "run.SrvD");
  const auto probed =
      caller("liblac_host_probe", probe_input("libtoy_script", "toy.IN"), "run.SrvD");
  std::string echoes[2];
  std::vector<std::vector<float>> answers;
  for (int n = 0; n < 5; ++n) {
    for (DisconCaller* c : {direct.get(), probed.get()}) {
      c->swap().set(Rec::GeneratorSpeed, 100.0 + n);
      EXPECT_EQ(c->call(n == 0 ? 0 : n == 4 ? -1 : 1), n == 2 ? 1 : 0) << c->message();
      EXPECT_THAT(c->message(), HasSubstr(n == 2 ? "three" : ""));
      echoes[c == direct.get() ? 0 : 1] += folder_.read("echo.txt");
    }
    direct->swap().set(Rec::InFileLength, probed->swap().get(Rec::InFileLength));
    EXPECT_EQ(array_of(*direct), array_of(*probed));
    direct->swap().set(Rec::InFileLength, static_cast<double>(folder_.file("toy.IN").size() + 1));
    answers.push_back(array_of(*probed));
  }
  TraceReader trace(folder_.file("run.lactrace"));
  EXPECT_EQ(trace.records(), kExtendedArraySize);
  for (std::size_t n = 0; n < 5; ++n) {
    TraceCall call;
    ASSERT_TRUE(trace.next(call));
    EXPECT_EQ(call.sent[19], 100.0F + static_cast<float>(n));
    EXPECT_EQ(call.answer, answers[n]);
    EXPECT_EQ(call.fail, n == 2 ? 1 : 0);
    EXPECT_EQ(call.message, n == 2 ? "three" : "");
    EXPECT_EQ(call.in_file, folder_.file("probe.IN"));
    EXPECT_EQ(call.out_name, folder_.file("run.SrvD"));
  }
  TraceCall none;
  EXPECT_FALSE(trace.next(none));
}

// Checkpoint and restart pass through; the restarted run has a trace of its own.
TEST_F(HostProbeTest, Restart) {
  folder_.write("toy.IN", "0.5 ! Weight - \n");
  const std::string input = probe_input("libtoy_state", "toy.IN");
  const std::string checkpoint = folder_.file("run.3.dll.chkp");
  const DisconLibrary probe = DisconLibrary::open("liblac_host_probe", "DISCON", {LAC_LIBRARY_DIR});
  const auto fly = [](TestHost& h, int from, int to) {
    for (int n = from; n < to; ++n) {
      h.set(Rec::GeneratorSpeed, 10.0F * static_cast<float>(n));
      EXPECT_EQ(h.call(n == 0 ? 0 : 1), 0) << h.message();
    }
    return h.get(Rec::TorqueDemand);
  };
  TestHost first(probe.entry(), input, folder_.file("run.SrvD"));
  fly(first, 0, 4);
  EXPECT_EQ(first.call_with(-8, checkpoint), 0) << first.message();
  const float expected = fly(first, 4, 8);
  first.call(-1);
  TestHost second(probe.entry(), input, folder_.file("run.SrvD"));
  EXPECT_EQ(second.call_with(-9, checkpoint), 0) << second.message();
  EXPECT_EQ(fly(second, 4, 8), expected);
  second.call(-1);
  TraceReader trace(folder_.file("run.restart.lactrace"));
  TraceCall call;
  ASSERT_TRUE(trace.next(call));
  EXPECT_EQ(call.sent[0], -9.0F);
  EXPECT_EQ(call.in_file, checkpoint);
}

// What can be wrong with its input, in words.
TEST_F(HostProbeTest, Failures) {
  const auto text_of = [&](const std::string& input) {
    const auto c = caller("liblac_host_probe", input, "run.SrvD");
    EXPECT_EQ(c->call(0), -1);
    EXPECT_EQ(c->call(-1), 0);
    return c->message();
  };
  EXPECT_THAT(text_of(folder_.file("none.IN")),
              HasSubstr("host_probe: " + folder_.file("none.IN")));
  EXPECT_THAT(text_of(probe_input("libtoy_script", "none.IN")),
              HasSubstr("ControllerInput: " + folder_.file("none.IN") + " cannot be opened"));
  folder_.write("toy.IN", "");
  EXPECT_THAT(text_of(probe_input("libnothing", "toy.IN")), HasSubstr("libnothing' not found"));
}

}  // namespace
}  // namespace lac::test
