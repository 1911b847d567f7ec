// SPDX-License-Identifier: Apache-2.0
// Which records pass between host and secondaries, in which direction.
#include <cmath>
#include <limits>

#include "wrapper/chain_fixture.hpp"
#include "wrapper/host_link.hpp"

namespace lac::test {
namespace {

using testing::HasSubstr;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class Transfer : public ChainTest {
 protected:
  /// A chain of one that computes TorqueDemand = record `from` + 1.234.
  std::string adder(int from, const std::string& keys = "") {
    return write_chain({{"adder", "toy_script", "add 47 " + std::to_string(from) + " 1.234", ""}},
                       keys);
  }
};

// Every host record that is not a demand reaches the secondaries in every call.
TEST_F(Transfer, HostRecordsReachTheSecondaries) {
  for (const int record : {4, 13, 20, 27, 60, 83, 109, 123, 164}) {
    TestHost host = host_for(adder(record));
    host.put(record, 1.5f);
    ASSERT_EQ(host.call(0), 0) << host.message();
    EXPECT_FLOAT_EQ(host.get(Rec::TorqueDemand), 2.734f) << record;
    host.put(record, 2.5f);
    host.call(1);
    EXPECT_FLOAT_EQ(host.get(Rec::TorqueDemand), 3.734f) << record;
    host.call(-1);
  }
}

// Secondaries share the array: what the first writes the second reads, also in the chain block
// and in records the host does not have.
TEST_F(Transfer, SecondariesShareTheArray) {
  for (const char* shared : {"3303", "2999", "3341", "3700", "900"}) {
    const std::string r(shared);
    TestHost host = host_for(write_chain({{"a", "toy_script", "add " + r + " 20 1", ""},
                                          {"b", "toy_script", "add 47 " + r + " 1", ""}}));
    ASSERT_EQ(host.call(0), 0) << host.message();
    EXPECT_FLOAT_EQ(host.get(Rec::TorqueDemand), 124.9f) << r;
    host.call(-1);
  }
}

// A signal keeps its value from call to call.
TEST_F(Transfer, SignalsKeepTheirValues) {
  TestHost host = host_for(write_chain({{"a", "toy_script", "count 3400\nadd 47 3400 0", ""}},
                                       "steps 3400 ! Signal_1 -\n"));
  for (int call = 0; call < 5; ++call) {
    ASSERT_EQ(host.call(call == 0 ? 0 : 1), 0) << host.message();
    EXPECT_EQ(host.get(Rec::TorqueDemand), static_cast<float>(call + 1));
  }
}

// Only demand records come back: everything else in the host's array stays as it was, whatever
// the secondaries write.
TEST_F(Transfer, OnlyDemandsComeBack) {
  std::string script;
  for (int r = 2; r <= kPrivateArraySize; ++r) script += "set " + std::to_string(r) + " 0.5\n";
  TestHost host = host_for(write_chain({{"greedy", "toy_script", script, ""}}));
  for (int r = 130; r <= kExtendedArraySize; ++r) host.put(r, static_cast<float>(r));
  const std::vector<float> before = host.array;
  ASSERT_EQ(host.call(0), 0) << host.message();
  for (int r = 1; r <= kExtendedArraySize; ++r) {
    const bool demand = std::ranges::find(kDemandRecords, r) != kDemandRecords.end();
    const bool by_host = r <= 2 || r == 49 || r == 50 || r == 51 || r == 65;
    if (by_host) continue;
    EXPECT_EQ(host.at(r), demand ? 0.5f : before[static_cast<std::size_t>(r) - 1]) << r;
  }
}

// The demands are those of the contract (swap-array rules), logging count apart.
TEST_F(Transfer, DemandRecordsAreTheContracts) {
  EXPECT_THAT(kDemandRecords,
              testing::ElementsAre(35, 36, 41, 42, 43, 44, 45, 46, 47, 48, 55, 56, 72, 79, 80, 81,
                                   98, 102, 103, 104, 107, 108, 120, 121, 122));
}

// Cable and structural demands only if the key asks for them.
TEST_F(Transfer, ExtendedDemandsOnRequest) {
  const Row row{"a", "toy_script", "set 2601 3.5\nset 3000 4.5\nset 2600 1\nset 3001 1", ""};
  TestHost host = host_for(write_chain({row}, "true ! ExtendedDemands -\n"));
  ASSERT_EQ(host.call(0), 0) << host.message();
  EXPECT_EQ(host.at(2601), 3.5f);
  EXPECT_EQ(host.at(3000), 4.5f);
  EXPECT_EQ(host.at(2600), 0.0f);
  EXPECT_EQ(host.at(3001), 0.0f);
  TestHost small = host_for(folder.file("chain.IN"), 164);
  EXPECT_EQ(small.call(0), -1);
  EXPECT_THAT(small.message(), HasSubstr("ExtendedDemands needs records 2601-3000"));
}

// An array of 164 floats on the heap, to the last byte: a sanitizer sees any touch behind it.
TEST_F(Transfer, ShortArrayIsEnough) {
  TestHost host = host_for(adder(164), 164);
  host.put(164, 2.0f);
  ASSERT_EQ(host.call(0), 0) << host.message();
  host.call(1);
  EXPECT_FLOAT_EQ(host.get(Rec::TorqueDemand), 3.234f);
  host.call(-1);
}

// Without the signature record 129 is a free variable and says nothing about the length.
TEST_F(Transfer, Record129AloneIsNotBelieved) {
  TestHost host = host_for(adder(1001), 164);
  host.set(Rec::ArraySize, 3300.0f);
  ASSERT_EQ(host.call(0), 0) << host.message();
  EXPECT_FLOAT_EQ(host.get(Rec::TorqueDemand), 1.234f);
  host.call(-1);
}

// A host that brings a fresh array, at another address, to every call (500 floats, no signature).
TEST_F(Transfer, MovingArray) {
  TestHost host = host_for(write_chain({{"a", "toy_script", "count 47", ""}}), 500);
  host.set(Rec::ExtendedStart, 0.0f);
  host.set(Rec::ArraySize, 0.0f);
  std::vector<std::vector<float>> all_arrays;  // kept, so that no address comes twice
  for (int call = 0; call < 20; ++call) {
    std::vector<float> fresh = host.array;
    for (const int r : kDemandRecords) fresh[static_cast<std::size_t>(r) - 1] = 0.0f;
    std::swap(host.array, fresh);
    all_arrays.push_back(std::move(fresh));
    ASSERT_EQ(host.call(call == 0 ? 0 : 1), 0) << host.message();
    EXPECT_EQ(host.get(Rec::TorqueDemand), static_cast<float>(call + 1));
  }
  EXPECT_EQ(host.call(-1), 0);
}

// Native lidar block: header and gates in use, only while the flag is up; the flag itself always.
TEST_F(Transfer, NativeLidarFollowsTheFlag) {
  const int base = kNativeLidarBlock.first;
  const int speed = base + native_lidar::gate_offset(1) + native_lidar::kGateSpeed;
  const std::string script = "add 47 " + std::to_string(speed) + " 0\nadd 48 " +
                             std::to_string(base + native_lidar::kNewData) + " 0\nadd 46 " +
                             std::to_string(speed + native_lidar::kGateSize) + " 0\n";
  TestHost host =
      host_for(write_chain({{"a", "toy_script", script, ""}}, "native ! LidarLayout -\n"));
  host.put(base, native_lidar::kLayoutVersion);
  host.put(base + native_lidar::kNewData, 1.0f);
  host.put(base + native_lidar::kNumberOfGates, 2.0f);
  host.put(speed, 11.0f);
  host.put(speed + native_lidar::kGateSize, 77.0f);  // a third gate, not counted
  ASSERT_EQ(host.call(0), 0) << host.message();
  EXPECT_EQ(host.get(Rec::TorqueDemand), 11.0f);
  EXPECT_EQ(host.get(Rec::YawRateDemand), 1.0f);
  EXPECT_EQ(host.get(Rec::PitchRateDemand), 0.0f);
  host.put(base + native_lidar::kNewData, 0.0f);
  host.put(speed, 12.0f);
  host.call(1);
  EXPECT_EQ(host.get(Rec::TorqueDemand), 11.0f);
  EXPECT_EQ(host.get(Rec::YawRateDemand), 0.0f);
  // Not a number in the lidar block is the business of who reads it.
  host.put(base + native_lidar::kNewData, 1.0f);
  host.put(base + native_lidar::kPosition, kNan);
  host.put(speed, 13.0f);
  EXPECT_EQ(host.call(1), 0) << host.message();
  EXPECT_EQ(host.get(Rec::TorqueDemand), 13.0f);
}

TEST_F(Transfer, NativeLidarNeedsTheLongArray) {
  TestHost host = host_for(adder(20, "native ! LidarLayout -\n"), 164);
  EXPECT_EQ(host.call(0), -1);
  EXPECT_THAT(host.message(),
              HasSubstr("LidarLayout native needs records 1101-1320 (native lidar), but only 164"));
}

// Guo's block keeps its place and record 63 points at it; logging is off then. Array of 464
// floats without a signature, as that simulator passes.
TEST_F(Transfer, GuoLidarBlock) {
  const std::string script = "add 47 168 0\nadd 48 63 0\nadd 46 174 0\nadd 45 62 0\nset 175 9\n";
  TestHost host =
      host_for(write_chain({{"a", "toy_script", script, ""}}, "guo ! LidarLayout -\n"), 464);
  host.set(Rec::ExtendedStart, 0.0f);
  host.set(Rec::ArraySize, 0.0f);
  host.set(Rec::LogStart, 165.0f);
  host.put(167, 1.0f);   // one gate
  host.put(168, 15.5f);  // its speed
  host.put(174, 0.3f);   // last velocity component
  ASSERT_EQ(host.call(0), 0) << host.message();
  EXPECT_EQ(host.get(Rec::TorqueDemand), 15.5f);
  EXPECT_EQ(host.get(Rec::YawRateDemand), 165.0f);
  EXPECT_EQ(host.get(Rec::PitchRateDemand), 0.3f);
  EXPECT_EQ(host.get(Rec::PitchDemandCollective), 0.0f);
  EXPECT_EQ(host.at(175), 0.0f);  // results of the chain stay inside
}

// OpenFAST's block comes whole in every call; its values are the business of who reads it.
TEST_F(Transfer, OpenFastLidarBlock) {
  const int first = kOpenFastLidarBlock.first;
  const int last = first + openfast_lidar::kSize - 1;
  const std::string script = "add 47 " + std::to_string(first + openfast_lidar::kFirstSpeed) +
                             " 0\nadd 48 " + std::to_string(last) + " 0\nadd 46 " +
                             std::to_string(last + 1) + " 0\n";
  TestHost host =
      host_for(write_chain({{"a", "toy_script", script, ""}}, "OpenFAST ! LidarLayout -\n"));
  host.put(last + 1, 77.0f);  // behind the block
  for (const float speed : {11.0f, 12.0f}) {
    host.put(first + openfast_lidar::kFirstSpeed, speed);
    host.put(last, 2.0f * speed);
    host.put(first + openfast_lidar::kFirstSpeed + 1, kNan);
    ASSERT_EQ(host.call(speed == 11.0f ? 0 : 1), 0) << host.message();
    EXPECT_EQ(host.get(Rec::TorqueDemand), speed);
    EXPECT_EQ(host.get(Rec::YawRateDemand), 2.0f * speed);
    EXPECT_EQ(host.get(Rec::PitchRateDemand), 0.0f);
  }
}

// A host without the block is refused with those that have one.
TEST_F(Transfer, OpenFastLidarNeedsTheLongArray) {
  TestHost host = host_for(adder(20, "openfast ! LidarLayout -\n"), 500);
  host.set(Rec::ExtendedStart, 0.0f);
  host.set(Rec::ArraySize, 0.0f);
  EXPECT_EQ(host.call(0), -1);
  EXPECT_THAT(host.message(), HasSubstr("LidarLayout openfast needs records 2001-2024 (OpenFAST "
                                        "lidar), but only 164 records of the host's array"));
  EXPECT_THAT(host.message(), HasSubstr("ROSCO's Python class with its 500 floats, cannot"));
}

// Record 63 that points nowhere: no block, nothing read.
TEST_F(Transfer, GuoLidarBlockOutOfReach) {
  TestHost host = host_for(adder(63, "guo ! LidarLayout -\n"), 464);
  host.set(Rec::ExtendedStart, 0.0f);
  host.set(Rec::ArraySize, 0.0f);
  for (const float start : {0.0f, 12.0f, 3299.0f, 1.0e9f, kNan}) {
    host.set(Rec::LogStart, start);
    ASSERT_EQ(host.call(0), 0) << host.message();
    EXPECT_FLOAT_EQ(host.get(Rec::TorqueDemand), 1.234f);
    host.call(-1);
  }
  TestHost sized = host_for(folder.file("chain.IN"), 400);  // a block that ends behind the array
  sized.set(Rec::LogStart, 385.0f);
  sized.put(387, 10.0f);
  ASSERT_EQ(sized.call(0), 0) << sized.message();
  EXPECT_FLOAT_EQ(sized.get(Rec::TorqueDemand), 1.234f);
}

// Each measured record that is not finite: demands hold, the secondaries see its last good value
// and the flag, one message at the start and one at recovery, then all goes on.
TEST_F(Transfer, NonFiniteMeasurementHoldsTheDemands) {
  for (const int record : kMeasuredRecords) {
    if (record <= 3) continue;  // time is set by the test host
    const Row row{"a", "toy_script", "count 47\nadd 1500 " + std::to_string(record) + " 0\n", ""};
    TestHost host = host_for(write_chain({row}));
    host.put(record, 500.0f);
    ASSERT_EQ(host.call(0), 0) << host.message();
    for (const float bad : {kNan, std::numeric_limits<float>::infinity()}) {
      const float held = host.get(Rec::TorqueDemand);
      host.put(record, bad);
      EXPECT_EQ(host.call(1), 1) << record;
      EXPECT_THAT(host.message(), HasSubstr("record " + std::to_string(record) + " ("));
      EXPECT_EQ(host.call(1), 0) << host.message();
      EXPECT_EQ(host.get(Rec::TorqueDemand), held);
      host.put(record, 1.0f);
      EXPECT_EQ(host.call(1), 1);
      EXPECT_THAT(host.message(), HasSubstr("finite again"));
      EXPECT_EQ(host.get(Rec::TorqueDemand), held + 1.0f);
      EXPECT_EQ(host.call(1), 0);
    }
    host.call(-1);
  }
}

// The secondaries see the last good value and ChainInputsGood 0 in the meantime.
TEST_F(Transfer, SecondariesSeeTheLastGoodValue) {
  const Row row{"a", "toy_script",
                "add 3330 20 0\nadd 3329 3302 0\nwarn_at 3330 100 101 value 100 seen\n"
                "warn_at 3329 0 0 flag down\n",
                ""};
  TestHost host = host_for(write_chain({row}));
  host.set(Rec::GeneratorSpeed, 90.0f);
  host.call(0);
  host.set(Rec::GeneratorSpeed, 100.5f);
  EXPECT_EQ(host.call(1), 1);
  EXPECT_THAT(host.message(), HasSubstr("value 100 seen"));
  host.set(Rec::GeneratorSpeed, kNan);
  EXPECT_EQ(host.call(1), 1);
  EXPECT_THAT(host.message(), HasSubstr("flag down"));
  EXPECT_THAT(host.message(), HasSubstr("GeneratorSpeed"));
}

TEST_F(Transfer, NonFiniteMeasurementAtTheFirstCall) {
  TestHost host = host_for(adder(20));
  host.set(Rec::RotorSpeed, kNan);
  EXPECT_EQ(host.call(0), -1);
  EXPECT_THAT(host.message(), HasSubstr("record 21 (RotorSpeed) is not finite at the first call"));
}

// Every demand record: a secondary that makes it not finite fails by name, the demands hold.
TEST_F(Transfer, NonFiniteDemandIsAFailure) {
  for (const int record : kDemandRecords) {
    const Row bad{"bad", "toy_script",
                  "set " + std::to_string(record) + " 1\nnan " + std::to_string(record) + " 1", ""};
    TestHost host = host_for(write_chain({{"good", "toy_script", "", ""}, bad}));
    ASSERT_EQ(host.call(0), 0) << host.message();
    const float held = host.at(record);
    EXPECT_EQ(host.call(1), -1);
    EXPECT_EQ(host.at(record), held);
    EXPECT_THAT(host.message(),
                HasSubstr("bad (libtoy_script" LAC_LIBRARY_SUFFIX "): demand in record " +
                          std::to_string(record)));
    host.call(-1);
  }
}

// A host array that was never filled is no reason to blame a secondary.
TEST_F(Transfer, RubbishInDemandRecordsBeforeTheFirstCall) {
  TestHost host = host_for(adder(20));
  for (const int record : kDemandRecords) host.put(record, kNan);
  EXPECT_EQ(host.call(0), 0) << host.message();
  EXPECT_EQ(host.get(Rec::YawRateDemand), 0.0f);
}

}  // namespace
}  // namespace lac::test
