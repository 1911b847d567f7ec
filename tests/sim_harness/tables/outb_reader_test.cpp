// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tables/outb_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/error.hpp"
#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using ::testing::HasSubstr;

// What the writer wrote comes back: names, units, times, values to half a step of the packing.
TEST(OutbReaderTest, RoundTrip) {
  const test::TempFolder folder;
  Recording written({{"RotSpeed", "rpm"}, {"Flag", "-"}}, 1.5, 0.0125, 500);
  for (int i = 0; i < 500; ++i) {
    const float row[] = {static_cast<float>(12.0 + std::sin(0.1 * i)), i < 250 ? 0.0F : 1.0F};
    written.append(row);
  }
  written.write(folder.file("a.outb"), "a test");
  const Recording read = read_outb(folder.file("a.outb"));
  EXPECT_EQ(read.channels(), written.channels());
  EXPECT_EQ(read.rows(), 500U);
  EXPECT_EQ(read.start_time_s(), 1.5);
  EXPECT_EQ(read.time_step_s(), 0.0125);
  for (std::size_t i = 0; i < 500; ++i) {
    ASSERT_NEAR(read.row(i)[0], written.row(i)[0], 0.51 * 2.0 / 65535);
    ASSERT_NEAR(read.row(i)[1], written.row(i)[1], 0.51 / 65535);
  }
}

/// Bytes of numbers, one after the other.
template <typename... T>
std::string bytes(T... values) {
  std::string all;
  (all.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
  return all;
}

std::string short_names() {
  return bytes(std::int32_t{4}) + "text" + "Time      GenPwr    (s)       (kW)      ";
}

// The older forms by hand, one channel of three rows: packed without name length, with times,
// and in double precision.
TEST(OutbReaderTest, OlderFormats) {
  const test::TempFolder folder;
  const auto head = [](std::int16_t id, double a, double b) {
    return bytes(id, std::int32_t{1}, std::int32_t{3}, a, b);
  };
  const std::string packing = bytes(2.0F, 100.0F);
  const std::string packed = bytes(std::int16_t{110}, std::int16_t{120}, std::int16_t{-300});
  const std::string times = bytes(std::int32_t{-1000}, std::int32_t{-500}, std::int32_t{0});
  const std::string files[] = {
      folder.write("1.outb", head(1, 2000.0, -1000.0) + packing + short_names() + times + packed),
      folder.write("2.outb", head(2, 0.0, 0.25) + packing + short_names() + packed),
      folder.write("3.outb", head(3, 0.0, 0.25) + short_names() + bytes(5.0, 10.0, -200.0))};
  for (const std::string& file : files) {
    const Recording r = read_outb(file);
    EXPECT_EQ(r.channels(), (std::vector<TableChannel>{{"GenPwr", "kW"}})) << file;
    EXPECT_EQ(r.start_time_s(), 0.0) << file;
    EXPECT_EQ(r.time_step_s(), 0.25) << file;
    EXPECT_THAT(r.column("GenPwr"), ::testing::ElementsAre(5.0, 10.0, -200.0)) << file;
  }
}

// Times that jump have no place in a recording.
TEST(OutbReaderTest, UnevenTimesAreRefused) {
  const test::TempFolder folder;
  const std::string times = bytes(std::int32_t{0}, std::int32_t{500}, std::int32_t{600});
  const std::string file = folder.write(
      "a.outb", bytes(std::int16_t{1}, std::int32_t{1}, std::int32_t{3}, 1000.0, 0.0, 2.0F, 0.0F) +
                    short_names() + times +
                    bytes(std::int16_t{1}, std::int16_t{2}, std::int16_t{3}));
  EXPECT_THAT(test::error_text([&] { read_outb(file); }),
              HasSubstr("row 3: found a step of 0.1 s, expected a whole number of the usual step"));
}

std::string error_of(const std::filesystem::path& file) {
  return test::error_text([&] { read_outb(file); });
}

// Missing, of another format, cut off.
TEST(OutbReaderTest, Faults) {
  const test::TempFolder folder;
  EXPECT_THAT(error_of(folder.file("none.outb")), HasSubstr("cannot be opened"));
  EXPECT_THAT(error_of(folder.write("b.outb", std::string("\x07\x00", 2))),
              HasSubstr("found format id 7, expected an .outb file of id 1 to 4"));
  Recording r({{"a", "-"}}, 0.0, 1.0, 2);
  for (const float v : {0.0F, 1.0F}) r.append(&v);
  r.write(folder.file("c.outb"));
  std::string bytes = folder.read("c.outb");
  bytes.pop_back();
  EXPECT_THAT(error_of(folder.write("d.outb", bytes)), HasSubstr("ends too early"));
}

// Sizes of a damaged header are held against the file before memory is taken for them.
TEST(OutbReaderTest, SizesBeyondTheFile) {
  const test::TempFolder folder;
  const auto head = [](std::int32_t rows) {
    return bytes(std::int16_t{3}, std::int32_t{1}, rows, 0.0, 0.25);
  };
  EXPECT_THAT(error_of(folder.write("a.outb", head(2000000000) + short_names() + bytes(5.0))),
              HasSubstr("a.outb: ends too early for an OpenFAST output file: found 8 bytes where "
                        "its header tells of 16000000000"));
  EXPECT_THAT(error_of(folder.write("b.outb", head(1) + bytes(std::int32_t{2147483647}) + "text")),
              HasSubstr("b.outb: ends too early for an OpenFAST output file: found 4 bytes where "
                        "its header tells of 2147483647"));
}

}  // namespace
}  // namespace lac::sim
