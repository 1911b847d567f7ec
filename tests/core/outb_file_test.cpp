// SPDX-License-Identifier: Apache-2.0
#include "core/outb_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "support/error_text.hpp"
#include "support/no_alloc_guard.hpp"

namespace lac {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Outb {
  std::int16_t id = 0;
  double t0 = 0.0;
  double dt = 0.0;
  std::string description;
  std::vector<std::string> names;
  std::vector<std::string> units;
  std::vector<std::vector<double>> columns;
};

class ByteReader {
 public:
  explicit ByteReader(const fs::path& path) : in_(path, std::ios::binary) {}
  template <typename T>
  T get() {
    T value{};
    in_.read(reinterpret_cast<char*>(&value), sizeof value);
    return value;
  }
  std::string text(std::size_t size) {
    std::string text(size, '?');
    in_.read(text.data(), static_cast<std::streamsize>(size));
    return text.substr(0, text.find_last_not_of(' ') + 1);
  }
  bool at_end() { return in_.peek() == std::ifstream::traits_type::eof(); }

 private:
  std::ifstream in_;
};

// Written from the format's description alone, without a look at the writer.
Outb read_outb(const fs::path& path) {
  ByteReader in(path);
  Outb file;
  file.id = in.get<std::int16_t>();
  const auto width = static_cast<std::size_t>(in.get<std::int16_t>());
  const auto channels = static_cast<std::size_t>(in.get<std::int32_t>());
  const auto rows = static_cast<std::size_t>(in.get<std::int32_t>());
  file.t0 = in.get<double>();
  file.dt = in.get<double>();
  std::vector<double> scale(channels), offset(channels);
  for (double& s : scale) s = in.get<float>();
  for (double& o : offset) o = in.get<float>();
  file.description = in.text(static_cast<std::size_t>(in.get<std::int32_t>()));
  for (std::size_t i = 0; i <= channels; ++i) file.names.push_back(in.text(width));
  for (std::size_t i = 0; i <= channels; ++i) file.units.push_back(in.text(width));
  file.columns.assign(channels, {});
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < channels; ++i) {
      file.columns[i].push_back((in.get<std::int16_t>() - offset[i]) / scale[i]);
    }
  }
  EXPECT_TRUE(in.at_end());
  return file;
}

class OutbFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("lac_outb_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  TableSpec spec(std::vector<TableChannel> channels, std::size_t block_rows = 4) const {
    return {folder_ / "run.outb", std::move(channels), 0.0, 0.0125, block_rows, "test"};
  }
  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

// Every byte of a file of two channels and two rows, worked out by hand.
TEST_F(OutbFile, HasExpectedBytes) {
  TableSpec table = spec({{"RotSpeed", "rpm"}, {"FFP_REWS", "m/s"}});
  table.start_time_s = 60.0;
  table.time_step_s = 0.5;
  OutbWriter writer(table);
  const float first[] = {0.0F, 1.0F};
  const float second[] = {65535.0F, 3.0F};
  ASSERT_TRUE(writer.append(first));
  ASSERT_TRUE(writer.append(second));
  writer.finish();

  std::string expected;
  const auto put = [&expected](auto value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    expected.append(bytes, sizeof value);
  };
  expected += std::string("\x04\x00\x0a\x00\x02\x00\x00\x00\x02\x00\x00\x00", 12);
  put(60.0);
  put(0.5);
  put(1.0F);
  put(32767.5F);
  put(-32768.0F);
  put(-65535.5F);  // -32768 - 32767.5 * 1
  expected += std::string("\x04\x00\x00\x00test", 8);
  expected += "Time      RotSpeed  FFP_REWS  ";
  expected += "(s)       (rpm)     (m/s)     ";
  expected += std::string("\x00\x80\x00\x80\xff\x7f\xff\x7f", 8);

  std::ifstream in(table.path, std::ios::binary);
  const std::string found{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(found, expected);
}

// Quantisation error is at most half a level for ordinary channels.
TEST_F(OutbFile, ReadsBackWithinHalfALevel) {
  OutbWriter writer(spec({{"GenTq", "kNm"}, {"a_rather_long_channel_name", "-"}}, 64));
  std::vector<float> torque, other;
  for (int i = 0; i < 1000; ++i) {
    torque.push_back(40.0F + 3.0F * std::sin(0.1F * static_cast<float>(i)));
    other.push_back(-0.02F * static_cast<float>(i % 17));
    const float row[] = {torque.back(), other.back()};
    ASSERT_TRUE(writer.append(row));
  }
  writer.finish();

  const Outb file = read_outb(folder_ / "run.outb");
  EXPECT_EQ(file.id, 4);
  EXPECT_EQ(file.dt, 0.0125);
  EXPECT_THAT(file.names, ElementsAre("Time", "GenTq", "a_rather_long_channel_name"));
  EXPECT_THAT(file.units, ElementsAre("(s)", "(kNm)", "(-)"));
  ASSERT_EQ(file.columns[0].size(), 1000U);
  for (std::size_t i = 0; i < 1000; ++i) {
    EXPECT_NEAR(file.columns[0][i], torque[i], 0.51 * 6.0 / 65535.0);
    EXPECT_NEAR(file.columns[1][i], other[i], 0.51 * 0.32 / 65535.0);
  }
}

// A constant channel has range zero; a nearly constant one beside a large mean loses no more
// than float32 itself does.
TEST_F(OutbFile, ConstantChannelsSurvive) {
  OutbWriter writer(spec({{"Zero", "-"}, {"Five", "-"}, {"Large", "N"}}));
  for (int i = 0; i < 9; ++i) {
    const float row[] = {0.0F, 5.0F, 1.0e6F + (i % 2 == 0 ? 0.0F : 0.0625F)};
    ASSERT_TRUE(writer.append(row));
  }
  writer.finish();
  const Outb file = read_outb(folder_ / "run.outb");
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(file.columns[0][i], 0.0);
    EXPECT_NEAR(file.columns[1][i], 5.0, 1e-6);
    EXPECT_NEAR(file.columns[2][i], i % 2 == 0 ? 1.0e6 : 1.0e6 + 0.0625, 0.125);
  }
}

