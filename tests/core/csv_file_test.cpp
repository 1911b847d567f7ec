// SPDX-License-Identifier: Apache-2.0
#include "core/csv_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "support/no_alloc_guard.hpp"

namespace lac {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class CsvFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("lac_csv_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  TableSpec spec(std::vector<TableChannel> channels, std::size_t block_rows = 4) const {
    return {folder_ / "run.CSV", std::move(channels), 0.0, 0.0125, block_rows, "unused"};
  }

  fs::path folder_;
};

// The whole text of a small table: header with units, decimal time, no digits too many.
TEST_F(CsvFile, HasExpectedText) {
  const auto writer = make_table_writer(spec({{"RotSpeed", "rpm"}, {"REWS", "m/s"}}, 2));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const float rows[][2] = {{12.1F, nan}, {-0.5F, -nan}, {1e-10F, inf}, {123456.0F, -inf}};
  for (const auto& row : rows) ASSERT_TRUE(writer->append(row));
  writer->finish();
  EXPECT_EQ(content(folder_ / "run.CSV"),
            "Time [s],RotSpeed [rpm],REWS [m/s]\n"
            "0,12.1,nan\n"
            "0.0125,-0.5,nan\n"
            "0.025,1e-10,inf\n"
            "0.0375,123456,-inf\n");
}

// Values that need the most characters fit the block and read back as the same float32.
TEST_F(CsvFile, LongestValuesRoundTrip) {
  CsvWriter writer(spec({{"A", "-"}, {"B", "-"}}, 8));
  const float row[] = {-std::numeric_limits<float>::min(), -1.00000012e-38F};
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(writer.append(row));
  writer.finish();
  std::ifstream in(folder_ / "run.CSV");
  std::string line;
  std::getline(in, line);
  int rows = 0;
  while (std::getline(in, line)) {
    ++rows;
    const std::size_t first = line.find(',') + 1;
    EXPECT_EQ(static_cast<float>(std::stod(line.substr(first))), row[0]);
    EXPECT_EQ(static_cast<float>(std::stod(line.substr(line.find(',', first) + 1))), row[1]);
  }
  EXPECT_EQ(rows, 8);
}

// Row counts around block boundaries.
TEST_F(CsvFile, KeepsEveryRowAroundBlockBoundaries) {
  for (const int rows : {0, 1, 3, 4, 5, 8, 9}) {
    CsvWriter writer(spec({{"A", "-"}}, 4));
    const float value = 1.0F;
    for (int i = 0; i < rows; ++i) ASSERT_TRUE(writer.append(&value));
    writer.finish();
    const std::string text = content(folder_ / "run.CSV");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), rows + 1);
  }
}

// The final name appears at finish; a writer given up leaves nothing.
TEST_F(CsvFile, NothingHalfWritten) {
  const float value = 1.0F;
  {
    CsvWriter writer(spec({{"A", "-"}}, 1));
    ASSERT_TRUE(writer.append(&value));
    EXPECT_TRUE(fs::exists(folder_ / "run.CSV.part"));
    EXPECT_FALSE(fs::exists(folder_ / "run.CSV"));
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

// Appending does not allocate: text is formed in place.
TEST_F(CsvFile, AppendDoesNotAllocate) {
  if (!test::kCountsAllocations) GTEST_SKIP() << "malloc cannot be counted here";
  CsvWriter writer(spec({{"A", "-"}, {"B", "-"}}, 3));
  const test::NoAllocGuard guard;
  bool good = true;
  for (int i = 0; i < 100; ++i) {
    const float row[] = {std::sin(static_cast<float>(i)), 1.0e-30F};
    good = writer.append(row) && good;
  }
  EXPECT_EQ(guard.allocations(), 0U);
  EXPECT_TRUE(good);
}

}  // namespace
}  // namespace lac
