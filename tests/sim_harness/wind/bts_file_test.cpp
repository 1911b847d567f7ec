// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/bts_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "support/temp_folder.hpp"
#include "tests/sim_harness/wind/wind_bytes.hpp"

namespace lac::sim {
namespace {

class BtsFile : public testing::Test {
 protected:
  std::filesystem::path scratch(const char* name) const { return folder_.path() / name; }
  std::filesystem::path written(const char* name, const std::string& bytes) const {
    return folder_.write(name, bytes);
  }

 private:
  test::TempFolder folder_;
};

/// A file put together from the description of the format, byte by byte: 2 heights, 3 points
/// across, 2 tower points, 2 steps; velocity = (i - 100)/10 for u, i/20 for v, (i + 50)/30 for w,
/// and i = 0, 1, 2, ... in the order of the file, tower points 9999.
std::string hand_made(std::int16_t id) {
  std::string bytes;
  append(bytes, id);
  for (std::int32_t n : {2, 3, 2, 2}) append(bytes, n);
  for (float x : {12.0F, 10.0F, 0.05F, 16.0F, 90.0F, 84.0F}) append(bytes, x);
  for (float x : {10.0F, 100.0F, 20.0F, 0.0F, 30.0F, -50.0F}) append(bytes, x);
  const std::string text = "by hand";
  append(bytes, static_cast<std::int32_t>(text.size()));
  bytes += text;
  std::int16_t i = 0;
  for (int it = 0; it < 2; ++it) {
    for (int k = 0; k < 18; ++k) append(bytes, i++);
    for (int k = 0; k < 6; ++k) append(bytes, std::int16_t{9999});
  }
  return bytes;
}

// Geometry, order (y fastest, from the right), scaling and tower points of a file made by hand.
TEST_F(BtsFile, ReadsByTheDescription) {
  const GriddedWind wind = read_bts(written("hand.bts", hand_made(7)));
  const GridSpec& g = wind.grid().spec();
  EXPECT_EQ(g.y_min_m(), -10.0);
  EXPECT_EQ(wind.extent().z_min_m, 84.0);
  EXPECT_EQ(wind.extent().z_max_m, 96.0);
  EXPECT_EQ(wind.mean_speed_mps(), 16.0);
  EXPECT_EQ(g.hub_height_m, 90.0);
  EXPECT_FLOAT_EQ(static_cast<float>(wind.time_end_s()), 0.05F);
  const Vec3 first = wind.velocity({0.0, -10.0, 84.0}, 0.0);
  EXPECT_NEAR(first.x, -10.0, 1e-6);
  EXPECT_NEAR(first.y, 1.0 / 20.0, 1e-6);
  EXPECT_NEAR(first.z, 52.0 / 30.0, 1e-6);
  EXPECT_NEAR(wind.velocity({0.0, 0.0, 84.0}, 0.0).x, -9.7, 1e-6);
  EXPECT_NEAR(wind.velocity({0.0, -10.0, 96.0}, 0.0).x, -9.1, 1e-6);
  EXPECT_NEAR(wind.velocity({0.0, 10.0, 96.0}, g.dt_s).z, 85.0 / 30.0, 1e-5);
}

// Id 8 is a periodic field of nt steps.
TEST_F(BtsFile, IdEightIsPeriodic) {
  const GriddedWind wind = read_bts(written("periodic.bts", hand_made(8)));
  EXPECT_TRUE(wind.grid().spec().periodic);
  EXPECT_FLOAT_EQ(static_cast<float>(wind.duration_s()), 0.1F);
}

// Write and read: every number within half an int16 step of its component's range (6 m/s, 3 m/s;
// w is zero throughout and stays so within half of the least step), the grid unchanged.
TEST_F(BtsFile, RoundTrip) {
  for (bool periodic : {false, true}) {
    const GriddedWind wind = wavy(periodic);
    write_bts(scratch("round.bts"), wind, "round trip");
    const GriddedWind back = read_bts(scratch("round.bts"));
    EXPECT_EQ(back.grid().spec().periodic, periodic);
    EXPECT_EQ(back.extent().z_max_m, 48.0);
    EXPECT_EQ(back.duration_s(), wind.duration_s());
    const double error[3] = {6.0 / 65535, 3.0 / 65535, 1e-3 / 65535};
    for (int it = 0; it < 50; ++it) {
      for (int k = 0; k < 36; ++k)
        EXPECT_NEAR(back.grid().plane(it)[k], wind.grid().plane(it)[k], 0.5 * error[k % 3] + 2e-6);
    }
  }
}

void expect_refused(const std::filesystem::path& file, const std::vector<std::string>& texts) {
  try {
    read_bts(file);
    FAIL() << file << " was accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(file.string()));
    for (const std::string& text : texts) EXPECT_THAT(error.what(), testing::HasSubstr(text));
  }
}

// Cut within the velocities, within the header, at the start; and one byte too long.
TEST_F(BtsFile, RefusesWrongLengths) {
  const std::string bytes = hand_made(7);
  expect_refused(written("cut.bts", bytes.substr(0, bytes.size() - 1)),
                 {"offset 77", "found 95 bytes", "expected 96", "truncated"});
  expect_refused(written("header.bts", bytes.substr(0, 20)),
                 {"offset 18", "dz [m]", "end of the file", "truncated"});
  expect_refused(written("description.bts", bytes.substr(0, 72)),
                 {"offset 70", "description", "expected 7 bytes more", "truncated"});
  expect_refused(written("empty.bts", ""), {"offset 0", "truncated"});
  expect_refused(written("long.bts", bytes + "x"), {"found 97 bytes", "longer"});
}

// Another kind of file and sizes that cannot be: where, what was found, what was expected.
TEST_F(BtsFile, RefusesForeignFiles) {
  expect_refused(written("bladed.bts", hand_made(-99)),
                 {"offset 0", "id", "found -99", "expected 7 to 8"});
  const std::string bytes = hand_made(7);
  expect_refused(written("ny.bts", with_value(bytes, 6, 1)), {"offset 6", "ny", "found 1,"});
  expect_refused(written("nz.bts", with_value(bytes, 2, 1 << 30)), {"offset 2", "nz"});
  expect_refused(written("tower.bts", with_value(bytes, 10, -1)), {"offset 10", "tower"});
  expect_refused(written("dt.bts", with_value(bytes, 26, 0)), {"offset 26", "dt [s]", "found 0,"});
  expect_refused(written("nan.bts", with_value(bytes, 30, -1)), {"offset 30", "mean speed"});
  expect_refused(written("scale.bts", with_value(bytes, 42, 0)), {"offset 42", "scale"});
  expect_refused(written("text.bts", with_value(bytes, 66, -1)), {"offset 66", "description"});
  expect_refused(scratch("not_there.bts"), {"cannot be opened"});
}

// A folder that is not there is an error of writing.
TEST_F(BtsFile, RefusesToWriteNowhere) {
  EXPECT_THROW(write_bts(scratch("no_folder/x.bts"), wavy(false), ""), Error);
}

}  // namespace
}  // namespace lac::sim
