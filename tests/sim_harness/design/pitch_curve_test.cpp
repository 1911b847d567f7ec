// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/pitch_curve.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "ffp/ffp_params.hpp"
#include "sim_harness/design/feedback_design.hpp"
#include "sim_harness/turbine/operating_point.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::filesystem::path kConfig = std::filesystem::path(LAC_SOURCE_DIR) / "config";

TurbineParams nrel5mw() {
  return load_turbine(kConfig / "turbines/nrel5mw/turbine.yaml");
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

FeedbackParams feedback_in(const std::string& text) {
  InputFile file = InputFile::parse(text, "feedback.IN");
  return FeedbackParams::read(file);
}

/// The design block of a design file with these lines.
FeedbackDesign feedback_design(const TurbineParams& turbine, const std::string& lines = {}) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "design.yaml";
  std::ofstream(file) << "feedback:\n  template: " << (kConfig / "nrel5mw/feedback_lac.IN").string()
                      << "\n  gain_wind_speeds_mps: [12, 16, 20, 24]\n"
                      << lines;
  YamlReader in = YamlReader::load(file);
  return read_feedback_design(in.map("feedback"), turbine, {});
}

// Straight lines between the points are the steady states, as closely as promised, and the shipped
// curve, which was read off the flying chain, is the same one.
TEST(PitchCurve, IsTheSteadyStateOfTheTurbine) {
  const TurbineParams turbine = nrel5mw();
  const PitchCurve curve = static_pitch_curve(turbine);
  EXPECT_LE(curve.largest_error_rad, PitchCurveSettings{}.tolerance_rad);
  EXPECT_NEAR(curve.rated_wind_mps, rated_point(design_plant(turbine)).wind_mps, 1e-6);
  EXPECT_EQ(curve.pitch_rad.at(8.0), 0.0);
  for (double v = 11.4; v < curve.last_balance_mps; v += 0.37) {
    EXPECT_NEAR(curve.pitch_rad.at(v), steady_state(turbine, v).pitch_rad, rad_from_deg(0.08)) << v;
  }
  InputFile file = InputFile::load(kConfig / "nrel5mw/ffp.IN");
  const LookupTable shipped = FfpParams::read(file).static_pitch_rad;
  for (double v = 12.0; v <= 31.0; v += 1.0)
    EXPECT_NEAR(curve.pitch_rad.at(v), shipped.at(v), rad_from_deg(0.06)) << v;
}

// The curve of a public lidar-assisted chain for this turbine, from the aeroelastic model
// (FFP_RW.IN of mehdyG/Baseline-Lidar-assisted-Controller, NREL5MW_02); quasi-steady tables differ
// by 0.01 rad.
TEST(PitchCurve, LiesBesideTheAeroelasticOne) {
  const PitchCurve curve = static_pitch_curve(nrel5mw());
  const double published[][2] = {{12.4, 0.0888}, {13.4, 0.1306}, {14.4, 0.1642}, {16.4, 0.2210},
                                 {18.4, 0.2697}, {20.4, 0.3135}, {22.4, 0.3568}, {24.4, 0.3980}};
  for (const auto& [wind_mps, pitch_rad] : published)
    EXPECT_NEAR(curve.pitch_rad.at(wind_mps), pitch_rad, 0.01) << wind_mps;
}

// Its slope is the small-signal optimum -(dM/dv)/(dM/dtheta).
TEST(PitchCurve, HasTheSlopeThatCancelsTheWind) {
  const TurbineParams turbine = nrel5mw();
  const PitchCurve curve = static_pitch_curve(turbine);
  for (const double v : {14.0, 18.0, 22.0}) {
    const RotorAero::TorqueSlopes s = turbine.rotor.torque_slopes(
        v, turbine.rated_rotor_speed_radps, steady_state(turbine, v).pitch_rad);
    const double slope = (curve.pitch_rad.at(v + 0.5) - curve.pitch_rad.at(v - 0.5)) / 1.0;
    EXPECT_NEAR(slope, -s.per_wind / s.per_pitch, 0.06 * slope) << v;
  }
}

