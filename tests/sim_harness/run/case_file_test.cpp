// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/case_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "sim_harness/run/probe_case.hpp"
#include "sim_harness/wind/iec_wind.hpp"

namespace lac::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;

class CaseFileTest : public ::testing::Test {
 protected:
  std::string error_with(const std::string& from, const std::string& to) {
    try {
      load_case(files_.file(from, to));
    } catch (const Error& e) {
      return e.what();
    }
    return "none";
  }

  test::ProbeCase files_;
};

// Everything that the file says arrives; paths count from the folder of the case.
TEST_F(CaseFileTest, ReadsACase) {
  const Case c = load_case(files_.file());
  EXPECT_EQ(c.name, "case");
  EXPECT_EQ(c.turbine.name, "NREL 5 MW");
  EXPECT_EQ(c.time.steps(), 1600);
  EXPECT_EQ(c.time.run_in_s, 5.0);
  EXPECT_EQ(c.seed, 1U);
  EXPECT_FALSE(c.lidar.has_value());
  ASSERT_EQ(c.controllers.size(), 2U);
  EXPECT_EQ(c.controllers[1].name, "second");
  EXPECT_EQ(c.controllers[0].input_file, files_.folder.path() / "probe.in");
  EXPECT_EQ(c.outputs.folder, files_.folder.path() / "results");
  EXPECT_TRUE(c.outputs.outb && c.outputs.csv && c.outputs.html);
}

// Without outputs.folder results go to results/<name> of where the program runs, without library
// the master beside the program flies.
TEST_F(CaseFileTest, Defaults) {
  EXPECT_EQ(load_case(files_.file("  folder: results\n", "  csv: no\n")).outputs.folder,
            fs::path("results") / "case");
  const Case c = load_case(files_.file("    library: " LAC_TOY_DIR "/libtoy_recorder\n", ""));
  EXPECT_EQ(c.controllers[0].library, "");
}

// Overrides reach every value.
TEST_F(CaseFileTest, Overrides) {
  const Case c = load_case(files_.file(), {"wind.speed_mps=12", "seed=7", "time.duration_s=30",
                                           "controllers.1.name=other"});
  EXPECT_EQ(std::get<SteadySpeed>(std::get<UniformWindParams>(c.wind.source).history).speed_mps,
            12.0);
  EXPECT_EQ(c.seed, 7U);
  EXPECT_EQ(c.time.duration_s, 30.0);
  EXPECT_EQ(c.controllers[1].name, "other");
}

// Faults, each with its place and what was meant.
TEST_F(CaseFileTest, Faults) {
  EXPECT_THAT(error_with("speed_mps: 18", "speed_mps: fast"),
              EndsWith("case.yaml:7: wind.speed_mps: found 'fast', expected a number"));
  EXPECT_THAT(error_with("speed_mps: 18", "sped_mps: 18"),
              EndsWith(":6: wind.speed_mps: the key is missing; is 'sped_mps' meant to be it?"));
  EXPECT_THAT(
      error_with("kind: steady", "kind: stormy"),
      HasSubstr(
          ":6: wind.kind: found 'stormy', expected steady, step, eog, edc, ecd, ews, kaimal"));
  EXPECT_THAT(error_with("run_in_s: 5", "run_in_s: 20"),
              EndsWith(":4: time.run_in_s: expected a time before duration_s, by two steps at "
                       "least"));
  EXPECT_THAT(error_with("run_in_s: 5", "run_in_s: 19.98"), HasSubstr("by two steps at least"));
  EXPECT_THAT(error_with("duration_s: 20", "duration_s: 1e12"), HasSubstr(":3: time.duration_s"));
  EXPECT_THAT(error_with("other.in", "gone.in"),
              EndsWith(":12: controllers.1.input: " + files_.folder.file("gone.in") +
                       " cannot be read: no such file"));
  EXPECT_THAT(error_with("duration_s: 20", "duration_s: 20.001"),
              EndsWith(":3: time.duration_s: expected a multiple of step_s"));
  EXPECT_THAT(error_with("name: second", "name: first"),
              HasSubstr(":12: controllers.1.name: found 'first' twice"));
  EXPECT_THAT(error_with("name: second", "name: a/b"), HasSubstr("letters, digits"));
  EXPECT_THAT(error_with("outputs:", "output:"),
              EndsWith(":13: output: unknown key (did you mean 'outputs'?)"));
  EXPECT_THAT(error_with("wind:", "winds:"),
              HasSubstr("wind: the key is missing; is 'winds' meant to be it?"));
  EXPECT_THAT(error_with("turbine.yaml", "turbin.yaml"),
              HasSubstr("case.yaml:1: turbine: " LAC_SOURCE_DIR "/config/turbines/nrel5mw/turbin"));
}

