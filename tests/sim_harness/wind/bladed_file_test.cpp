// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/bladed_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"
#include "tests/sim_harness/wind/wind_bytes.hpp"

namespace lac::sim {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A file put together from the description of the format, byte by byte: 2 heights, 3 points
/// across, 2 steps of 0.1 s at 16 m/s; TI 12.5, 6.25 and 3.125 %, so that one step of the integers
/// is 2, 1 and 0.5 mm/s; the integers are 0, 1, 2, ... in the order of the file.
std::string hand_made() {
  std::string bytes;
  append(bytes, std::int16_t{-99});
  append(bytes, std::int16_t{4});
  append(bytes, std::int32_t{3});
  for (float x : {55.0F, 0.03F, 90.0F, 12.5F, 6.25F, 3.125F, 12.0F, 10.0F, 1.6F}) append(bytes, x);
  append(bytes, std::int32_t{1});
  for (float x : {16.0F, 0.0F, 0.0F, 0.0F}) append(bytes, x);
  for (std::int32_t n : {0, 7, 2, 3, 0, 0, 0, 0, 0, 0}) append(bytes, n);
  for (std::int16_t i = 0; i < 36; ++i) append(bytes, i);
  return bytes;
}

constexpr char kSummary[] =
    "TurbSim writes many lines\n"
    " 95.000  Hub height [m]\n"
    "  UBar  =  16.0 m/s\n"
    "  TI(u) =  12.5 %\n"
    "  TI(v) =   6.25 %\n"
    "  TI(w) =   3.125 %\n"
    "  Height offset =  5.0 m\n"
    "Creating a PERIODIC output file.\n"
    "Creating a BLADED LEFT-HAND RULE output file.\n";

class BladedFile : public testing::Test {
 protected:
  std::string error(const std::string& wnd, const std::string& sum) {
    const std::string file = folder_.write("x.wnd", wnd);
    folder_.write("x.sum", sum);
    return test::error_text([&] { read_bladed(file); });
  }
  GriddedWind read(const std::string& wnd, const std::string& sum) {
    folder_.write("x.sum", sum);
    return read_bladed(folder_.write("x.wnd", wnd));
  }