// Non-finite values come back as 0, are counted by name and do not spoil the other channels.
TEST_F(OutbFile, NonFiniteValuesAreZeroAndCounted) {
  OutbWriter writer(spec({{"REWS", "m/s"}, {"Lead", "s"}, {"Pitch", "deg"}}));
  const float rows[][3] = {{kNan, kNan, 1.0F},
                           {kNan, std::numeric_limits<float>::infinity(), 2.0F},
                           {18.0F, -kNan, 3.0F}};
  for (const auto& row : rows) ASSERT_TRUE(writer.append(row));
  writer.finish();
  const Outb file = read_outb(folder_ / "run.outb");
  EXPECT_EQ(file.description, "test; not finite, stored as 0: REWS 2, Lead 3");
  EXPECT_NEAR(file.columns[0][0], 0.0, 18.0 / 65535.0);
  EXPECT_NEAR(file.columns[0][2], 18.0, 18.0 / 65535.0);
  EXPECT_THAT(file.columns[1], ElementsAre(0.0, 0.0, 0.0));
  EXPECT_NEAR(file.columns[2][1], 2.0, 2.0 / 65535.0);
}

// Row counts before, at and after block boundaries, and none at all.
TEST_F(OutbFile, KeepsEveryRowAroundBlockBoundaries) {
  for (const std::size_t rows : {0U, 1U, 3U, 4U, 5U, 8U, 9U}) {
    OutbWriter writer(spec({{"Count", "-"}}, 4));
    for (std::size_t i = 0; i < rows; ++i) {
      const float value = static_cast<float>(i);
      ASSERT_TRUE(writer.append(&value));
    }
    writer.finish();
    const Outb file = read_outb(folder_ / "run.outb");
    ASSERT_EQ(file.columns[0].size(), rows);
    for (std::size_t i = 0; i < rows; ++i) EXPECT_NEAR(file.columns[0][i], i, 1e-3);
  }
}

// The final name appears at finish and the temporary files go.
TEST_F(OutbFile, NameAppearsAtFinishOnly) {
  const float value = 1.0F;
  OutbWriter writer(spec({{"A", "-"}}, 1));
  ASSERT_TRUE(writer.append(&value));
  EXPECT_TRUE(fs::exists(folder_ / "run.outb.part"));
  EXPECT_FALSE(fs::exists(folder_ / "run.outb"));
  writer.finish();
  EXPECT_TRUE(fs::exists(folder_ / "run.outb"));
  EXPECT_FALSE(writer.append(&value));
  EXPECT_NO_THROW(writer.finish());
}

