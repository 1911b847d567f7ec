// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/host/controller_host.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <sstream>

#include "core/error.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// One line of what the probe saw.
struct SeenCall {
  double status = 0.0, time_s = 0.0;
  int fail_on_entry = 0, in_file = 0, out_name = 0, message = 0, rubbish = 0;
  std::map<int, double> records;
};

class ControllerHostTest : public ::testing::Test {
 protected:
  HostSetup setup(const std::string& probe_input) {
    HostSetup s;
    s.library = LAC_TOY_DIR "/libtoy_recorder";
    s.input_file = folder_.write("PROBE.IN", probe_input);
    s.output_root = folder_.file("run");
    s.initial_pitch_rad = 0.25;
    s.generator_efficiency = 0.9;
    return s;
  }

  std::unique_ptr<ControllerHost> host(const std::string& probe_input) {
    return std::make_unique<ControllerHost>(
        setup(probe_input), [this](double time_s, const std::string& text) {
          warnings_.push_back(std::to_string(time_s) + " " + text);
        });
  }

  std::vector<SeenCall> seen() const {
    std::istringstream in(folder_.read("run.SrvD.seen"));
    std::vector<SeenCall> calls;
    std::string line;
    while (std::getline(in, line)) {
      std::istringstream words(line);
      SeenCall c;
      words >> c.status >> c.time_s >> c.fail_on_entry >> c.in_file >> c.out_name >> c.message >>
          c.rubbish;
      int record = 0;
      char equals = 0;
      std::string value;
      while (words >> record >> equals >> value) c.records[record] = std::stod(value);
      calls.push_back(c);
    }
    return calls;
  }

  test::TempFolder folder_;
  std::vector<std::string> warnings_;
};

// Status 0 once, 1 in every step, -1 once with time and inputs of the last step.
TEST_F(ControllerHostTest, StatusesAndTimes) {
  const auto h = host("pitch_rad 0.1\n");
  for (int i = 0; i < 4; ++i) h->call({});
  h->finish();
  h->finish();
  std::vector<double> statuses, times_s;
  for (const SeenCall& c : seen()) {
    statuses.push_back(c.status);
    times_s.push_back(c.time_s);
  }
  EXPECT_THAT(statuses, ElementsAre(0, 1, 1, 1, -1));
  EXPECT_THAT(times_s, ElementsAre(0, 0.0125, 0.025, 0.0375, 0.0375));
}

// Sizes as OpenFAST v5 gives them: lengths of strings count the terminator.
TEST_F(ControllerHostTest, SizesAndStrings) {
  const auto h = host("");
  h->call({});
  h->call({});
  h->finish();
  const std::size_t in_file = folder_.file("PROBE.IN").size();
  const std::size_t out_name = folder_.file("run.SrvD").size();
  for (const SeenCall& c : seen()) {
    EXPECT_EQ(c.fail_on_entry, 0);
    EXPECT_EQ(c.message, 0);
    EXPECT_EQ(c.rubbish, 1);
    EXPECT_EQ(c.in_file, static_cast<int>(in_file));
    EXPECT_EQ(c.out_name, static_cast<int>(out_name));
    EXPECT_EQ(c.records.at(50), static_cast<double>(in_file) + 1);
    EXPECT_EQ(c.records.at(51), static_cast<double>(out_name) + 1);
    EXPECT_EQ(c.records.at(3), 0.0125);
    EXPECT_EQ(c.records.at(49), 8197);
    EXPECT_EQ(c.records.at(61), 3);
    EXPECT_EQ(c.records.at(62), 300);
    EXPECT_EQ(c.records.at(63), 165);
    EXPECT_EQ(c.records.at(64), 12601);
    EXPECT_EQ(c.records.at(66), 1001);
    EXPECT_EQ(c.records.at(129), 3300);
    EXPECT_EQ(c.records.at(1000), 1.0);
    EXPECT_EQ(c.records.at(1101), 0.0);  // no lidar on board
    EXPECT_EQ(c.records.at(3300), 0.0);
  }
}

// Measured torque, power and pitch demand belong to the call before; 0 (and the initial pitch)
// in the first.
TEST_F(ControllerHostTest, DemandsComeBackOneCallLater) {
  const auto h = host("pitch_rad 0.125\ntorque_Nm 20000\n");
  HostInputs in;
  in.pitch_rad = 0.5;
  in.generator_speed_radps = 100.0;
  const HostDemands d = h->call(in);
  EXPECT_EQ(d.pitch_rad, 0.125);
  EXPECT_EQ(d.torque_Nm, 20000.0);
  in.generator_speed_radps = 110.0;
  h->call(in);
  h->finish();
  const auto calls = seen();
  EXPECT_EQ(calls[0].records.at(11), 0.25);
  EXPECT_EQ(calls[0].records.at(23), 0.0);
  EXPECT_EQ(calls[0].records.at(15), 0.0);
  EXPECT_EQ(calls[0].records.at(45), 0.0);
  EXPECT_EQ(calls[1].records.at(4), 0.5);
  EXPECT_EQ(calls[1].records.at(11), 0.125);
  EXPECT_EQ(calls[1].records.at(20), 110.0);
  EXPECT_EQ(calls[1].records.at(23), 20000.0);
  EXPECT_NEAR(calls[1].records.at(15), 0.9 * 20000.0 * 100.0, 10.0);  // six digits in the log
}