// What is written is read again, and everything else is left as it was.
TEST(PitchCurve, IsWrittenIntoTheFeedforwardsInput) {
  const TurbineParams turbine = nrel5mw();
  const PitchCurve curve = static_pitch_curve(turbine);
  const std::string text = with_pitch_curve(text_of(kConfig / "nrel5mw/ffp.IN"), turbine, curve);
  InputFile after = InputFile::parse(text, "ffp.IN");
  InputFile before = InputFile::load(kConfig / "nrel5mw/ffp.IN");
  const FfpParams p = FfpParams::read(after), old = FfpParams::read(before);
  for (double v = 10.0; v < 40.0; v += 0.9)
    EXPECT_NEAR(p.static_pitch_rad.at(v), curve.pitch_rad.at(v), 2e-4) << v;
  EXPECT_EQ(p.cutoff_hz.y(), old.cutoff_hz.y());
  EXPECT_THAT(text, HasSubstr("steady states of NREL 5 MW"));
  EXPECT_THAT(text, testing::Not(HasSubstr("CCBlade")));
}

// A rotor that never reaches rated power has no such curve.
TEST(PitchCurve, RefusesARotorThatIsTooWeak) {
  TurbineParams turbine = nrel5mw();
  turbine.rated_torque_Nm *= 30.0;
  EXPECT_THAT([&] { static_pitch_curve(turbine); },
              ThrowsMessage<Error>(HasSubstr("from which on the blades pitch")));
}

// The arrays are the gains that the controller designs itself from the same table.
TEST(FeedbackDesign, WritesTheGainsThatTheControllerWouldDesign) {
  const TurbineParams turbine = nrel5mw();
  const std::string text = designed_feedback_input(text_of(kConfig / "nrel5mw/feedback_lac.IN"),
                                                   feedback_design(turbine), turbine);
  const FeedbackParams given = feedback_in(text);
  InputFile file = InputFile::load(kConfig / "nrel5mw/feedback_lac.IN");
  const FeedbackParams designed = FeedbackParams::read(file);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(given.pitch.gains.proportional_s.x()[i], designed.pitch.gains.proportional_s.x()[i],
                2e-5);
    EXPECT_NEAR(given.pitch.gains.proportional_s.y()[i], designed.pitch.gains.proportional_s.y()[i],
                1e-6);
    EXPECT_NEAR(given.pitch.gains.integral_time_s.y()[i],
                designed.pitch.gains.integral_time_s.y()[i], 1e-4);
  }
  EXPECT_NEAR(given.torque.gains.proportional, designed.torque.gains.proportional, 0.1);
  EXPECT_EQ(given.use_feedforward, true);
  EXPECT_THAT(text, HasSubstr("! Gains: poles of the rotor speed of NREL 5 MW"));
  // Published for this turbine and target (methods, turbines page): 0.00668 s and 2.434 s at 16
  // m/s.
  EXPECT_NEAR(given.pitch.gains.proportional_s.y()[1], 0.00668, 0.05 * 0.00668);
  EXPECT_NEAR(given.pitch.gains.integral_time_s.y()[1], 2.434, 0.05 * 2.434);
}

// Another target gives other gains: k_i goes with the square of the frequency.
TEST(FeedbackDesign, FollowsItsTarget) {
  const TurbineParams turbine = nrel5mw();
  const auto integral_gain = [&](const std::string& lines) {
    const PitchGainSchedule g = feedback_design(turbine, lines).params.pitch.gains;
    return g.proportional_s.y()[2] / g.integral_time_s.y()[2];
  };
  EXPECT_NEAR(integral_gain("  frequency_radps: 0.6\n") / integral_gain(""), 1.44, 1e-9);
}

// A template of another turbine would be flown with these gains.
TEST(FeedbackDesign, RefusesTheInputOfAnotherTurbine) {
  TurbineParams turbine = nrel5mw();
  turbine.rated_torque_Nm *= 1.1;
  EXPECT_THAT([&] { feedback_design(turbine); },
              ThrowsMessage<Error>(HasSubstr("as the turbine has it")));
}

}  // namespace
}  // namespace lac::sim
