// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "core/units.hpp"
#include "ffp/ffp_params.hpp"
#include "ldp/ldp_params.hpp"
#include "sim_harness/cli/migrate_command.hpp"
#include "support/error_text.hpp"
#include "support/guo_host.hpp"
#include "support/temp_folder.hpp"
#include "wrapper/chain_config.hpp"

namespace lac::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

class Migrate : public ::testing::Test {
 protected:
  /// The text of our own form.
  std::string migrated(const std::string& theirs) {
    std::ostringstream out;
    migrate_command({folder_.write("theirs.IN", theirs), {}, false}, out);
    return out.str();
  }
  template <class Params>
  static Params read(const std::string& ours) {
    InputFile in = InputFile::parse(ours, "ours.IN");
    return Params::read(in);
  }
  template <class Params>
  static std::string error(const std::string& ours) {
    return test::error_text([&] { read<Params>(ours); });
  }
  /// Puts a value in place of the dots of a line to be filled in.
  static void fill_in(std::string& text, const std::string& key, const std::string& value) {
    const std::size_t at_key = text.find("! " + key);
    ASSERT_NE(at_key, std::string::npos) << key;
    const std::size_t line = text.rfind('\n', at_key) + 1;
    ASSERT_EQ(text.substr(line, 5), "! ...") << key;
    text.replace(line, 5, value);
  }

  test::TempFolder folder_;
};

// LDP_v1: each key that theirs does not have is reported until it is filled in; then it loads.
TEST_F(Migrate, LdpV1) {
  std::string text = migrated(test::kGuoLdpV1);
  std::map<std::string, std::string> to_fill_in{
      {"ScanTime", "1.0"}, {"GateRanges", "50 100"}, {"LidarPosition", "-3 0 92"}};
  while (!to_fill_in.empty()) {
    const std::string told = error<LdpParams>(text);
    const auto missing = std::ranges::find_if(to_fill_in, [&](const auto& entry) {
      return told.starts_with("ours.IN: " + entry.first + ": missing");
    });
    ASSERT_NE(missing, to_fill_in.end()) << told;
    fill_in(text, missing->first, missing->second);
    to_fill_in.erase(missing);
  }
  const auto p = read<LdpParams>(text);
  EXPECT_EQ(p.reader.layout, LidarLayout::Guo);
  EXPECT_EQ(p.reader.number_of_beams, 4);
  EXPECT_EQ(p.minimum_samples, 4);
  EXPECT_FALSE(p.motion_compensation);
  EXPECT_THAT(text, HasSubstr("\n16 17 -15 -18           ! BeamAzimuth"));
  EXPECT_THAT(text, HasSubstr("\n11 -13 -12 10.5         ! BeamElevation"));
}

// The range that stands unread in some of their files is taken; MC_Mode is kept.
TEST_F(Migrate, LdpV2) {
  std::string text = migrated(test::kGuoLdpV1 + "1 ! MC_Mode\n130.5 ! Lidar_RangeGates - [m]\n");
  fill_in(text, "ScanTime", "1.0");
  fill_in(text, "LidarPosition", "0 0 90");
  EXPECT_TRUE(read<LdpParams>(text).motion_compensation);
  EXPECT_THAT(text, HasSubstr("130.5                   ! GateRanges"));
}

// Angles to the centre line become elevations, which give the same wind speed.
TEST_F(Migrate, AnglesToTheCentreLine) {
  for (const auto& [theirs, elevations, samples] :
       {std::tuple{test::kGuoLdpV3, "20 35 ", 6}, {test::kGuoLdpTask52, "19 19 19 19 ", 4}}) {
    std::string text = migrated(theirs);
    fill_in(text, "ScanTime", "1.0");
    fill_in(text, "GateRanges", "80");
    fill_in(text, "LidarPosition", "0 0 90");
    const auto p = read<LdpParams>(text);
    EXPECT_EQ(p.minimum_samples, samples);
    EXPECT_FALSE(p.motion_compensation);
    EXPECT_THAT(text, HasSubstr(std::string("\n") + elevations));
  }
}

