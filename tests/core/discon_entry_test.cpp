// SPDX-License-Identifier: Apache-2.0
// The life-cycle around a controller class, with a controller that notes what it is asked.
#include "core/discon_entry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/discon_module.hpp"
#include "core/error.hpp"
#include "support/temp_folder.hpp"
#include "support/test_host.hpp"

namespace lac {
namespace {

int alive = 0;
int most_alive = 0;
std::vector<std::string> asked;
StartInfo started_with;

class Noting final : public DisconModule {
 public:
  Noting() { most_alive = std::max(most_alive, ++alive); }
  ~Noting() override { --alive; }
  void step(SwapView swap, double time_s, Notice& notice) noexcept override {
    asked.push_back("step " + std::to_string(time_s));
    sum_ += swap.get(Rec::GeneratorSpeed);
    swap.set(Rec::TorqueDemand, sum_);
    if (swap.get(Rec::RotorSpeed) < 0.0) notice.fail("backwards");
  }
  void finish(SwapView, Notice& notice) override {
    asked.push_back("finish");
    notice.warn("goodbye");
  }
  void visit_state(StateArchive& a) override { a(sum_); }
  void checkpoint(const std::filesystem::path& file, SwapView, Notice&) override {
    asked.push_back("checkpoint " + file.filename().string());
  }
  void restart(const std::filesystem::path& file, SwapView, Notice&) override {
    asked.push_back("restart " + file.filename().string() + " at " + std::to_string(sum_));
  }
  void store_or_restore(int status, SwapView, Notice&) override {
    asked.push_back("substep " + std::to_string(status));
  }

 private:
  double sum_ = 0.0;
};

}  // namespace

const char* module_name() {
  return "noting";
}
std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView, Notice&) {
  started_with = start;
  if (start.input_file == "throws.IN") throw Error("throws.IN:3: Key: found 'x', expected y");
  if (start.input_file == "odd.IN") throw 42;
  return std::make_unique<Noting>();
}

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Entry : public testing::Test {
 protected:
  void SetUp() override {
    asked.clear();
    alive = 0;
  }
  static test::TestHost host(const std::string& in = "a.IN", int size = kExtendedArraySize) {
    return test::TestHost([](float* swap, int* fail, const char* file, char* out,
                             char* message) { discon_entry(swap, fail, file, out, message); },
                          in, "case.SrvD", size);
  }
};

// Time is counted in steps of record 3, read once and taken as the decimal that the user wrote.
TEST_F(Entry, WholeLife) {
  test::TestHost h = host();
  ASSERT_EQ(h.call(0), 0) << h.message();
  EXPECT_EQ(started_with.input_file, "a.IN");
  EXPECT_EQ(started_with.out_name, "case.SrvD");
  EXPECT_EQ(started_with.time_step_s, 0.0125);
  EXPECT_FALSE(started_with.is_restart());
  h.set(Rec::TimeStep, 99.0f);
  h.call(1);
  h.call(1);
  EXPECT_EQ(h.call(-1), 1);
  EXPECT_EQ(h.message(), "noting: goodbye");
  EXPECT_THAT(asked, ElementsAre("step 0.000000", "step 0.012500", "step 0.025000", "finish"));
  EXPECT_EQ(alive, 0);
}

// Unknown statuses: not a record, not a step, aviFAIL 0, message untouched.
TEST_F(Entry, UnknownStatusesDoNothing) {
  test::TestHost h = host();
  h.call(0);
  for (const int status : {2, 3, -2, -7, -12, 1000000}) {
    const auto before = h.array;
    EXPECT_EQ(h.call(status), 0);
    EXPECT_TRUE(std::equal(before.begin() + 51, before.end(), h.array.begin() + 51));
  }
  EXPECT_THAT(asked, ElementsAre("step 0.000000"));
}

// A status that is no whole number is an unknown one: not the nearest.
TEST_F(Entry, FractionsAreNoStatus) {
  test::TestHost h = host();
  h.call(0);
  for (const float status : {0.4f, 0.5f, 1.2f, -0.7f, NAN, INFINITY}) {
    h.set(Rec::Status, status);
    int fail = 77;
    discon_entry(h.array.data(), &fail, "a.IN", "case.SrvD", nullptr);
    EXPECT_EQ(fail, 0) << status;
  }
  EXPECT_THAT(asked, ElementsAre("step 0.000000"));
}

// Records 3, 50 and 51 must make sense at the first call; none is taken for something else.
TEST_F(Entry, NonsenseInTheFirstCall) {
  const auto refusal = [](Rec record, float value) {
    test::TestHost h = host();
    h.set(Rec::Status, 0.0f);
    h.set(Rec::MessageCapacity, 200.0f);
    h.set(Rec::InFileLength, 4.0f);
    h.set(Rec::OutNameLength, 9.0f);
    h.set(record, value);
    int fail = 0;
    char message[200] = "";
    discon_entry(h.array.data(), &fail, "a.IN", "case.SrvD", message);
    EXPECT_EQ(fail, -1);
    return std::string(message);
  };
  for (const float step : {0.0f, -0.0125f, 1e-30f, 2e3f, NAN, INFINITY}) {
    EXPECT_THAT(refusal(Rec::TimeStep, step), HasSubstr("expected 1e-05 to 1000 s"));
  }
  for (const float length : {-1.0f, 65537.0f, NAN, INFINITY}) {
    EXPECT_THAT(refusal(Rec::InFileLength, length),
                HasSubstr("record 50 (characters in accINFILE) is "));
    EXPECT_THAT(refusal(Rec::OutNameLength, length), HasSubstr("expected 0 to 65536"));
  }
  EXPECT_TRUE(asked.empty());
}

