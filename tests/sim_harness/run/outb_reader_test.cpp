// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/outb_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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

std::string error_of(const std::filesystem::path& file) {
  return test::error_text([&] { read_outb(file); });
}

// Missing, of another format, cut off.
TEST(OutbReaderTest, Faults) {
  const test::TempFolder folder;
  EXPECT_THAT(error_of(folder.file("none.outb")), HasSubstr("cannot be opened"));
  EXPECT_THAT(error_of(folder.write("b.outb", std::string("\x02\x00", 2))),
              HasSubstr("found format id 2, expected an .outb file of id 4"));
  Recording r({{"a", "-"}}, 0.0, 1.0, 2);
  for (const float v : {0.0F, 1.0F}) r.append(&v);
  r.write(folder.file("c.outb"));
  std::string bytes = folder.read("c.outb");
  bytes.pop_back();
  EXPECT_THAT(error_of(folder.write("d.outb", bytes)), HasSubstr("ends too early"));
}

}  // namespace
}  // namespace lac::sim
