// SPDX-License-Identifier: Apache-2.0
#include "bridge/rosco_input.hpp"

#include <gmock/gmock.h>

#include "support/error_text.hpp"
#include "support/temp_folder.hpp"

namespace lac {
namespace {

using testing::HasSubstr;

/// The lines shipped to be put behind a DISCON.IN.
std::string shipped_lines(const std::string& name) {
  const test::TempFolder folder;
  std::filesystem::copy_file(LAC_SOURCE_DIR "/config/rosco/" + name, folder.path() / name);
  return folder.read(name);
}

class RoscoInputTest : public testing::Test {
 protected:
  std::string error_of(const std::string& discon_in, FeedforwardRoute route,
                       DeratingRoute derating) const {
    BridgeParams p;
    p.feedforward = route;
    p.increment.authority_rad = 0.087;
    p.tower_damper_gain = 0.01;
    p.derating = derating;
    const InputFile bridge = InputFile::parse("DISCON.IN ! RoscoInput\n", "bridge.IN");
    const std::string file = folder.write("DISCON.IN", discon_in);
    return test::error_text([&] { check_rosco_input(bridge, file, p); });
  }
  std::string tower_error(const std::string& text) const {
    return error_of(text, FeedforwardRoute::TowerDamper, DeratingRoute::None);
  }
  std::string derating_error(const std::string& text) const {
    return error_of(text, FeedforwardRoute::None, DeratingRoute::HubWind);
  }

  const std::string tower_lines = "0 ! Fl_Mode - \n" + shipped_lines("tower_damper.lines");
  const std::string derating_lines = shipped_lines("derating.lines");
  test::TempFolder folder;
};

// The shipped lines fit, behind others that do not: of several lines the last counts.
TEST_F(RoscoInputTest, ShippedLinesFit) {
  EXPECT_EQ(tower_error("0 ! TD_Mode - off\n" + tower_lines), "no error");
  EXPECT_EQ(derating_error("2 ! WE_Mode - on\n" + derating_lines), "no error");
}

// What does not fit is named with both files, line, key, what was found and expected.
TEST_F(RoscoInputTest, Mistakes) {
  EXPECT_THAT(tower_error(tower_lines + "0 ! TD_Mode\n"),
              testing::AllOf(HasSubstr("bridge.IN:1: RoscoInput: "),
                             HasSubstr("DISCON.IN:8: TD_Mode: found 0, expected 1 with Feedf")));
  EXPECT_THAT(tower_error(tower_lines + "2.0d-2 FA_KI\n"),
              HasSubstr("FA_KI: found 0.02, expected 0.01, TowerDamperGain"));
  EXPECT_THAT(tower_error(tower_lines + "0.05 ! FA_IntSat\n"),
              HasSubstr("found 0.05, expected no less than Authority, 0.087 rad"));
  EXPECT_THAT(tower_error(tower_lines + "1 ! Fl_Mode\n"), HasSubstr("expected 0 or 2"));
  EXPECT_THAT(tower_error(tower_lines + "off ! TD_Mode\n"), HasSubstr("found 'off', expected a n"));
  EXPECT_THAT(tower_error("1 ! TD_Mode\n"), HasSubstr("DISCON.IN: FA_HPFCornerFreq: missing"));
  EXPECT_THAT(tower_error(""), HasSubstr("DISCON.IN: cannot be read, or is empty"));
  EXPECT_THAT(derating_error(derating_lines + "2 ! WE_Mode\n"), HasSubstr("found 2, expected 0"));
  EXPECT_THAT(derating_error(derating_lines + "1 ! PS_Mode\n"), HasSubstr("peak shaving"));
  EXPECT_THAT(derating_error(derating_lines + "0 ! Ind_R_Torque\n"), HasSubstr("a column of"));
  EXPECT_THAT(derating_error(derating_lines + "2 ! VS_ControlMode\n"), HasSubstr("1, 3 or 4"));
}

// What no route asks for is not looked at.
TEST_F(RoscoInputTest, NoRouteNoDemand) {
  EXPECT_EQ(error_of("0 ! TD_Mode\n", FeedforwardRoute::Added, DeratingRoute::None), "no error");
}

}  // namespace
}  // namespace lac