// A run that was never ended is gone before the next one of that turbine is built.
TEST_F(Entry, SecondFirstCallEndsTheRunBefore) {
  test::TestHost h = host();
  h.call(0);
  h.call(1);
  most_alive = 0;
  EXPECT_EQ(h.call(0), 0) << h.message();
  EXPECT_EQ(most_alive, 1);
  EXPECT_EQ(alive, 1);
}

// Errors of any kind end here, with the name of the module in front.
TEST_F(Entry, ExceptionsBecomeMessages) {
  auto known = host("throws.IN");
  EXPECT_EQ(known.call(0), -1);
  EXPECT_EQ(known.message(), "noting: throws.IN:3: Key: found 'x', expected y");
  auto odd = host("odd.IN");
  EXPECT_EQ(odd.call(0), -1);
  EXPECT_EQ(odd.message(), "noting: unknown error");
  EXPECT_EQ(odd.call(1), -1);
  EXPECT_THAT(odd.message(), HasSubstr("never made a first call (status 0), or whose first call"));
  EXPECT_EQ(odd.call(-1), 0);
}

// A first step that fails leaves no instance behind.
TEST_F(Entry, FailedFirstStep) {
  test::TestHost h = host();
  h.set(Rec::RotorSpeed, -1.0f);
  EXPECT_EQ(h.call(0), -1);
  EXPECT_EQ(h.message(), "noting: backwards");
  EXPECT_EQ(alive, 0);
  EXPECT_EQ(h.call(-1), 0);
}

// A failed later step keeps the instance: the host still makes its last call.
TEST_F(Entry, FailedLaterStep) {
  test::TestHost h = host();
  h.call(0);
  h.set(Rec::RotorSpeed, -1.0f);
  EXPECT_EQ(h.call(1), -1);
  EXPECT_EQ(alive, 1);
  EXPECT_EQ(h.call(-1), 1);
  EXPECT_EQ(alive, 0);
}

// Message buffers of any size, also none.
TEST_F(Entry, SmallMessageBuffers) {
  for (const std::size_t capacity : {0U, 1U, 2U, 8U}) {
    test::TestHost h = host("throws.IN");
    h.message_capacity = capacity;
    EXPECT_EQ(h.call(0), -1);
    EXPECT_TRUE(h.message_was_terminated());
    EXPECT_EQ(h.message(), std::string("noting:").substr(0, capacity > 0 ? capacity - 1 : 0));
  }
}

TEST_F(Entry, NullPointers) {
  int fail = 0;
  discon_entry(nullptr, &fail, "", nullptr, nullptr);
  EXPECT_EQ(fail, -1);
  std::vector<float> array(164);
  array[2] = 0.1f;
  discon_entry(array.data(), nullptr, nullptr, nullptr, nullptr);
  array[49] = 10.0f;
  discon_entry(array.data(), &fail, nullptr, nullptr, nullptr);
  EXPECT_EQ(fail, -1);
}

// Store and restore: state and time go back, the module is told after its state was handled.
TEST_F(Entry, StoreAndRestore) {
  test::TestHost h = host();
  h.call(0);
  EXPECT_EQ(h.call(-10), -1);
  EXPECT_THAT(h.message(), HasSubstr("-10 (restore) came before any -11"));
  h.call(-11);
  h.call(1);
  const float once = h.get(Rec::TorqueDemand);
  h.call(1);
  h.call(-10);
  h.call(1);
  EXPECT_EQ(h.get(Rec::TorqueDemand), once);
  EXPECT_THAT(asked, ElementsAre("step 0.000000", "substep -11", "step 0.012500", "step 0.025000",
                                 "substep -10", "step 0.012500"));
}

// Checkpoint and restart: a new instance built from the original input file, steps counted on.
TEST_F(Entry, CheckpointAndRestart) {
  const test::TempFolder folder;
  {
    test::TestHost h = host();
    h.call(0);
    h.call(1);
    ASSERT_EQ(h.call_with(-8, folder.file("c.chkp")), 0) << h.message();
  }
  test::TestHost h = host();
  ASSERT_EQ(h.call_with(-9, folder.file("c.chkp")), 0) << h.message();
  EXPECT_EQ(asked.back(), "restart c.chkp at 245.800003");  // after its state had come back
  EXPECT_EQ(started_with.input_file, "a.IN");
  EXPECT_EQ(started_with.steps, 1);
  EXPECT_EQ(started_with.checkpoint, folder.file("c.chkp"));
  h.call(1);
  EXPECT_FLOAT_EQ(h.get(Rec::TorqueDemand), 3.0f * 122.9f);
  EXPECT_EQ(asked.back(), "step 0.025000");
}

// Under the master the library answers that it knows the chain block; elsewhere it writes nothing.
TEST_F(Entry, AnswersTheMaster) {
  auto chain = host("a.IN", kPrivateArraySize);
  chain.set(Rec::ChainVersion, kChainLayoutVersion);
  chain.call(0);
  EXPECT_EQ(chain.get(Rec::ChainMember), 1.0f);
  auto other = host("b.IN", kPrivateArraySize);
  other.call(0);
  EXPECT_EQ(other.get(Rec::ChainMember), 0.0f);
}

}  // namespace
}  // namespace lac
