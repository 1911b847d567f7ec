// SPDX-License-Identifier: Apache-2.0
// What every secondary must keep to, tried on the three examples.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "examples/example_library.hpp"
#include "support/temp_folder.hpp"

namespace lac::test {
namespace {

class ExampleContract : public testing::TestWithParam<ExampleLibrary> {
 protected:
  void SetUp() override {
    if (!GetParam().built) GTEST_SKIP() << kNoFortran;
    library = GetParam().open();
  }
  ExampleHost host(const std::string& in_file, int records = kPrivateArraySize) const {
    return ExampleHost(library, in_file, records);
  }

  /// One step of a turbine that sways, speeds up and meets gusts.
  static void step(TestHost& h, int n) {
    const double t = 0.0125 * n;
    h.set(Rec::TowerForeAftAcceleration, static_cast<float>(std::sin(2.0 * t)));
    h.set(Rec::GeneratorSpeed, static_cast<float>(122.9 + 20.0 * std::sin(0.7 * t)));
    h.set(Rec::HubWindSpeed, static_cast<float>(11.0 + 3.0 * std::sin(0.3 * t)));
    for (const Rec demand :
         {Rec::PitchDemand1, Rec::PitchDemand2, Rec::PitchDemand3, Rec::PitchDemandCollective}) {
      h.set(demand, 0.0f);
    }
    EXPECT_GE(h.call(n == 0 ? LAC_STATUS_FIRST : LAC_STATUS_STEP), 0) << h.message();
  }

  DisconLibrary library;
  TempFolder folder;
};

// Lengths with the terminator and without one: same array after each call.
TEST_P(ExampleContract, NamesWithAndWithoutTerminator) {
  std::vector<float> arrays[2];
  for (const bool counted : {true, false}) {
    ExampleHost h = host(GetParam().input_file());
    h.counts_terminator = counted;
    for (int n = 0; n < 20; ++n) step(h, n);
    for (const Rec length : {Rec::InFileLength, Rec::OutNameLength}) h.set(length, 0.0f);
    arrays[counted ? 1 : 0] = h.array;
  }
  EXPECT_EQ(arrays[0], arrays[1]);
}

// A failure: negative, with the name of the file, never longer than the buffer.
TEST_P(ExampleContract, FailureText) {
  ExampleHost h = host(folder.file("none.IN"));
  EXPECT_LT(h.call(LAC_STATUS_FIRST), 0);
  EXPECT_THAT(h.message(), testing::StartsWith(std::string(GetParam().name) + ": "));
  EXPECT_THAT(h.message(), testing::HasSubstr("none.IN cannot be opened"));
  for (const std::size_t capacity : {20U, 1U}) {
    h.message_capacity = capacity;
    EXPECT_LT(h.call(LAC_STATUS_FIRST), 0);
    EXPECT_TRUE(h.message_was_terminated());
    EXPECT_EQ(h.message().size(), capacity - 1);
  }
}

// An empty input file, and a record that the array does not have.
TEST_P(ExampleContract, RefusesBadInput) {
  ExampleHost empty = host(folder.write("empty.IN", ""));
  EXPECT_LT(empty.call(LAC_STATUS_FIRST), 0);
  ExampleHost small = host(GetParam().input_file(), 164);
  EXPECT_LT(small.call(LAC_STATUS_FIRST), 0) << "needs a record behind 164";
}

// Statuses that are not known: nothing is written.
TEST_P(ExampleContract, IgnoresUnknownStatuses) {
  ExampleHost h = host(GetParam().input_file());
  for (int n = 0; n < 5; ++n) step(h, n);
  for (const int status : {-10, -11, -2, 7}) {
    h.call(status);
    std::vector<float> before = h.array;
    EXPECT_EQ(h.call(status), 0);
    EXPECT_EQ(h.array, before) << status;
  }
}

// A run that goes on from a checkpoint gives the same arrays to the last bit, and taking one
// changes nothing.
TEST_P(ExampleContract, ContinuesFromCheckpoint) {
  constexpr int kSaved = 300, kSteps = 600;
  const std::string file = folder.file("run.24.dll.chkp.1.example");
  std::vector<float> expected;
  {
    ExampleHost h = host(GetParam().input_file());
    for (int n = 0; n < kSteps; ++n) {
      step(h, n);
      const std::vector<float> before = h.array;
      if (n != kSaved) continue;
      EXPECT_EQ(h.call_with(LAC_STATUS_CHECKPOINT, file), 0) << h.message();
      EXPECT_TRUE(std::equal(before.begin() + 52, before.end(), h.array.begin() + 52));
    }
    expected = h.array;
    EXPECT_EQ(h.call(LAC_STATUS_LAST), 0);
  }
  library = GetParam().open();
  ExampleHost h = host(GetParam().input_file());
  EXPECT_EQ(h.call_with(LAC_STATUS_RESTART, file), 0) << h.message();
  for (int n = kSaved + 1; n < kSteps; ++n) step(h, n);
  h.set(Rec::Time, expected[1]);  // the test host counts from its own first call
  EXPECT_EQ(h.array, expected);
}

// A file that is no checkpoint is refused, and so is a folder that is not there.
TEST_P(ExampleContract, RefusesOtherCheckpoints) {
  ExampleHost h = host(GetParam().input_file());
  EXPECT_LT(h.call_with(LAC_STATUS_RESTART, folder.file("none")), 0);
  EXPECT_LT(h.call_with(LAC_STATUS_RESTART, folder.write("text", std::string(9000, 'x'))), 0);
  EXPECT_THAT(h.message(), testing::HasSubstr("is not a checkpoint of this library"));
  step(h, 0);
  EXPECT_LT(h.call_with(LAC_STATUS_CHECKPOINT, folder.file("not/there")), 0);
  EXPECT_THAT(h.message(), testing::HasSubstr("cannot be written"));
}

// A second run in the same image begins as the first.
TEST_P(ExampleContract, SecondRunBeginsAnew) {
  std::vector<float> arrays[2];
  for (auto& array : arrays) {
    ExampleHost h = host(GetParam().input_file());
    for (int n = 0; n < 500; ++n) step(h, n);
    array = h.array;
    EXPECT_EQ(h.call(LAC_STATUS_LAST), 0);
  }
  EXPECT_EQ(arrays[0], arrays[1]);
}

INSTANTIATE_TEST_SUITE_P(Examples, ExampleContract,
                         testing::Values(kTowerFilter, kSpeedSupervisor, kMinimumPitch),
                         [](const auto& example) { return example.param.name; });

}  // namespace
}  // namespace lac::test
