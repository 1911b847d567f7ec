// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/design_report.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/input_file.hpp"

namespace lac::sim {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

constexpr auto kTemplate = R"(! Head of the file.

! Low-pass of another lidar,
! found by hand.
12 24 ! CutOffWindSpeed - old [m/s]
! in between
0.03 0.06 ! CUTOFFFREQUENCY - old [Hz]

! Timing.
0.08 ! DelayFrequency - at which the delays are made up for [Hz]
0 12 25 ! StaticWind - wind speed [m/s]
0.0 3.8 23.1 ! StaticPitch - pitch there [deg]
13.5 ! ThresholdSpeed - active above this [m/s]
)";

/// Coherent at low wavenumbers; half of the gain left at 0.02 rad/m.
class SimpleModel : public CorrelationModel {
 public:
  std::vector<RotorLidarSpectra> at(double k1_radpm,
                                    const std::vector<double>& speeds_mps) const override {
    const double x = k1_radpm / 0.02;
    const RotorLidarSpectra s{1.0, {1.0}, {1.0 / (1.0 + x * x)}};
    return std::vector<RotorLidarSpectra>(speeds_mps.size(), s);
  }
};

DesignResult result_of(const DesignCase& design) {
  const LidarVolumes lidar = lidar_volumes(design.lidar, {});
  const CorrelationCurves curves(SimpleModel(), design.speeds_mps, {});
  return {design, lidar, curves, design_feedforward(curves, lidar, design.rule, design.timing),
          2e-5};
}

DesignCase simple_design() {
  DesignCase d;
  d.file = "folder/simple.yaml";
  d.rotor_radius_m = 63.0;
  d.lidar.scan.beams = {{}};
  d.lidar.gates_m = {120.0};
  d.turbulence = MannParams{};
  d.speeds_mps = {8.0, 16.0, 24.5};
  return d;
}

// What is written is read again: the new schedule, and all else as it was.
TEST(DesignReport, WritesAnFfpInputThatIsReadAgain) {
  const DesignCase design = simple_design();
  const DesignResult result = result_of(design);
  const std::string text = designed_ffp_input(kTemplate, result);
  InputFile file = InputFile::parse(text, "ffp.IN");
  const FfpParams ffp = FfpParams::read(file);
  ASSERT_EQ(ffp.cutoff_hz.x(), design.speeds_mps);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(ffp.cutoff_hz.y()[i], result.points[i].cutoff_hz, 0.5e-5);
  EXPECT_EQ(ffp.threshold_mps, 13.5);
  EXPECT_THAT(ffp.static_pitch_rad.x(), SizeIs(3));
  EXPECT_THAT(text, HasSubstr("! Head of the file."));
  EXPECT_THAT(text, HasSubstr("! Timing."));
}

// Comments tell of the new numbers, not of the old ones.
TEST(DesignReport, WritesWhereTheNumbersComeFrom) {
  const DesignCase design = simple_design();
  const std::string text = designed_ffp_input(kTemplate, result_of(design));
  EXPECT_THAT(text, HasSubstr("! lac design simple.yaml"));
  EXPECT_THAT(text, HasSubstr("! turbulence: Mann tensor, L 49 m"));
  EXPECT_THAT(text, HasSubstr("! lidar: 1 beam, 1 gate at 120 m"));
  EXPECT_THAT(text, Not(HasSubstr("found by hand")));
  EXPECT_THAT(text, Not(HasSubstr("in between")));
  EXPECT_THAT(text, Not(HasSubstr("0.03 0.06")));
  const std::string again = designed_ffp_input(text, result_of(design));
  EXPECT_EQ(again, text);
}

// Second order and trim are written and read again, as a schedule each; the template's own filter
// and trim are gone, and a first-order design on top of it leaves nothing of the second order.
TEST(DesignReport, WritesFilterAndTrim) {
  DesignCase design = simple_design();
  design.timing.filter_order = 2;
  design.timing.trim_lateness = true;
  const DesignResult result = result_of(design);
  const std::string text =
      designed_ffp_input(std::string(kTemplate) + "0.7 ! BufferTrim - by hand [s]\n", result);
  InputFile file = InputFile::parse(text, "ffp.IN");
  const FfpParams ffp = FfpParams::read(file);
  ASSERT_EQ(ffp.filter_order, 2);
  ASSERT_EQ(ffp.damping.x(), design.speeds_mps);
  ASSERT_EQ(ffp.buffer_trim_s.x(), design.speeds_mps);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(ffp.cutoff_hz.y()[i], result.points[i].low_pass.frequency_hz, 0.5e-5);
    EXPECT_NEAR(ffp.damping.y()[i], result.points[i].low_pass.damping, 0.5e-3);
    EXPECT_NEAR(ffp.buffer_trim_s.y()[i], result.points[i].trim_s, 0.5e-3);
  }
  EXPECT_THAT(text, Not(HasSubstr("by hand")));
  const DesignCase first = simple_design();
  EXPECT_THAT(designed_ffp_input(text, result_of(first)), Not(HasSubstr("Filter")));
}

// One row per wind speed in the table; curves of each.
TEST(DesignReport, TabulatesEveryWindSpeed) {
  const DesignCase design = simple_design();
  const DesignResult result = result_of(design);
  EXPECT_THAT(design_table(result), HasSubstr("buffer [s]"));
  EXPECT_THAT(design_table(result), HasSubstr("24.5"));
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(lines(schedule_csv(result)), 1 + 3);
  EXPECT_EQ(lines(curves_csv(result)), 1 + 3 * CurveSettings{}.points);
}

// The shipped FFP file as template, whole: every key survives.
TEST(DesignReport, KeepsEveryKeyOfTheShippedFile) {
  const DesignCase design =
      load_design(std::filesystem::path(LAC_SOURCE_DIR) / "config/design/nrel5mw.yaml",
                  {"points=21", "quadrature_nodes=41", "wind_speeds_mps=[12, 16, 20, 24]"});
  const LidarVolumes lidar = lidar_volumes(design.lidar, design.volumes);
  const CorrelationCurves curves(*make_correlation(design, lidar), design.speeds_mps,
                                 design.curves);
  const DesignResult result{design, lidar, curves,
                            design_feedforward(curves, lidar, design.rule, design.timing), 2e-5};
  InputFile before = InputFile::load(design.ffp_template);
  std::ostringstream text;
  text << std::ifstream(design.ffp_template).rdbuf();
  InputFile after = InputFile::parse(designed_ffp_input(text.str(), result), "ffp.IN");
  const FfpParams old_params = FfpParams::read(before), new_params = FfpParams::read(after);
  EXPECT_EQ(new_params.static_pitch_rad.y(), old_params.static_pitch_rad.y());
  EXPECT_EQ(new_params.max_rate_radps, old_params.max_rate_radps);
  EXPECT_NEAR(new_params.cutoff_hz.at(16.0), 0.0490, 0.05 * 0.0490);  // GUO, Mann neutral
}

}  // namespace
}  // namespace lac::sim