// FFP: units, the curve in degrees, the threshold where it begins to rise; the rest is told.
TEST_F(Migrate, Ffp) {
  const std::string text = migrated(test::guo_ffp_v2(1, 1, 3.0));
  const auto p = read<FfpParams>(text);
  EXPECT_NEAR(p.cutoff_hz.at(12.0), 0.3 / (2.0 * kPi), 1e-10);
  EXPECT_THAT(p.static_pitch_rad.x(), ElementsAre(0.0, 10.0, 30.0));
  EXPECT_NEAR(p.static_pitch_rad.y().back(), 0.2, 1e-10);
  EXPECT_EQ(p.threshold_mps, 10.0);
  EXPECT_THAT(text, HasSubstr("! T_buffer was 3 s."));
  EXPECT_THAT(text, HasSubstr("! The notch at 0.9 rad/s (0.02, 0.4) has no counterpart"));
}

// A low-pass that was off leaves the cut-off to be filled in.
TEST_F(Migrate, FfpWithoutLowPass) {
  std::string text = migrated(test::guo_ffp_v1(0, 1.0, 3.0));
  EXPECT_THAT(error<FfpParams>(text), HasSubstr("CutOffFrequency: missing"));
  fill_in(text, "CutOffFrequency", "4");
  EXPECT_EQ(read<FfpParams>(text).cutoff_hz.at(16.0), 4.0);
}

// WRAPPER.IN: the same calls, from the same folder.
TEST_F(Migrate, Wrapper) {
  folder_.write("l.IN", test::kGuoLdpV1);
  folder_.write("r.IN", "x");
  const std::string theirs = folder_.write(
      "WRAPPER.IN", test::kGuoHeader +
                        "2 ! NumberofSubDLLs\n\"LDP_v1.dll\" ! SubDLLName\n\"l.IN\" ! "
                        "SubDLLInputName\n\"R.dll\" ! SubDLLName\n\"r.IN\" ! SubDLLInputName\n");
  std::ostringstream out;
  migrate_command({theirs, folder_.path("ours.IN"), false}, out);
  EXPECT_THAT(out.str(), HasSubstr("ours.IN: written"));
  InputFile in = InputFile::load(folder_.path("ours.IN"));
  const WrapperParams p = WrapperParams::read(in);
  ASSERT_EQ(p.secondaries.size(), 2U);
  EXPECT_EQ(p.secondaries[0].library, "liblac_ldp");
  EXPECT_EQ(p.secondaries[1].library, "R");
  EXPECT_EQ(p.lidar, HostLidar::Guo);
}

// A file that is there is not replaced without being told so.
TEST_F(Migrate, NothingIsOverwritten) {
  const std::string theirs = folder_.write("l.IN", test::kGuoLdpV1);
  folder_.write("there.IN", "mine");
  std::ostringstream out;
  const MigrateOptions options{theirs, folder_.path("there.IN"), false};
  EXPECT_THAT(test::error_text([&] { migrate_command(options, out); }),
              EndsWith("there.IN: is there already, --force replaces it"));
  EXPECT_EQ(folder_.read("there.IN"), "mine");
  migrate_command({theirs, folder_.path("there.IN"), true}, out);
  EXPECT_THAT(folder_.read("there.IN"), HasSubstr("BeamAzimuth"));
}

// Files that are not theirs, or not there.
TEST_F(Migrate, NotTheirs) {
  EXPECT_THAT(test::error_text([&] { migrated("1 ! ScanTime\n4 ! NumberOfBeams\n"); }),
              HasSubstr("is no WRAPPER, LDP or FFP input file of Guo's chain; files of our own"));
  std::ostringstream out;
  EXPECT_THAT(test::error_text([&] {
                migrate_command({"none.IN", {}, false}, out);
              }),
              HasSubstr("none.IN: cannot open the input file: no such file"));
}

}  // namespace
}  // namespace lac::sim
