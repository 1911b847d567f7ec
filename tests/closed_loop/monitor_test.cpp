// SPDX-License-Identifier: Apache-2.0
// The rotor's own wind speed and the live monitor in the simulated turbine.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "closed_loop/case_flight.hpp"
#include "core/turbine_rews.hpp"
#include "core/units.hpp"
#include "sim_harness/analysis/coherence.hpp"
#include "sim_harness/analysis/correlation.hpp"
#include "sim_harness/run/results.hpp"
#include "sim_harness/turbine/operating_point.hpp"

namespace lac::test {
namespace {

using sim::LidarFault;
using sim::LidarFaultKind;

constexpr double kStep_s = 0.0125;

TurbineRewsParams turbine_rews_params(const sim::TurbineParams& t) {
  TurbineRewsParams p{t.rotor};
  p.inertia_kgm2 = t.inertia_kgm2;
  p.gearbox_ratio = t.gearbox_ratio;
  p.gearbox_efficiency = t.gearbox_efficiency;
  return p;
}

// Steady states of the simulated turbine below, around and above rated: within 0.1 %.
TEST(TurbineRewsOfTurbine, SteadyStates) {
  const sim::TurbineParams turbine =
      sim::load_turbine(LAC_SOURCE_DIR "/config/turbines/nrel5mw/turbine.yaml");
  const TurbineRews rews(turbine_rews_params(turbine), kStep_s);
  for (double wind_mps = 4.0; wind_mps < 25.1; wind_mps += 0.7) {
    const sim::OperatingPoint point = sim::steady_state(turbine, wind_mps);
    TurbineRews::Inputs in;
    in.generator_speed_radps = turbine.gearbox_ratio * point.rotor_speed_radps;
    in.generator_torque_Nm = point.generator_torque_Nm;
    in.pitch_rad = point.pitch_rad;
    TurbineRews::State state;
    double v_mps = 0.0;
    for (int i = 0; i < 100; ++i) v_mps = rews.step(in, state);
    EXPECT_NEAR(v_mps, wind_mps, 0.001 * wind_mps);
  }
}

/// Wind on the rotor and what is found out of the turbine's own signals, of one flight.
struct Winds {
  std::vector<double> rotor_mps, found_mps;
};
Winds winds_of_flight(double mean_mps) {
  const CaseFlight flight("demo.yaml",
                          {"wind.mean_speed_mps=" + std::to_string(mean_mps),
                           "time.duration_s=" + std::string(kSanitized ? "160" : "660")});
  const sim::Recording r = flight.fly(0).recording;
  const auto wind = r.column("RtVAvgxh"), speed_rpm = r.column("GenSpeed"),
             torque_kNm = r.column("GenTq"), pitch_deg = r.column("BldPitch1");
  const TurbineRews rews(turbine_rews_params(flight.c.turbine), kStep_s);
  TurbineRews::State state;
  Winds w;
  const std::size_t first = r.first_row_from(60.0);
  for (std::size_t i = 0; i < r.rows(); ++i) {
    const double v_mps = rews.step(
        {radps_from_rpm(speed_rpm[i]), 1000.0 * torque_kNm[i], rad_from_deg(pitch_deg[i]), true},
        state);
    if (i < first) continue;
    EXPECT_TRUE(std::isfinite(v_mps)) << i;
    w.rotor_mps.push_back(wind[i]);
    w.found_mps.push_back(v_mps);
  }
  return w;
}

// In turbulence below and above rated: the mean within 0.1 %, the standard deviation within 1 %,
// coherence at least 0.99 up to 0.1 Hz, and late by what delay_s() says, within 0.05 s.
TEST(TurbineRewsOfTurbine, InTurbulence) {
  for (const double mean_mps : {9.0, 18.0}) {
    if (kSanitized && mean_mps > 9.0) break;
    const Winds w = winds_of_flight(mean_mps);
    const auto moments = [](const std::vector<double>& v) {
      double sum = 0.0, squares = 0.0;
      for (const double x : v) sum += x, squares += x * x;
      const double mean = sum / static_cast<double>(v.size());
      return std::pair{mean, std::sqrt(squares / static_cast<double>(v.size()) - mean * mean)};
    };
    const auto [rotor, rotor_std] = moments(w.rotor_mps);
    const auto [found, found_std] = moments(w.found_mps);
    sim::CrossSpectrumEstimator estimator(kStep_s, 8000);
    ASSERT_TRUE(estimator.add(w.rotor_mps, w.found_mps));
    const sim::CrossSpectrum s = estimator.result();
    double lowest = 1.0;
    for (std::size_t i = 0; i < s.frequency_hz.size() && s.frequency_hz[i] <= 0.1; ++i) {
      lowest = std::min(lowest, s.coherence[i]);
    }
    const sim::CorrelationPeak peak = sim::correlation_peak(w.rotor_mps, w.found_mps, kStep_s, 0,
                                                            w.rotor_mps.size() - 400, {0.0, 3.0});
    const double delay_s = TurbineRews(turbine_rews_params(sim::load_turbine(
                                           LAC_SOURCE_DIR "/config/turbines/nrel5mw/turbine.yaml")),
                                       kStep_s)
                               .delay_s();
    std::cout << mean_mps << " m/s: mean " << found / rotor - 1.0 << ", std "
              << found_std / rotor_std - 1.0 << ", least coherence up to 0.1 Hz " << lowest
              << ", delay " << peak.delay_s << " s (" << delay_s << " s)\n";
    EXPECT_NEAR(found, rotor, (kSanitized ? 0.01 : 0.001) * rotor);
    if (kSanitized) break;  // too short for the rest
    EXPECT_NEAR(found_std, rotor_std, 0.01 * rotor_std);
    EXPECT_GT(lowest, 0.99);
    EXPECT_NEAR(peak.delay_s, delay_s, 0.05);
  }
}

/// Standard deviation of the rotor speed with a fault of the lidar, by controller.
class MonitorFlights : public testing::Test {
 protected:
  static CaseFlight& flight() {
    static CaseFlight f("demo.yaml", {"wind.mean_speed_mps=16", "time.duration_s=" + duration()});
    return f;
  }
  static std::string duration() { return kSanitized ? "200" : "460"; }

