// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/rotor_speed_prediction.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "feedback/feedback.hpp"
#include "ffp/ffp.hpp"
#include "sim_harness/turbine/simulated_turbine.hpp"

namespace lac::sim {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kStep_s = 0.0125;
constexpr double kWind_mps = 18.0;
const std::filesystem::path kConfig = std::filesystem::path(LAC_SOURCE_DIR) / "config";

TurbineParams nrel5mw() {
  return load_turbine(kConfig / "turbines/nrel5mw/turbine.yaml");
}

template <class Params>
Params params_in(const char* file_name) {
  InputFile file = InputFile::load(kConfig / "nrel5mw" / file_name);
  return Params::read(file);
}

double slope_radspm(const FfpParams& ffp) {
  return 0.5 *
         (ffp.static_pitch_rad.at(kWind_mps + 1.0) - ffp.static_pitch_rad.at(kWind_mps - 1.0));
}

/// The wind is a sine; the lidar sees it `lead_s` ahead through a window of 1 s.
struct Sine {
  double frequency_hz;
  double amplitude_mps = 0.3;
  double at(double time_s) const {
    return kWind_mps + amplitude_mps * std::sin(radps_from_hz(frequency_hz) * time_s);
  }
  double in_window(double time_s) const {
    const double x = kPi * frequency_hz;
    return kWind_mps + (at(time_s - 0.5) - kWind_mps) * std::sin(x) / x;
  }
};

/// Rotor speed per wind as flown: the turbine, the controllers, time steps and all.
std::complex<double> flown(double frequency_hz, bool assisted,
                           const FfpParams& ffp_params = params_in<FfpParams>("ffp.IN")) {
  constexpr double kLead_s = 6.0, kSettle_s = 150.0;
  const Sine wind{frequency_hz};
  const Ffp ffp(ffp_params, kStep_s);
  Ffp::State ffp_state = ffp.initial_state();
  const Feedback feedback(params_in<FeedbackParams>("feedback_lac.IN"), kStep_s);
  Feedback::State state;
  Feedback::Events events;
  SimulatedTurbine turbine(nrel5mw());
  turbine.start(steady_state(turbine.params(), kWind_mps));
  const auto per_period = static_cast<int>(std::lround(1.0 / (frequency_hz * kStep_s)));
  const int settle = static_cast<int>(kSettle_s / kStep_s), last = settle + 2 * per_period;
  std::complex<double> sum = 0.0;
  for (int n = 0; n < last; ++n) {
    const double t_s = n * kStep_s;
    const SlowOutputs now = turbine.outputs();
    if (n >= settle)
      sum += now.rotor_speed_radps * std::polar(1.0, -radps_from_hz(frequency_hz) * t_s);
    const auto forward =
        ffp.step({wind.in_window(t_s + kLead_s), true, kLead_s, 1.0, kWind_mps}, ffp_state);
    const auto demand =
        feedback.step({now.generator_speed_radps, now.pitch_rad, now.generator_torque_Nm,
                       assisted ? forward.rate_radps : 0.0},
                      state, events);
    turbine.advance(kStep_s, {wind.at(t_s), (wind.at(t_s + kStep_s) - wind.at(t_s)) / kStep_s,
                              demand.pitch_rad, demand.torque_Nm});
  }
  // A sine is (e^(iwt) - e^(-iwt))/(2i).
  return sum / static_cast<double>(per_period) * std::complex<double>(0.0, 1.0) /
         wind.amplitude_mps;
}

/// Lidar and rotor see the same, the lidar `late_s` late.
CorrelationCurve same_wind(std::vector<double> frequency_hz, double late_s = 0.0) {
  CorrelationCurve c;
  c.mean_speed_mps = kWind_mps;
  for (const double f : frequency_hz) {
    c.k1_radpm.push_back(radps_from_hz(f) / kWind_mps);
    c.s_rr.push_back(1.0), c.s_ll.push_back(1.0);
    c.s_rl.push_back(std::polar(1.0, radps_from_hz(f) * late_s));
  }
  return c;
}

RotorSpeedPrediction prediction(const CorrelationCurve& curve) {
  const LinearTurbine turbine(nrel5mw(), params_in<FeedbackParams>("feedback_lac.IN"), kWind_mps);
  return {turbine, curve, {}, slope_radspm(params_in<FfpParams>("ffp.IN")), 1.0, 1.0};
}

// The turbine with its controller in a small sine of wind: amplitude and phase of the rotor speed.
TEST(RotorSpeedPrediction, IsWhatTheControllerFliesInASine) {
  const LinearTurbine turbine(nrel5mw(), params_in<FeedbackParams>("feedback_lac.IN"), kWind_mps);
  for (const double f_hz : {0.02, 0.05, 0.1, 0.2}) {
    const std::complex<double> model = turbine.rotor_speed(f_hz).per_wind;
    EXPECT_LT(std::abs(flown(f_hz, false) - model), 0.06 * std::abs(model)) << f_hz;
  }
}

// The same with the feedforward, in time, a second late and a second early.
TEST(RotorSpeedPrediction, KnowsTheFeedforward) {
  const std::vector<double> f_hz{0.02, 0.05, 0.1};
  const RotorSpeedPrediction p = prediction(same_wind(f_hz));
  const std::vector<double> alone = p.feedback_only();
  const double cutoff_hz = params_in<FfpParams>("ffp.IN").cutoff_hz.at(kWind_mps);
  for (const double trim_s : {0.0, 1.0, -1.0}) {
    const std::vector<double> with = p.assisted({{1, cutoff_hz, 0.0}, trim_s});
    FfpParams trimmed = params_in<FfpParams>("ffp.IN");
    trimmed.buffer_trim_s = LookupTable({0.0}, {trim_s});
    for (std::size_t i = 0; i < f_hz.size(); ++i) {
      EXPECT_NEAR(std::abs(flown(f_hz[i], true, trimmed)), std::sqrt(with[i]),
                  0.07 * std::sqrt(alone[i]))
          << f_hz[i] << " Hz, trim " << trim_s;
    }
  }
}

// And with a low-pass of second order.
TEST(RotorSpeedPrediction, KnowsASecondOrderLowPass) {
  const std::vector<double> f_hz{0.03, 0.08};
  const RotorSpeedPrediction p = prediction(same_wind(f_hz));
  const std::vector<double> alone = p.feedback_only();
  const std::vector<double> with = p.assisted({{2, 0.09, 0.8}, 0.0});
  FfpParams second = params_in<FfpParams>("ffp.IN");
  second.filter_order = 2;
  second.cutoff_hz = LookupTable({kWind_mps}, {0.09});
  second.damping = LookupTable({kWind_mps}, {0.8});
  for (std::size_t i = 0; i < f_hz.size(); ++i) {
    EXPECT_NEAR(std::abs(flown(f_hz[i], true, second)), std::sqrt(with[i]),
                0.07 * std::sqrt(alone[i]))
        << f_hz[i];
  }
}

// An estimate that is late by so much wants a buffer shorter by so much: which signal leads.
TEST(RotorSpeedPrediction, TrimsTheLatenessAway) {
  std::vector<double> f_hz;
  for (int i = 1; i <= 60; ++i) f_hz.push_back(0.004 * i);
  const double in_time_s = prediction(same_wind(f_hz)).best_trim_s({1, 0.05, 0.0});
  EXPECT_NEAR(prediction(same_wind(f_hz, 0.7)).best_trim_s({1, 0.05, 0.0}), in_time_s - 0.7, 1e-3);
  EXPECT_NEAR(prediction(same_wind(f_hz, -0.4)).best_trim_s({1, 0.05, 0.0}), in_time_s + 0.4, 1e-3);
}

// Coherent with the rotor by half, the best filter leaves half of the variance; a lidar that sees
// nothing only adds.
TEST(RotorSpeedPrediction, HasItsLimits) {
  CorrelationCurve c = same_wind({0.01, 0.02, 0.04, 0.08});
  for (auto& s : c.s_rl) s = std::sqrt(0.5);
  const RotorSpeedPrediction half = prediction(c);
  const double alone = half.deviation_radps(half.feedback_only());
  EXPECT_NEAR(half.deviation_radps(half.least()), alone * std::sqrt(0.5), 1e-12);
  for (const double cutoff_hz : {0.01, 0.03, 0.1})
    EXPECT_GT(half.deviation_radps(half.assisted({{1, cutoff_hz, 0.0}, 0.0})),
              alone * std::sqrt(0.5));
  for (auto& s : c.s_rl) s = 0.0;
  const RotorSpeedPrediction blind = prediction(c);
  EXPECT_GT(blind.deviation_radps(blind.assisted({{1, 0.05, 0.0}, 0.0})), alone);
  EXPECT_NEAR(blind.deviation_radps(blind.least()), alone, 1e-12);
}

// A narrow band of S_LL = 1 about 0.2 Hz, behind a window of 1 s and a low-pass of 0.2 Hz.
TEST(RotorSpeedPrediction, FiltersTheEstimateThroughTheWindow) {
  constexpr double kWidth_hz = 1e-4;
  const RotorSpeedPrediction p = prediction(same_wind({0.2, 0.2 + kWidth_hz}));
  const double window = std::sin(0.2 * kPi) / (0.2 * kPi);
  EXPECT_NEAR(p.filtered_deviation_mps({1, 0.2, 0.0}), window * std::sqrt(0.5 * kWidth_hz),
              1e-3 * std::sqrt(kWidth_hz));
}

// Bands share the variance out without a rest.
TEST(RotorSpeedPrediction, SharesItsVarianceOverBands) {
  const RotorSpeedPrediction p = prediction(same_wind({0.01, 0.03, 0.07, 0.2}));
  const std::vector<double> s = p.feedback_only();
  const double whole = p.variance(s, 0.01, 0.2);
  EXPECT_NEAR(p.variance(s, 0.01, 0.05) + p.variance(s, 0.05, 0.2), whole, 1e-12 * whole);
  EXPECT_NEAR(std::pow(p.deviation_radps(s), 2), whole, 1e-12 * whole);
  EXPECT_EQ(p.variance(s, 0.3, 0.4), 0.0);
}

// Below rated the pitch does not hold the speed.
TEST(RotorSpeedPrediction, IsForAboveRated) {
  EXPECT_THAT([] { LinearTurbine(nrel5mw(), params_in<FeedbackParams>("feedback_lac.IN"), 9.0); },
              ThrowsMessage<Error>(HasSubstr("9 m/s is below rated")));
}

}  // namespace
}  // namespace lac::sim
