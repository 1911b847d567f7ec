// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/ti_estimator_params.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "support/error_text.hpp"

namespace lac {
namespace {

const std::string kMinimal =
    "2 ! NumberOfBeams - x\n"
    "15 -15 ! BeamAzimuth - x\n"
    "0 0 ! BeamElevation - x\n"
    "1.0 ! ScanTime - x\n"
    "90 ! HubHeight - x\n";

TiEstimatorParams parse(const std::string& text) {
  InputFile in = InputFile::parse(text, "ti.IN");
  return TiEstimatorParams::read(in);
}
std::string error_of(const std::string& text) {
  return test::error_text([&] { parse(text); });
}

// The shipped input file loads and says what its comments say.
TEST(TiEstimatorParams, ShippedFile) {
  const std::filesystem::path file = LAC_SOURCE_DIR "/config/nrel5mw/ti_estimator.IN";
  InputFile in = InputFile::load(file);
  const TiEstimatorParams p = TiEstimatorParams::read(in);
  EXPECT_EQ(p.reader.number_of_beams, 4);
  EXPECT_EQ(p.beam_dir_L.size(), 4U);
  EXPECT_EQ(p.averaging_time_s, 180.0);
  EXPECT_EQ(p.correction.averaging_time_s, 180.0);
  EXPECT_EQ(p.correction.scan_rate_hz, 1.0);
  EXPECT_DOUBLE_EQ(p.correction.model.u.length_scale_m, 8.1 * 42.0);
  EXPECT_EQ(p.power_level.zero_intensity.at(16.0), 0.32);
  EXPECT_EQ(p.table_yaw_errors_rad.size(), 1U);
}

// Five keys have no default, everything else has.
TEST(TiEstimatorParams, MinimalFile) {
  const TiEstimatorParams p = parse(kMinimal);
  EXPECT_EQ(p.averaging_time_s, 180.0);
  EXPECT_EQ(p.number_of_gates, 10);
  EXPECT_EQ(p.correction.pulse_width_m, 30.0);
}

// With UseYawError the table has a second axis, in radians.
TEST(TiEstimatorParams, YawAxis) {
  const TiEstimatorParams p =
      parse(kMinimal + "true ! UseYawError - x\n-20 0 20 ! TableYawErrors - x\n");
  ASSERT_EQ(p.table_yaw_errors_rad.size(), 3U);
  EXPECT_DOUBLE_EQ(p.table_yaw_errors_rad[2], rad_from_deg(20.0));
}

// The Guo layout brings its gates from its own key.
TEST(TiEstimatorParams, GuoLayout) {
  const TiEstimatorParams p = parse(kMinimal +
                                    "guo ! LidarLayout - x\n50 80 120 ! GateRanges - x\n"
                                    "0 0 90 ! LidarPosition - x\n");
  EXPECT_EQ(p.number_of_gates, 3);
  EXPECT_EQ(p.beam_dir_L, p.reader.guo.beam_dir_L);
}

// Intensities over wind speed, and the options of window, volume and deadband.
TEST(TiEstimatorParams, Options) {
  const TiEstimatorParams p = parse(
      kMinimal +
      "12 16 20 ! TIWindSpeeds - x\n0.2 0.16 0.15 ! TIRated - x\n0.4 0.32 0.3 ! TI0 - x\n"
      "0.02 ! PowerLevelDeadband - x\nexponential ! Window - x\nresponse ! LowFrequencies - x\n"
      "three_point ! VolumeModel - x\ntrue ! Aliasing - x\n");
  EXPECT_DOUBLE_EQ(p.power_level.rated_intensity.at(14.0), 0.18);
  EXPECT_DOUBLE_EQ(p.power_level.zero_intensity.at(18.0), 0.31);
  EXPECT_EQ(p.power_level.deadband, 0.02);
  EXPECT_EQ(p.statistics().window, Window::Exponential);
  EXPECT_EQ(p.correction.volume_model, VolumeModel::ThreePoint);
  EXPECT_TRUE(p.correction.aliasing);
}

// Mann's parameters are those of IEC for the hub height unless given.
TEST(TiEstimatorParams, Mann) {
  const TiEstimatorParams iec = parse(kMinimal + "mann ! Spectra - x\n");
  EXPECT_EQ(iec.correction.spectra, Spectra::Mann);
  EXPECT_DOUBLE_EQ(iec.correction.mann.length_m, 33.6);
  EXPECT_EQ(iec.correction.mann.gamma, 3.9);
  const TiEstimatorParams own =
      parse(kMinimal + "mann ! Spectra - x\n49 ! MannLength - x\n3.1 ! MannAnisotropy - x\n");
  EXPECT_EQ(own.correction.mann.length_m, 49.0);
  EXPECT_EQ(own.correction.mann.gamma, 3.1);
}

// Competitors, what drives the power level, and what comes from LDP; all off by default.
TEST(TiEstimatorParams, Competitors) {
  const TiEstimatorParams plain = parse(kMinimal);
  EXPECT_FALSE(plain.uncorrected || plain.anemometer.used || plain.turbine.used);
  EXPECT_FALSE(plain.yaw_error_of_ldp || plain.mean_speed_of_ldp);
  const TiEstimatorParams p = parse(
      kMinimal +
      "true ! EstimateUncorrected - x\ntrue ! EstimateAnemometer - x\ntrue ! EstimateTurbine - x\n"
      "0.1 ! AnemometerAddedIntensity - x\n1.1 ! AnemometerSpeedFactor - x\n65 ! RotorRadius - x\n"
      "0.5 ! TurbineCutOff - x\nturbine ! PowerLevelSource - x\ntrue ! UseYawError - x\n"
      "ldp ! YawErrorSource - x\nldp ! MeanSpeedSource - x\n240 ! AveragingTime - x\n");
  EXPECT_TRUE(p.uncorrected && p.anemometer.used && p.turbine.used);
  EXPECT_EQ(p.anemometer.statistics.window_s, 240.0);
  EXPECT_EQ(p.anemometer.statistics.beams, 1);
  EXPECT_EQ(p.turbine_cutoff_hz, 0.5);
  EXPECT_EQ(p.power_level_source, IntensitySource::Turbine);
  EXPECT_TRUE(p.yaw_error_of_ldp && p.mean_speed_of_ldp);
}

// Mistakes are refused with the key and what was expected.
TEST(TiEstimatorParams, Mistakes) {
  const auto expect = [](const std::string& line, const std::string& key, const std::string& text) {
    const std::string error = error_of(kMinimal + line);
    EXPECT_NE(error.find("ti.IN"), std::string::npos) << error;
    EXPECT_NE(error.find(key), std::string::npos) << error;
    EXPECT_NE(error.find(text), std::string::npos) << error;
  };
  expect("30 ! AveragingTime - x\n", "AveragingTime", "60");
  expect("0.15 ! TI0 - x\n", "TI0", "more than TIRated");
  expect("5 5 ! TableWindSpeeds - x\n", "TableWindSpeeds", "rising");
  expect("5 ! TableWindSpeeds - x\n", "TableWindSpeeds", "two or more");
  expect("0.001 ! MaximumFrequency - x\n", "MaximumFrequency", "1/AveragingTime");
  expect("12 16 ! TIWindSpeeds - x\n", "TIRated", "missing");
  expect("12 16 ! TIWindSpeeds - x\n0.2 0.2 ! TIRated - x\n0.3 0.1 ! TI0 - x\n", "TI0",
         "more than TIRated");
  expect("linear ! Detrending - x\n", "LowFrequencies", "write response");
  expect("linear ! Detrending - x\nexponential ! Window - x\n", "Detrending", "sliding window");
  expect("phase ! VolumeModel - x\nindependent ! LateralCoherence - x\n", "LateralCoherence",
         "contradicts");
  expect("40 ! MannLength - x\n", "MannLength", "without Spectra mann");
  expect("mann ! Spectra - x\nphase ! VolumeModel - x\n", "VolumeModel", "full");
  expect("mann ! Spectra - x\nsame_as_u ! LateralCoherence - x\n", "LateralCoherence", "kaimal");
  expect("mann ! Spectra - x\ntrue ! EstimateTurbine - x\n65 ! RotorRadius - x\n",
         "EstimateTurbine", "kaimal");
  expect("1 2 ! GateWeights - x\n", "GateWeights", "NumberOfGates");
  expect("0 ! PowerLevelRate - x\n", "PowerLevelRate", "found");
  expect("true ! UseYawErorr - x\n", "UseYawErorr", "UseYawError");
  expect("ldp ! YawErrorSource - x\n", "YawErrorSource", "without UseYawError");
  expect("anemometer ! PowerLevelSource - x\n", "PowerLevelSource", "EstimateAnemometer");
  expect("true ! EstimateTurbine - x\n", "RotorRadius", "missing");
}

// A beam across the wind cannot give a wind speed, nor can a window of a handful of samples or of
// more than the sums hold.
TEST(TiEstimatorParams, ImpossibleCombinations) {
  const auto with = [](const std::string& azimuth, const std::string& scan_time,
                       const std::string& more) {
    return "2 ! NumberOfBeams - x\n" + azimuth +
           " ! BeamAzimuth - x\n0 0 ! BeamElevation - x\n90 ! HubHeight - x\n" + scan_time +
           " ! ScanTime - x\n" + more;
  };
  EXPECT_NE(error_of(with("15 89", "1", "")).find("across the wind"), std::string::npos);
  EXPECT_NE(error_of(with("15 70", "1", "true ! UseYawError - x\n")).find("across the wind"),
            std::string::npos);
  EXPECT_NE(error_of(with("15 -15", "20", "60 ! AveragingTime - x\n")).find("samples per volume"),
            std::string::npos);
  EXPECT_NE(
      error_of(with("15 -15", "0.1", "3600 ! AveragingTime - x\n")).find("samples per volume"),
      std::string::npos);
}

}  // namespace
}  // namespace lac
