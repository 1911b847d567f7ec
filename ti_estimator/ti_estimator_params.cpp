// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/ti_estimator_params.hpp"

#include <array>

#include "core/units.hpp"

namespace lac {
namespace {

void read_beams(InputFile& in, TiEstimatorParams& p) {
  const auto beams = static_cast<std::size_t>(p.reader.number_of_beams);
  const auto azimuth = in.numbers("BeamAzimuth", beams, "NumberOfBeams", Range::between(-90, 90));
  const auto elevation =
      in.numbers("BeamElevation", beams, "NumberOfBeams", Range::between(-90, 90));
  for (std::size_t i = 0; i < beams; ++i) {
    p.beam_dir_L.push_back(beam_direction(rad_from_deg(azimuth[i]), rad_from_deg(elevation[i])));
  }
}

void read_lidar(InputFile& in, TiEstimatorParams& p) {
  p.reader = LidarReaderParams::read(in);
  if (p.reader.layout == LidarLayout::OpenFast) {  // one beam along x of frame I
    p.beam_dir_L = {{1.0, 0.0, 0.0}};
    p.number_of_gates = openfast_lidar::kMaxPoints;
  } else {
    read_beams(in, p);
  }
  if (p.reader.layout == LidarLayout::Guo) {
    p.number_of_gates = static_cast<int>(p.reader.guo.gate_range_m.size());
  } else if (p.reader.layout == LidarLayout::Native) {
    p.number_of_gates =
        in.integer("NumberOfGates", p.number_of_gates, Range::between(1, native_lidar::kMaxGates));
  }
  if (in.has("GateWeights")) {
    p.gate_weights = in.numbers("GateWeights", static_cast<std::size_t>(p.number_of_gates),
                                "NumberOfGates", Range::positive());
  }
  p.scan_time_s = p.reader.read_scan_time(in, Range::between(0.05, 30.0));
  p.motion_compensation = in.flag("MotionCompensation", p.motion_compensation);
}

void read_statistics(InputFile& in, TiEstimatorParams& p) {
  p.averaging_time_s = in.number("AveragingTime", p.averaging_time_s, Range::between(60.0, 3600.0));
  p.minimum_fill = in.number("MinimumFill", p.minimum_fill, Range::between(0.1, 1.0));
  const double expected_samples = p.statistics().expected_samples();
  if (expected_samples < kFewestSamples || expected_samples > kMostSamples) {
    in.fail("AveragingTime", "AveragingTime over ScanTime is " + std::to_string(expected_samples) +
                                 " samples per volume, expected " + std::to_string(kFewestSamples) +
                                 " to " + std::to_string(kMostSamples));
  }
}

void read_window(InputFile& in, CorrectionParams& c) {
  c.window = static_cast<Window>(in.choice("Window", 0, {"sliding", "exponential"}));
  c.detrending = static_cast<Detrending>(in.choice("Detrending", 0, {"mean", "linear"}));
  c.low_frequencies =
      static_cast<LowFrequencies>(in.choice("LowFrequencies", 0, {"cutoff", "response"}));
  if (c.detrending == Detrending::Linear && c.window == Window::Exponential) {
    in.fail("Detrending", "linear is for the sliding window only");
  }
  const bool plain = c.detrending == Detrending::Mean && c.window == Window::Sliding;
  if (!plain && c.low_frequencies == LowFrequencies::Cutoff) {
    in.fail("LowFrequencies",
            "a sharp cutoff at 1/AveragingTime is for the sliding window without its mean alone; "
            "write response");
  }
}

void read_volume(InputFile& in, CorrectionParams& c) {
  c.pulse_width_m = in.number("PulseWidth", c.pulse_width_m, Range::between(0.0, 500.0));
  c.volume_model =
      static_cast<VolumeModel>(in.choice("VolumeModel", 0, {"full", "phase", "three_point"}));
  c.lateral_coherence =
      static_cast<LateralCoherence>(in.choice("LateralCoherence", 0, {"same_as_u", "independent"}));
  if (c.volume_model == VolumeModel::Phase &&
      c.lateral_coherence == LateralCoherence::Independent) {
    in.fail("LateralCoherence",
            "independent contradicts VolumeModel phase, in which all points across the wind are "
            "alike");
  }
}

/// Behind read_volume().
void read_spectra(InputFile& in, CorrectionParams& c) {
  c.spectra = static_cast<Spectra>(in.choice("Spectra", 0, {"kaimal", "mann"}));
  c.mann.length_m = in.number("MannLength", c.mann.length_m, {1.0, 1000.0});
  c.mann.gamma = in.number("MannAnisotropy", c.mann.gamma, {0.0, 6.0});
  if (c.spectra == Spectra::Kaimal) {
    for (const char* key : {"MannLength", "MannAnisotropy"})
      if (in.has(key)) in.fail(key, "is not used without Spectra mann");
    return;
  }
  if (c.volume_model != VolumeModel::Full)
    in.fail("VolumeModel", "only full goes with Spectra mann");
  if (in.has("LateralCoherence"))
    in.fail("LateralCoherence", "belongs to Spectra kaimal: Mann's tensor has its own");
}

void read_correction(InputFile& in, TiEstimatorParams& p) {
  CorrectionParams& c = p.correction;
  const double hub_height_m = in.number("HubHeight", {0.0, 500.0, false});
  c.model = iec_kaimal(1.0, hub_height_m);
  c.mann = iec_mann(hub_height_m);
  c.averaging_time_s = p.averaging_time_s;
  c.scan_rate_hz = 1.0 / p.scan_time_s;
  c.max_frequency_hz = in.number("MaximumFrequency", c.max_frequency_hz, {0.0, 1000.0, false});
  c.aliasing = in.flag("Aliasing", c.aliasing);
  read_volume(in, c);
  read_spectra(in, c);
  read_window(in, c);
  if (c.max_frequency_hz * p.averaging_time_s <= 1.0) {
    in.fail("MaximumFrequency", "not above 1/AveragingTime");
  }
}

void read_axis(InputFile& in, const std::string& key, Range range, std::vector<double>& axis) {
  if (!in.has(key)) return;
  axis = in.numbers(key, range);
  if (axis.size() < 2) in.fail(key, "found one value, expected two or more");
  for (std::size_t i = 1; i < axis.size(); ++i) {
    if (axis[i] <= axis[i - 1]) {
      in.fail(key, "value " + std::to_string(i + 1) + " (" + std::to_string(axis[i]) +
                       ") is not above the one before it, expected rising values");
    }
  }
}

void read_table_axes(InputFile& in, TiEstimatorParams& p) {
  read_axis(in, "TableWindSpeeds", {0.5, 100.0}, p.table_speeds_mps);
  p.use_yaw_error = in.flag("UseYawError", p.use_yaw_error);
  p.yaw_error_of_ldp = in.choice("YawErrorSource", 0, {"record24", "ldp"}) == 1;
  p.mean_speed_of_ldp = in.choice("MeanSpeedSource", 0, {"window", "ldp"}) == 1;
  if (p.yaw_error_of_ldp && !p.use_yaw_error) {
    in.fail("YawErrorSource", "found ldp without UseYawError true, by which it would be used");
  }
  if (p.use_yaw_error && p.reader.layout == LidarLayout::OpenFast) {
    in.fail("UseYawError",
            "not with LidarLayout openfast: that lidar does not turn with the nacelle, from which "
            "record 24 counts; leave it out");
  }
  std::vector<double> yaw_deg{-30, -25, -20, -15, -10, -5, 0, 5, 10, 15, 20, 25, 30};
  read_axis(in, "TableYawErrors", Range::between(-60, 60), yaw_deg);
  if (p.use_yaw_error) {
    p.table_yaw_errors_rad.clear();
    for (const double deg : yaw_deg) p.table_yaw_errors_rad.push_back(rad_from_deg(deg));
  }
  for (std::size_t i = 0; i < p.beam_dir_L.size(); ++i) {
    for (const double yaw : p.table_yaw_errors_rad) {
      if (beam_in_wind(p.beam_dir_L[i], yaw).x >= kSmallestProjection) continue;
      in.fail("BeamAzimuth", "beam " + std::to_string(i + 1) + " lies almost across the wind at " +
                                 std::to_string(deg_from_rad(yaw)) +
                                 " deg yaw error and cannot measure it");
    }
  }
}

/// TIRated and TI0, each one number, or one per value of TIWindSpeeds.
void read_intensities(InputFile& in, PowerLevelParams& g) {
  std::vector<double> speeds_mps{0.0};
  std::vector<double> rated{g.rated_intensity.y().front()}, zero{g.zero_intensity.y().front()};
  if (in.has("TIWindSpeeds")) {
    read_axis(in, "TIWindSpeeds", {0.5, 100.0}, speeds_mps);
    rated = in.numbers("TIRated", speeds_mps.size(), "TIWindSpeeds", Range::positive());
    zero = in.numbers("TI0", speeds_mps.size(), "TIWindSpeeds", Range::positive());
  } else {
    rated = {in.number("TIRated", rated.front(), Range::positive())};
    zero = {in.number("TI0", zero.front(), Range::positive())};
  }
  for (std::size_t i = 0; i < zero.size(); ++i) {
    if (zero[i] > rated[i]) continue;
    in.fail("TI0", "found " + std::to_string(zero[i]) + ", expected more than TIRated (" +
                       std::to_string(rated[i]) + "): more turbulence, less power");
  }
  g.rated_intensity = LookupTable(speeds_mps, rated);
  g.zero_intensity = LookupTable(speeds_mps, zero);
}

SignalIntensityParams read_signal(InputFile& in, const char* key, const TiEstimatorParams& p) {
  SignalIntensityParams s;
  s.used = in.flag(key, false);
  s.statistics = p.statistics();
  s.statistics.beams = s.statistics.gates = 1;
  s.statistics.scan_time_s = kSignalInterval_s;
  return s;
}

void read_other_estimates(InputFile& in, TiEstimatorParams& p) {
  p.uncorrected = in.flag("EstimateUncorrected", p.uncorrected);
  p.anemometer = read_signal(in, "EstimateAnemometer", p);
  p.anemometer.speed_factor =
      in.number("AnemometerSpeedFactor", p.anemometer.speed_factor, Range::between(0.5, 2.0));
  p.anemometer.added_intensity =
      in.number("AnemometerAddedIntensity", p.anemometer.added_intensity, Range::between(0.0, 1.0));
  p.turbine = read_signal(in, "EstimateTurbine", p);
  if (p.turbine.used || in.has("RotorRadius"))
    p.rotor_radius_m = in.number("RotorRadius", Range::positive());
  if (p.turbine.used && p.correction.spectra == Spectra::Mann)
    in.fail("EstimateTurbine", "its correction is that of Spectra kaimal");
  p.turbine_cutoff_hz = in.number("TurbineCutOff", p.turbine_cutoff_hz, Range::positive());
}

void read_power_level(InputFile& in, TiEstimatorParams& p) {
  PowerLevelParams& g = p.power_level;
  p.power_level_source = static_cast<IntensitySource>(
      in.choice("PowerLevelSource", 0, {"lidar", "uncorrected", "anemometer", "turbine"}));
  if (!p.has(p.power_level_source)) {
    in.fail("PowerLevelSource",
            "this estimate is not made; ask for it by EstimateUncorrected, EstimateAnemometer or "
            "EstimateTurbine");
  }
  read_intensities(in, g);
  g.maximum = in.number("MaximumPowerLevel", g.maximum, {0.0, 2.0, false});
  g.rate_1ps = in.number("PowerLevelRate", g.rate_1ps, Range::positive());
  g.deadband = in.number("PowerLevelDeadband", g.deadband, Range::between(0.0, 0.5));
}

}  // namespace

StatisticsSpec TiEstimatorParams::statistics() const {
  StatisticsSpec spec;
  spec.window = correction.window;
  spec.detrending = correction.detrending;
  spec.window_s = averaging_time_s;
  spec.scan_time_s = scan_time_s;
  spec.minimum_fill = minimum_fill;
  spec.beams = static_cast<int>(beam_dir_L.size());
  spec.gates = number_of_gates;
  return spec;
}

bool TiEstimatorParams::has(IntensitySource source) const {
  return std::array{true, uncorrected, anemometer.used,
                    turbine.used}[static_cast<std::size_t>(source)];
}

TiEstimatorParams TiEstimatorParams::read(InputFile& in) {
  TiEstimatorParams p;
  read_lidar(in, p);
  read_statistics(in, p);
  read_correction(in, p);
  read_table_axes(in, p);
  read_other_estimates(in, p);
  read_power_level(in, p);
  in.finish();
  return p;
}

}  // namespace lac