// Given up without finish: nothing is left, and an older result stays as it was.
TEST_F(OutbFile, AbandonedWriterLeavesNothing) {
  const float value = 1.0F;
  { OutbWriter(spec({{"A", "-"}}, 1)).append(&value); }
  EXPECT_EQ(files_in_folder(), 0U);

  OutbWriter complete(spec({{"A", "-"}}));
  complete.append(&value);
  complete.finish();
  { OutbWriter(spec({{"B", "-"}}, 1)).append(&value); }
  EXPECT_EQ(read_outb(folder_ / "run.outb").names[1], "A");
  EXPECT_EQ(files_in_folder(), 1U);
}

// Temporary files go away with the writer after finish, too.
TEST_F(OutbFile, LeavesOneFile) {
  const float value = 1.0F;
  {
    OutbWriter writer(spec({{"A", "-"}}, 1));
    writer.append(&value);
    writer.finish();
  }
  EXPECT_EQ(files_in_folder(), 1U);
}

std::string error_of(TableSpec table) {
  return test::error_text([&] { make_table_writer(std::move(table)); });
}

// A folder that is not there, a folder in place of the file: file and reason are named.
TEST_F(OutbFile, BadPathNamesFileAndReason) {
  TableSpec table = spec({{"A", "-"}});
  table.path = folder_ / "missing" / "run.outb";
  EXPECT_THAT(error_of(table),
              AllOf(HasSubstr(table.path.string()), HasSubstr("No such file or directory")));
  table.path = folder_ / "folder.outb";
  fs::create_directory(table.path);
  EXPECT_THAT(error_of(table), AllOf(HasSubstr("folder.outb"), HasSubstr("Is a directory")));
  table.path = folder_ / "run.xlsx";
  EXPECT_THAT(error_of(table), AllOf(HasSubstr("run.xlsx"), HasSubstr("expected .outb or .csv")));
}

// Two writers for one file: the second is refused, the first is not disturbed.
TEST_F(OutbFile, SecondWriterOfTheSameFileIsRefused) {
  OutbWriter first(spec({{"A", "-"}}));
  EXPECT_THAT(error_of(spec({{"A", "-"}})), HasSubstr("another run is writing this file"));
  const float value = 7.0F;
  ASSERT_TRUE(first.append(&value));
  first.finish();
  EXPECT_NEAR(read_outb(folder_ / "run.outb").columns[0][0], 7.0, 1e-5);
}

// Tables that cannot be read back unambiguously are refused with the culprit's name.
TEST_F(OutbFile, UnusableTablesAreRefused) {
  EXPECT_THAT(error_of(spec({})), HasSubstr("no channels"));
  EXPECT_THAT(error_of(spec({{"A", "-"}, {"A", "-"}})), HasSubstr("'A' occurs twice"));
  EXPECT_THAT(error_of(spec({{"Time", "s"}})), HasSubstr("'Time' occurs twice"));
  EXPECT_THAT(error_of(spec({{"Rot Speed", "rpm"}})), HasSubstr("'Rot Speed'"));
  EXPECT_THAT(error_of(spec({{"Temp",
                              "\xc2\xb0"
                              "C"}})),
              HasSubstr("of channel Temp"));
  EXPECT_THAT(error_of(spec({{"A", "-"}}, 0)), HasSubstr("block size is 0"));
  TableSpec table = spec({{"A", "-"}});
  table.time_step_s = 0.0;
  EXPECT_THAT(error_of(table), HasSubstr("time step is 0.000000 s"));
  EXPECT_EQ(files_in_folder(), 0U);
}

// The guard counts, and append does not allocate, block writes included.
TEST_F(OutbFile, AppendDoesNotAllocate) {
  if (!test::kCountsAllocations) GTEST_SKIP() << "malloc cannot be counted here";
  const test::NoAllocGuard control;
  ::operator delete(::operator new(16));  // a new expression may be optimised away
  EXPECT_EQ(control.allocations(), 1U);

  OutbWriter writer(spec({{"A", "-"}, {"B", "-"}}, 3));
  const float row[] = {1.5F, kNan};
  const test::NoAllocGuard guard;
  bool good = true;
  for (int i = 0; i < 100; ++i) good = writer.append(row) && good;
  EXPECT_EQ(guard.allocations(), 0U);
  EXPECT_TRUE(good);
}

}  // namespace
}  // namespace lac
