// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "support/no_alloc_guard.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Recording three_rows() {
  Recording recording({{"RotSpeed", "rpm"}, {"Pitch", "deg"}}, 0.0, 0.1, 3);
  const float rows[][2] = {{12.0F, 1.0F}, {12.5F, 2.0F}, {13.0F, 3.0F}};
  for (const auto& row : rows) recording.append(row);
  return recording;
}

// Rows go in, columns come out.
TEST(Recording, ColumnsByName) {
  const Recording recording = three_rows();
  EXPECT_EQ(recording.rows(), 3U);
  EXPECT_THAT(recording.column("RotSpeed"), ElementsAre(12.0, 12.5, 13.0));
  EXPECT_THAT(recording.column("Pitch"), ElementsAre(1.0, 2.0, 3.0));
  EXPECT_THAT(recording.row(1), ElementsAre(12.5F, 2.0F));
}

// A name that is not there: the ones that are there are listed.
TEST(Recording, UnknownColumnListsKnownOnes) {
  const Recording recording = three_rows();
  EXPECT_THAT([&] { recording.column("Pich"); },
              ::testing::ThrowsMessage<Error>(
                  AllOf(HasSubstr("'Pich'"), HasSubstr("there are: RotSpeed Pitch"))));
}

// The run-in ends at the first row at or after its time, whatever 0.1 is in binary.
TEST(Recording, FirstRowFrom) {
  Recording recording({{"A", "-"}}, 0.0, 0.1, 10);
  const float value = 0.0F;
  for (int i = 0; i < 10; ++i) recording.append(&value);
  EXPECT_EQ(recording.first_row_from(-1.0), 0U);
  EXPECT_EQ(recording.first_row_from(0.3), 3U);
  EXPECT_EQ(recording.first_row_from(0.31), 4U);
  EXPECT_EQ(recording.first_row_from(99.0), 10U);
}

// Within the rows announced, appending does not allocate.
TEST(Recording, AppendDoesNotAllocate) {
  if (!lac::test::kCountsAllocations) GTEST_SKIP() << "malloc belongs to the sanitizer";
  Recording recording({{"A", "-"}, {"B", "-"}}, 0.0, 0.1, 1000);
  const float row[] = {1.0F, 2.0F};
  const lac::test::NoAllocGuard guard;
  for (int i = 0; i < 1000; ++i) recording.append(row);
  EXPECT_EQ(guard.allocations(), 0U);
}

// Both formats, by ending; another ending is refused.
TEST(Recording, WritesByEnding) {
  const fs::path folder = fs::path(::testing::TempDir()) / "lac_recording";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const Recording recording = three_rows();
  recording.write(folder / "run.csv");
  std::ifstream in(folder / "run.csv");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(text, "Time [s],RotSpeed [rpm],Pitch [deg]\n0,12,1\n0.1,12.5,2\n0.2,13,3\n");
  recording.write(folder / "run.outb", "seed 1");
  EXPECT_EQ(fs::file_size(folder / "run.outb"),
            2U + 2U + 4U + 4U + 16U + 2U * 8U + 4U + 6U + 6U * 10U + 3U * 2U * 2U);
  EXPECT_THROW(recording.write(folder / "run.mat"), Error);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace lac::sim