  test::TempFolder folder_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

// Geometry, order (y fastest, from the right), scales and signs of a file made by hand: the
// summary's hub height and offset put the centre at 90 m; v is turned round by the left-hand rule.
TEST_F(BladedFile, ReadsByTheDescription) {
  const GriddedWind wind = read(hand_made(), kSummary);
  const GridSpec& g = wind.grid().spec();
  EXPECT_EQ(g.y_min_m(), -10.0);
  EXPECT_EQ(g.z_bottom_m, 84.0);
  EXPECT_EQ(g.z_m(1), 96.0);
  EXPECT_EQ(g.hub_height_m, 95.0);
  EXPECT_NEAR(g.dt_s, 0.1, 1e-8);
  EXPECT_TRUE(g.periodic);
  EXPECT_EQ(wind.mean_speed_mps(), 16.0);
  const Vec3 first = wind.velocity({0.0, -10.0, 84.0}, 0.0);
  EXPECT_NEAR(first.x, 16.0, 1e-6);
  EXPECT_NEAR(first.y, -0.001, 1e-7);
  EXPECT_NEAR(first.z, 0.001, 1e-7);
  EXPECT_NEAR(wind.velocity({0.0, 0.0, 84.0}, 0.0).x, 16.006, 1e-6);
  EXPECT_NEAR(wind.velocity({0.0, 10.0, 96.0}, g.dt_s).y, -0.034, 1e-7);
}

// Without the phrase v keeps its sign; clockwise rows run from left to right; not periodic.
TEST_F(BladedFile, SignsOfTheSummary) {
  std::string sum = replaced(kSummary, "BLADED LEFT-HAND RULE", "simple");
  sum = replaced(sum, "a PERIODIC", "an");
  const GriddedWind plain = read(hand_made(), sum);
  EXPECT_NEAR(plain.velocity({0.0, -10.0, 84.0}, 0.0).y, 0.001, 1e-7);
  EXPECT_FALSE(plain.grid().spec().periodic);
  const GriddedWind turned = read(hand_made(), " T Clockwise\n" + std::string(kSummary));
  EXPECT_NEAR(turned.velocity({0.0, 10.0, 84.0}, 0.0).x, 16.0, 1e-6);
  EXPECT_NEAR(turned.velocity({0.0, -10.0, 84.0}, 0.0).x, 16.012, 1e-6);
}

// An odd number of steps has one more than the header can say; intensities that the header leaves
// out (0) come from the summary.
TEST_F(BladedFile, OddStepsAndIntensitiesOfTheSummary) {
  std::string bytes = with_value(hand_made(), 20, 0.0F);
  for (int i = 0; i < 18; ++i) append(bytes, std::int16_t{100});
  const GriddedWind wind = read(bytes, kSummary);
  EXPECT_EQ(wind.grid().spec().nt, 3);
  EXPECT_NEAR(wind.grid().at(2, 0, 0, 0), 16.2, 1e-5);
}

// Write and read: every number within half a step of its scale (standard deviations 2.1 and
// 1.1 m/s; 0.01 m/s where there is nothing), the grid unchanged, also with an odd count.
TEST_F(BladedFile, RoundTrip) {
  for (const auto& [periodic, nt] : {std::pair{false, 50}, {true, 50}, {true, 51}}) {
    const GriddedWind wind = wavy(periodic, nt);
    write_bladed(folder_.file("round.wnd"), wind);
    const GriddedWind back = read_bladed(folder_.file("round.wnd"));
    const GridSpec &a = wind.grid().spec(), &b = back.grid().spec();
    EXPECT_EQ(b.periodic, periodic);
    EXPECT_EQ(b.nt, nt);
    EXPECT_NEAR(b.z_bottom_m, a.z_bottom_m, 1e-5);
    EXPECT_NEAR(b.hub_height_m, a.hub_height_m, 1e-4);
    EXPECT_NEAR(b.dt_s, a.dt_s, 1e-7 * a.dt_s);
    const double half_step[3] = {0.5 * 2.2e-3, 0.5 * 1.1e-3, 0.5e-5};
    for (int it = 0; it < nt; ++it) {
      for (int k = 0; k < 36; ++k)
        EXPECT_NEAR(back.grid().plane(it)[k], wind.grid().plane(it)[k], half_step[k % 3] + 2e-6);
    }
  }
}

// A single great value does not run over the integers: the scale grows with it.
TEST_F(BladedFile, GreatValuesAreHeld) {
  VelocityGrid grid(wavy(true).grid());
  grid.at(7, 1, 1, 2) = -40.0F;
  grid.at(9, 1, 1, 0) = 95.0F;
  write_bladed(folder_.file("great.wnd"), GriddedWind(grid));
  const GriddedWind back = read_bladed(folder_.file("great.wnd"));
  EXPECT_NEAR(back.grid().at(7, 1, 1, 2), -40.0, 0.5e-3 * 40.0 / 32.7);
  EXPECT_NEAR(back.grid().at(9, 1, 1, 0), 95.0, 0.5e-3 * 82.5 / 32.7);
}

// Cut, too long, of another kind, with sizes that cannot be: where, what, what instead.
TEST_F(BladedFile, RefusesForeignFiles) {
  const std::string bytes = hand_made();
  EXPECT_THAT(error(bytes.substr(0, bytes.size() - 2), kSummary),
              AllOf(HasSubstr("x.wnd: offset 104: velocities: found 70 bytes"),
                    HasSubstr("expected 72 from"), HasSubstr("truncated")));
  EXPECT_THAT(error(bytes + "x", kSummary), HasSubstr("longer than a Bladed .wnd file"));
  EXPECT_THAT(error(bytes.substr(0, 30), kSummary), HasSubstr("end of the file"));
  EXPECT_THAT(error(with_value(bytes, 0, std::int16_t{7}), kSummary),
              HasSubstr("offset 0: id: found 7, expected -99 to -99 in a Bladed .wnd file"));
  EXPECT_THAT(error(with_value(bytes, 2, std::int16_t{8}), kSummary),
              HasSubstr("offset 2: kind of turbulence: found 8, expected 4"));
  EXPECT_THAT(error(with_value(bytes, 36, 0.0F), kSummary), HasSubstr("offset 36: dy [m]"));
  EXPECT_THAT(error("! a uniform wind file\n0 12 0 0 0 0 0 0\n", kSummary), HasSubstr("offset 0"));
}

// The summary: missing, without its numbers, of another file.
TEST_F(BladedFile, RefusesWrongSummaries) {
  const std::string file = folder_.write("alone.wnd", hand_made());
  EXPECT_THAT(test::error_text([&] { read_bladed(file); }),
              AllOf(HasSubstr("alone.sum: cannot be opened"), HasSubstr("summary beside it")));
  EXPECT_THAT(error(hand_made(), "nothing\n"),
              HasSubstr("x.sum:1: hub height: found the end of the file"));
  EXPECT_THAT(error(hand_made(), replaced(kSummary, "16.0 m/s", "fast")),
              HasSubstr("x.sum:3: UBar [m/s]: found '  FAST', expected a number from 0.001"));
  EXPECT_THAT(error(hand_made(), replaced(kSummary, "TI(w) =", "TI(w)")),
              HasSubstr("x.sum:6: TI [%]: found no '='"));
  EXPECT_THAT(error(hand_made(), replaced(kSummary, "16.0 m/s", "17.0 m/s")),
              AllOf(HasSubstr("x.wnd: mean speed: found 16 m/s, expected 17 m/s"),
                    HasSubstr("do not belong together")));
}

// A folder that is not there is an error of writing.
TEST_F(BladedFile, RefusesToWriteNowhere) {
  EXPECT_THROW(write_bladed(folder_.file("no_folder/x.wnd"), wavy(false)), Error);
}

}  // namespace
}  // namespace lac::sim