WindSource wind_of(test::ProbeCase& files, const std::string& keys) {
  return load_case(files.file("  kind: steady\n  speed_mps: 18\n", keys)).wind.source;
}

// The kinds of wind; IEC values come from the class, V_gust and sigma as in the standard.
TEST_F(CaseFileTest, KindsOfWind) {
  const auto step = std::get<UniformWindParams>(
      wind_of(files_, "  {kind: step, from_mps: 10, to_mps: 12, time_s: 8, ramp_s: 2}\n"));
  EXPECT_EQ(std::get<StepSpeed>(step.history).ramp_s, 2.0);
  const auto gust = std::get<UniformWindParams>(
      wind_of(files_, "  {kind: eog, mean_speed_mps: 18, start_s: 8, wind_class: II}\n"));
  EXPECT_DOUBLE_EQ(std::get<GustSpeed>(gust.history).magnitude_mps,
                   eog_magnitude_mps({WindClass::kII, TurbulenceCategory::kA}, 18.0, 90.0, 126.0));
  const auto kaimal = std::get<KaimalWind>(
      wind_of(files_, "  {kind: kaimal, mean_speed_mps: 18, turbulence_category: B}\n"));
  EXPECT_NEAR(kaimal.field.model.u.sigma_mps, 0.14 * (0.75 * 18.0 + 5.6), 1e-12);
  EXPECT_EQ(kaimal.field.seed, 1U);
  files_.folder.write("b.bts", "");
  const auto bts = std::get<FieldFile>(wind_of(files_, "  {kind: bts, file: b.bts}\n"));
  EXPECT_EQ(bts.file, files_.folder.path() / "b.bts");
  EXPECT_EQ(describe(WindCase{kaimal}),
            "Kaimal turbulence, 18 m/s, sigma 2.674, 2.139, 1.337 m/s, L 340.2, 113.4, 27.72 m, "
            "coherence 12, 340.2 m (right to 1e-07), v and w independent, 27 x 27 points, seed 1");
}

// A lidar from a file of its own or written out, with a fault.
TEST_F(CaseFileTest, Lidar) {
  const auto lidar = [&](const std::string& keys) {
    return load_case(files_.file("outputs:", "lidar:" + keys + "\noutputs:")).lidar;
  };
  const auto from_file = lidar(
      " {file: " LAC_SOURCE_DIR
      "/config/lidars/four_beam_pulsed.yaml, fault: {kind: stuck, start_s: 200, end_s: 250}}");
  EXPECT_EQ(from_file->params.scan.beams.size(), 4U);
  EXPECT_EQ(from_file->fault.kind, LidarFaultKind::kStuck);
  EXPECT_EQ(from_file->fault.end_s, 250.0);
  const auto written = lidar(
      " {beam_azimuth_deg: [0], beam_elevation_deg: [0], gates_m: [80], gates_along: beam, "
      "beam_time_s: 1, fwhm_m: 0}");
  EXPECT_EQ(written->params.gates_m.size(), 1U);
  EXPECT_EQ(written->fault.kind, LidarFaultKind::kNone);
  const auto afloat = lidar(" {file: " LAC_SOURCE_DIR
                            "/config/lidars/four_beam_pulsed.yaml, platform: {surge: {mean: 2}}}");
  EXPECT_EQ(afloat->params.platform.freedoms[kSurge].mean, 2.0);
  EXPECT_TRUE(from_file->params.platform.is_still());
  EXPECT_THAT(
      error_with("outputs:", "lidar: {file: none.yaml}\noutputs:"),
      HasSubstr("case.yaml:13: lidar.file: " + files_.folder.file("none.yaml") + " cannot"));
}

