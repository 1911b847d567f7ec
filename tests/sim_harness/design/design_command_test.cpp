// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/design_command.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "feedback/feedback_params.hpp"
#include "ffp/ffp_params.hpp"
#include "support/temp_folder.hpp"

namespace lac::sim {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::filesystem::path kFile =
    std::filesystem::path(LAC_SOURCE_DIR) / "config/design/nrel5mw.yaml";

DesignOptions coarse(const test::TempFolder& folder) {
  return {kFile,
          {"points=21", "quadrature_nodes=61", "wind_speeds_mps=[12, 16, 20, 24]"},
          folder.path() / "out"};
}

// One command from turbulence, rotor and lidar to an input file that FFP reads.
TEST(DesignCommand, WritesWhatTheFeedforwardNeeds) {
  const test::TempFolder folder;
  std::ostringstream out;
  design_command(coarse(folder), out);
  EXPECT_THAT(out.str(), HasSubstr("turbulence: Mann tensor, L 49 m"));
  EXPECT_THAT(out.str(), HasSubstr("quadrature: |G_RL| at the cut-off moves by"));
  InputFile file = InputFile::load(folder.path() / "out/ffp.IN");
  const FfpParams ffp = FfpParams::read(file);
  EXPECT_EQ(ffp.cutoff_hz.x(), (std::vector{12.0, 16.0, 20.0, 24.0}));
  EXPECT_NEAR(ffp.cutoff_hz.at(16.0), 0.0490, 0.05 * 0.0490);  // GUO, Mann neutral
  InputFile feedback = InputFile::load(folder.path() / "out/feedback.IN");
  EXPECT_EQ(FeedbackParams::read(feedback).pitch.gains.proportional_s.x().size(), 4U);
  EXPECT_THAT(out.str(), HasSubstr("standard deviation of the rotor speed, against feedback only"));
  for (const char* name :
       {"schedule.csv", "curves.csv", "closed_loop.csv", "rotor_speed.csv", "design.html"})
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / name)) << name;
}

// The template is not written over: its tuning would be lost.
TEST(DesignCommand, LeavesItsTemplateAlone) {
  const test::TempFolder folder;
  const std::filesystem::path own = folder.path() / "out/ffp.IN";
  std::filesystem::create_directories(own.parent_path());
  std::filesystem::copy_file(LAC_SOURCE_DIR "/config/nrel5mw/ffp.IN", own);
  const auto size = std::filesystem::file_size(own);
  DesignOptions options = coarse(folder);
  options.overrides.push_back("feedforward.template=" + own.string());
  std::ostringstream out;
  EXPECT_THAT([&] { design_command(options, out); },
              ThrowsMessage<Error>(HasSubstr("is the template of the design")));
  EXPECT_EQ(std::filesystem::file_size(own), size);
}

// Runs at a speed without a prediction are named, not dropped.
TEST(DesignCommand, NamesFlownRunsThatItCannotCompare) {
  const test::TempFolder folder;
  DesignOptions options = coarse(folder);
  options.overrides.push_back("wind_speeds_mps=[8, 16, 20]");
  options.overrides.push_back(
      "flown=[{mean_speed_mps: 8, feedback_only: [fb.outb], lidar_assisted: [lac.outb]}]");
  std::ostringstream out;
  design_command(options, out);
  EXPECT_THAT(out.str(), HasSubstr("not compared: the runs flown at 8 m/s"));
}

// An entry that blends has no threshold to be above.
TEST(DesignCommand, HasNoShareAboveAThresholdThatIsNotThere) {
  const test::TempFolder folder;
  std::ifstream given(LAC_SOURCE_DIR "/config/nrel5mw/ffp.IN");
  std::string text;
  for (std::string line; std::getline(given, line);) {
    const bool of_threshold = line.find(" ThresholdSpeed ") != std::string::npos ||
                              line.find(" Hysteresis ") != std::string::npos;
    if (!of_threshold) text += line + "\n";
  }
  DesignOptions options = coarse(folder);
  options.overrides.push_back(
      "feedforward.template=" +
      folder.write("blend.IN", text + "blend ! Entry\n12.0 15.0 ! BlendSpeeds\n"));
  std::ostringstream out;
  design_command(options, out);
  std::istringstream table(folder.read("out/closed_loop.csv"));
  std::string line;
  for (std::getline(table, line); std::getline(table, line);) EXPECT_THAT(line, EndsWith(","));
  EXPECT_THAT(out.str(), HasSubstr(" n/a\n"));
}

// Tables 1 and 2 of Guo et al. (2023) out of their Mann tensor: stable, L_u 101.1 m, a_x 1.6 of the
// 200 s. turbulence_fit_test.cpp has all numbers.
TEST(DesignCommand, FitsAKaimalModel) {
  std::ostringstream out;
  fit_command({kFile, {"turbulence.stability=stable"}, {}}, out);
  EXPECT_THAT(out.str(), HasSubstr("fitted to: Mann tensor, L 30 m"));
  EXPECT_THAT(out.str(), HasSubstr("110."));
  EXPECT_THAT(out.str(), HasSubstr("a_x 1.6"));
  EXPECT_THAT(
      [&] {
        fit_command({kFile, {"turbulence.kind=kaimal"}, {}}, out);
      },
      ThrowsMessage<Error>(HasSubstr("nothing to fit")));
}

// Steps too coarse for a number to be trusted are an error, not a number.
TEST(DesignCommand, RefusesAQuadratureThatHasNotConverged) {
  const test::TempFolder folder;
  DesignOptions options = coarse(folder);
  options.overrides.push_back("quadrature_nodes=11");
  std::ostringstream out;
  EXPECT_THAT([&] { design_command(options, out); },
              ThrowsMessage<Error>(HasSubstr("raise quadrature_nodes")));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

// A folder that cannot be made is said before the long part, not after it.
TEST(DesignCommand, MakesTheFolderFirst) {
  const test::TempFolder folder;
  DesignOptions options = coarse(folder);
  folder.write("file", "");
  options.output_folder = folder.path() / "file/out";
  std::ostringstream out;
  EXPECT_THAT([&] { design_command(options, out); },
              ThrowsMessage<Error>(HasSubstr("cannot be made")));
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace lac::sim
