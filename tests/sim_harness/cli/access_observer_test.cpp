// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/access_observer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <numeric>
#include <stdexcept>

namespace lac::sim {
namespace {

using ::testing::ElementsAre;

constexpr int kSize = 3712;

std::vector<int> numbers(const std::vector<bool>& touched) {
  std::vector<int> all;
  for (std::size_t i = 0; i < touched.size(); ++i) {
    if (touched[i]) all.push_back(static_cast<int>(i));
  }
  return all;
}

ObservedArray::Accesses nothing() {
  return {std::vector<bool>(kSize + 1), std::vector<bool>(kSize + 1)};
}

// Single floats, from both ends and the middle: exactly these, and the work is done.
TEST(ObservedArrayTest, SeesSingleRecords) {
  if (!ObservedArray::available()) GTEST_SKIP() << "reads cannot be observed on this system";
  ObservedArray array(kSize);
  array.data()[0] = 2.0F;
  auto accesses = nothing();
  double sum = 1.0;
  {
    const ObservedArray::Watch watch(array, accesses);
    volatile float* records = array.data();
    records[kSize - 1] = records[0] + 1.0F;
    records[2000] = 5.0F;
    sum = static_cast<double>(records[1023]) + records[1024];
  }
  EXPECT_EQ(sum, 0.0);
  EXPECT_EQ(array.data()[kSize - 1], 3.0F);
  EXPECT_THAT(numbers(accesses.read), ElementsAre(1, 1024, 1025));
  EXPECT_THAT(numbers(accesses.written), ElementsAre(2001, kSize));
}

// Instructions that take several floats at once count for all of them.
TEST(ObservedArrayTest, SeesWideAccesses) {
  if (!ObservedArray::available()) GTEST_SKIP() << "reads cannot be observed on this system";
  using Four = float __attribute__((vector_size(16), aligned(4)));
  using Two = float __attribute__((vector_size(8), aligned(4)));
  ObservedArray array(kSize);
  auto accesses = nothing();
  Four values{};
  {
    const ObservedArray::Watch watch(array, accesses);
    const volatile auto* four = reinterpret_cast<const Four*>(array.data() + 10);
    values = *four;
    auto* two = reinterpret_cast<volatile Two*>(array.data() + 20);
    *two = Two{1.0F, 2.0F};
  }
  EXPECT_EQ(values[3], 0.0F);
  EXPECT_EQ(array.data()[21], 2.0F);
  EXPECT_THAT(numbers(accesses.read), ElementsAre(11, 12, 13, 14));
  EXPECT_THAT(numbers(accesses.written), ElementsAre(21, 22));
}

// Not watched: nothing is noted, several watches add up.
TEST(ObservedArrayTest, WatchesAddUp) {
  ObservedArray array(kSize);
  auto accesses = nothing();
  for (const int record : {5, 7}) {
    {
      const ObservedArray::Watch watch(array, accesses);
      static_cast<volatile float*>(array.data())[record - 1] = 1.0F;
    }
    array.data()[100] += 1.0F;
  }
  EXPECT_THAT(numbers(accesses.written), ElementsAre(5, 7));
}

// A copy by the C library, in whatever vector width this machine has: all of it and nothing else.
TEST(ObservedArrayTest, SeesWholeCopies) {
  if (!ObservedArray::available()) GTEST_SKIP() << "reads cannot be observed on this system";
  constexpr std::size_t kRecords = 164;
  ObservedArray array(kSize);
  auto accesses = nothing();
  std::vector<float> copy(kRecords);
  volatile std::size_t bytes = kRecords * sizeof(float);  // no copy made of single moves
  {
    const ObservedArray::Watch watch(array, accesses);
    std::memcpy(copy.data(), array.data() + 100, bytes);
    std::memcpy(array.data() + 1000, copy.data(), bytes);
  }
  std::vector<int> read(kRecords), written(kRecords);
  std::iota(read.begin(), read.end(), 101);
  std::iota(written.begin(), written.end(), 1001);
  EXPECT_EQ(numbers(accesses.read), read);
  EXPECT_EQ(numbers(accesses.written), written);
}

#if defined(__linux__) && defined(__x86_64__)
// An exception out of a watched scope: the array is free, the signal handlers are those of before.
TEST(ObservedArrayTest, ExceptionEndsTheWatch) {
  struct sigaction before[2], after[2];
  sigaction(SIGSEGV, nullptr, &before[0]);
  sigaction(SIGTRAP, nullptr, &before[1]);
  {
    ObservedArray array(kSize);
    auto accesses = nothing();
    try {
      const ObservedArray::Watch watch(array, accesses);
      throw std::runtime_error("a library");
    } catch (const std::runtime_error&) {
    }
    array.data()[7] = 1.0F;
    EXPECT_THAT(numbers(accesses.written), ElementsAre());
  }
  sigaction(SIGSEGV, nullptr, &after[0]);
  sigaction(SIGTRAP, nullptr, &after[1]);
  EXPECT_EQ(after[0].sa_sigaction, before[0].sa_sigaction);
  EXPECT_EQ(after[1].sa_sigaction, before[1].sa_sigaction);
}
#endif

}  // namespace
}  // namespace lac::sim