// A generated grid must cover the rotor that is flown in it.
TEST_F(CaseFileTest, GridCoversTheRotor) {
  const auto error = [&](const std::string& key) {
    return error_with("  kind: steady\n  speed_mps: 18\n",
                      "  kind: kaimal\n  mean_speed_mps: 18\n  " + key + "\n");
  };
  EXPECT_THAT(
      error("width_m: 125"),
      EndsWith("case.yaml:8: wind.width_m: found 125, expected at least the rotor's diameter "
               "of 126 m"));
  EXPECT_THAT(error("height_m: 100"), HasSubstr("case.yaml:8: wind.height_m: found 100"));
  EXPECT_EQ(error("width_m: 126"), "none");
}

// What a lidar cannot do in any wind is said with its place when the case is read.
TEST_F(CaseFileTest, LidarThatCannotMeasure) {
  const auto error = [&](const std::string& keys) {
    return error_with("outputs:",
                      "lidar: {beam_azimuth_deg: [0, 10], beam_elevation_deg: [0, 0], "
                      "gates_along: beam, fwhm_m: 0, " +
                          keys + "}\noutputs:");
  };
  const std::string good = "gates_m: [80], beam_time_s: 1";
  EXPECT_EQ(error(good), "none");
  EXPECT_THAT(
      error("gates_m: [80], beam_time_s: 0.01"),
      HasSubstr("case.yaml:13: lidar: beam 1: beam_time_s = 0.01 is shorter than the control "
                "step"));
  EXPECT_THAT(error(good + ", offset_m: [90, 0, 0]"),
              HasSubstr("case.yaml:13: lidar: beam 1, gate"));
  EXPECT_THAT(error(good + ", weaknesses: {hard_targets: [{distance_m: 80, beam: 3}]}"),
              HasSubstr("case.yaml:13: lidar: weaknesses: hard_targets: beam = 3"));
  EXPECT_THAT(error("gates_m: [80], beam_time_s: 40"),
              HasSubstr("case.yaml:13: lidar: the first measurement is complete after"));
}

// The anemometer stands in the undisturbed wind unless the case says otherwise.
TEST_F(CaseFileTest, Anemometer) {
  EXPECT_FALSE(load_case(files_.file()).anemometer.disturbed());
  const Case c = load_case(files_.file(), {"anemometer={induction_share: 0.7, time_scale_s: 1}"});
  EXPECT_EQ(c.anemometer.induction_share, 0.7);
  EXPECT_EQ(c.anemometer.time_scale_s, 1.0);
  EXPECT_THAT(error_with("wind:", "anemometer: {added_intensity: 2}\nwind:"),
              HasSubstr("anemometer.added_intensity"));
}

// The window of the turbulence intensity is no longer than the case.
TEST_F(CaseFileTest, WindWindow) {
  EXPECT_EQ(load_case(files_.file()).outputs.wind_window_s, 20.0);
  EXPECT_EQ(load_case(files_.file(), {"time.duration_s=700"}).outputs.wind_window_s, 600.0);
  EXPECT_THAT(error_with("folder: results", "wind_window_s: 30"),
              HasSubstr("outputs.wind_window_s: found 30, expected at most time.duration_s = 20"));
}

}  // namespace
}  // namespace lac::sim