  /// `told`: how often the monitor has something to say.
  static double std_rpm(const std::string& input, const LidarFault& fault, int told) {
    flight().c.lidar->fault = fault;
    sim::CaseController controller;
    controller.name = "controller";
    controller.input_file = LAC_SOURCE_DIR "/config/" + input;
    const Flight f = flight().fly(controller);
    int of_monitor = 0;
    for (const Warning& w : f.warnings) {
      const bool its_own = w.text.find("feedforward authority") != std::string::npos;
      of_monitor += its_own ? 1 : 0;
      if (its_own) std::cout << w.time_s << " s: " << w.text << '\n';
    }
    EXPECT_EQ(of_monitor, told);
    return sim::flight_figures(f.recording, 60.0).rotor_speed_std_rpm;
  }
  static double feedback_std_rpm() {
    static const double value = std_rpm("nrel5mw/wrapper_fb.IN", {}, 0);
    return value;
  }
};

// A healthy lidar: the monitor costs less than 1 % of the standard deviation, and is silent.
TEST_F(MonitorFlights, HealthyLidar) {
  const double plain = std_rpm("nrel5mw/wrapper_lac.IN", {}, 0);
  const double watched = std_rpm("nrel5mw/wrapper_monitor.IN", {}, 0);
  std::cout << "over feedback: " << plain / feedback_std_rpm() << ", with the monitor "
            << watched / feedback_std_rpm() << '\n';
  EXPECT_LT(plain, 0.85 * feedback_std_rpm());
  EXPECT_NEAR(watched, plain, 0.01 * plain);
}

// A lidar that says double: harm without the monitor, at most 3 % with it, told once.
TEST_F(MonitorFlights, LidarThatSaysDouble) {
  const LidarFault twice{.kind = LidarFaultKind::kBias, .factor = 2.0};
  const double plain = std_rpm("nrel5mw/wrapper_lac.IN", twice, 0);
  const double watched = std_rpm("nrel5mw/wrapper_monitor.IN", twice, 1);
  std::cout << "over feedback: " << plain / feedback_std_rpm() << ", with the monitor "
            << watched / feedback_std_rpm() << '\n';
  if (kSanitized) return;  // ends before the rest has paid for the start
  EXPECT_LT(watched, plain);
  EXPECT_GT(plain, 1.03 * feedback_std_rpm());
  EXPECT_LT(watched, 1.03 * feedback_std_rpm());
}

// Everyday faults, never more than 3 % above feedback alone: biased by a fifth, half of the data
// missing, a beam stuck, the buffer wrong by a second.
TEST_F(MonitorFlights, EverydayFaults) {
  const std::map<std::string, LidarFault> faults{
      {"high", {.kind = LidarFaultKind::kBias, .factor = 1.2}},
      {"low", {.kind = LidarFaultKind::kBias, .factor = 0.8}},
      {"missing", {.kind = LidarFaultKind::kMissing, .share = 0.5}},
      {"beam", {.kind = LidarFaultKind::kStuckBeam, .beam_id = 0}}};
  for (const auto& [name, fault] : faults) {
    if (kSanitized && name != "high") continue;
    const bool biased = fault.kind == LidarFaultKind::kBias;
    const double watched = std_rpm("nrel5mw/wrapper_monitor.IN", fault, biased ? 1 : 0);
    std::cout << name << " over feedback: " << watched / feedback_std_rpm() << '\n';
    EXPECT_LT(watched, 1.03 * feedback_std_rpm()) << name;
  }
  for (const std::string which : {"early", "late"}) {
    if (kSanitized && which == "late") break;
    const double watched = std_rpm("studies/robust/wrapper_" + which + "_monitor.IN", {}, 0);
    std::cout << which << " over feedback: " << watched / feedback_std_rpm() << '\n';
    EXPECT_LT(watched, 1.03 * feedback_std_rpm()) << which;
  }
}

}  // namespace
}  // namespace lac::test