// What a library keeps in free records survives from call to call.
TEST_F(ControllerHostTest, PrivateRecordsSurvive) {
  const auto h = host("");
  for (int i = 0; i < 3; ++i) h->call({});
  h->finish();
  const auto calls = seen();
  for (std::size_t i = 0; i < calls.size(); ++i) {
    EXPECT_EQ(calls[i].records.at(150), static_cast<double>(i));
  }
}

// The lidar flag is up in the one call that was told of a new measurement.
TEST_F(ControllerHostTest, LidarFlagInOneCall) {
  const auto h = host("");
  LidarMeasurement m;
  for (const bool is_new : {false, true, false}) {
    h->set_lidar(m, is_new);
    h->call({});
  }
  h->finish();
  const auto calls = seen();
  EXPECT_EQ(calls[0].records.at(1101), 1.0);
  EXPECT_EQ(calls[0].records.at(1102), 0.0);
  EXPECT_EQ(calls[1].records.at(1102), 1.0);
  EXPECT_EQ(calls[2].records.at(1102), 0.0);
}

// A warning is handed on with its time and the run goes on.
TEST_F(ControllerHostTest, WarningGoesOn) {
  const auto h = host("warn_at 1\n");
  for (int i = 0; i < 3; ++i) h->call({});
  EXPECT_THAT(warnings_, ElementsAre("0.012500 probe: a warning"));
}

std::string error_of(const std::function<void()>& action) {
  return test::error_text([&] { action(); });
}

// A failure ends the run with the library's words; the library is called once more with -1.
TEST_F(ControllerHostTest, FailureEndsTheRun) {
  const auto h = host("fail_at 2\n");
  const std::string text = error_of([&] {
    for (int i = 0; i < 10; ++i) h->call({});
  });
  EXPECT_THAT(text, HasSubstr("ended the run at t = 0.025 s: probe: told to fail"));
  ASSERT_EQ(seen().size(), 4U);
  EXPECT_EQ(seen().back().status, -1.0);
  h->finish();
  EXPECT_EQ(seen().size(), 4U);
}

// A failure in the first call too is followed by -1; one in the last call is told.
TEST_F(ControllerHostTest, FailureInFirstAndLastCall) {
  const auto first = host("fail_at 0\n");
  EXPECT_THAT(error_of([&] { first->call({}); }), HasSubstr("t = 0 s: probe: told to fail"));
  EXPECT_EQ(seen().size(), 2U);
  const auto last = host("fail_at_last 1\n");
  last->call({});
  EXPECT_THAT(error_of([&] { last->finish(); }),
              HasSubstr("failed in the last call: probe: told to fail"));
}

// A run that is given up in the middle still makes the last call.
TEST_F(ControllerHostTest, DestructionMakesTheLastCall) {
  host("")->call({});
  ASSERT_EQ(seen().size(), 2U);
  EXPECT_EQ(seen().back().status, -1.0);
}

// Returned values that OpenFAST refuses, and demands that are no numbers.
TEST_F(ControllerHostTest, RefusesUnusableReturns) {
  const auto problem = [&](const std::string& input) {
    const auto h = host(input);
    return error_of([&] { h->call({}); });
  };
  EXPECT_THAT(problem("put 35 2\n"), HasSubstr("record 35"));
  EXPECT_THAT(problem("put 36 3\n"), HasSubstr("record 36"));
  EXPECT_THAT(problem("put 55 1\n"), HasSubstr("record 55 (pitch override) returned as 1"));
  EXPECT_THAT(problem("put 65 301\n"), HasSubstr("record 65"));
  EXPECT_THAT(problem("put 45 1e39\n"), HasSubstr("record 45"));
  EXPECT_EQ(problem("put 36 16\n"), "no error");
}

// A library that is not there is told with the paths that were tried.
TEST_F(ControllerHostTest, MissingLibrary) {
  HostSetup s = setup("");
  s.library = "liblac_not_there";
  s.library_folders = {folder_.path()};
  EXPECT_THAT(error_of([&] { ControllerHost h(s, [](double, const std::string&) {}); }),
              HasSubstr(folder_.file("liblac_not_there.so")));
}

}  // namespace
}  // namespace lac::sim
