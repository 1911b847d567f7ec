// SPDX-License-Identifier: Apache-2.0
// Time of one controller step at 80 Hz, as the host sees it: the master with its four secondaries
// and a lidar, the same with the live monitor, the feedback-only chain, ldp by itself with little
// and with all to do, the monitor by itself, and one call of an unmodified ROSCO without its log.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench/recorded_inputs.hpp"
#include "rosco/rosco_files.hpp"
#include "support/discon_caller.hpp"
#include "support/lidar_scan.hpp"

namespace lac {
namespace {

using bench::kRecorded;

constexpr int kStepsPerMeasurement = 20;  // one beam each 0.25 s

std::vector<LidarMeasurement> recorded_measurements() {
  test::LidarScan scan;
  scan.travel_mps = 18.0;
  scan.gate_distance_m.clear();
  for (int g = 0; g < 10; ++g) scan.gate_distance_m.push_back(50.0 + 13.3 * g);
  scan.wind_mps = [](double t) { return 18.0 + 2.0 * std::sin(0.31415926 * t); };
  std::vector<LidarMeasurement> measurements;
  for (int i = 0; i < kRecorded / kStepsPerMeasurement; ++i) {
    measurements.push_back(scan.measure(i * 0.25, i % 4));
  }
  return measurements;
}

/// The cost of filling the records is in the figure; it is the host's, a few nanoseconds.
void run(benchmark::State& state, test::DisconCaller& caller, bool lidar) {
  const auto inputs = bench::recorded_inputs();
  const auto measurements = recorded_measurements();
  LidarMeasurement m;
  long step = 0;
  const auto one = [&](int status) {
    const auto i = static_cast<std::size_t>(step % kRecorded);
    bench::set_inputs(caller.swap(), inputs[i]);
    if (lidar) {
      const bool is_new = step % kStepsPerMeasurement == 0;
      if (is_new) {
        m = measurements[i / kStepsPerMeasurement];
        m.time_s = static_cast<double>(step) * 0.0125;
      }
      write_native_lidar(caller.swap(), m, is_new);
    }
    ++step;
    return caller.call(status);
  };
  caller.swap().set(Rec::NumberOfBlades, 3);
  caller.swap().set(Rec::PitchControl, 0);
  if (one(0) < 0) return state.SkipWithError(caller.message().c_str());
  for (int i = 0; i < 8000; ++i) one(1);
  while (state.KeepRunning()) {
    if (one(1) < 0) return state.SkipWithError(caller.message().c_str());
  }
  caller.call(-1);
}

void lidar_assisted_chain(benchmark::State& state) {
  test::DisconCaller caller("liblac_wrapper", LAC_SOURCE_DIR "/config/nrel5mw/wrapper_lac.IN",
                            kExtendedArraySize);
  run(state, caller, true);
}
BENCHMARK(lidar_assisted_chain);

void watched_chain(benchmark::State& state) {
  test::DisconCaller caller("liblac_wrapper", LAC_SOURCE_DIR "/config/nrel5mw/wrapper_monitor.IN",
                            kExtendedArraySize);
  run(state, caller, true);
}
BENCHMARK(watched_chain);

/// The monitor by itself, called as by the master, with a lidar that leads by 4 s.
void monitor_alone(benchmark::State& state) {
  test::DisconCaller caller("liblac_monitor", LAC_SOURCE_DIR "/config/nrel5mw/monitor.IN");
  const auto inputs = bench::recorded_inputs();
  std::size_t step = 0;
  const auto one = [&](int status) {
    const bench::HostInput& now = inputs[step % kRecorded];
    const double rews_mps = static_cast<double>(inputs[(step + 320) % kRecorded].wind_mps);
    bench::set_inputs(caller.swap(), now);
    caller.swap().set(Rec::LidarRews, rews_mps);
    caller.swap().set(Rec::LidarRewsLead, 4.0);
    caller.swap().set(Rec::LidarRewsValid, 1.0);
    caller.swap().set(Rec::FeedforwardCutOff, 0.05);
    caller.swap().set(Rec::FeedforwardBufferTime, 1.8);
    caller.swap().set(Rec::RewsBuffered, static_cast<double>(now.wind_mps));
    ++step;
    return caller.call(status);
  };
  if (one(0) < 0) return state.SkipWithError(caller.message().c_str());
  for (int i = 0; i < 8000; ++i) one(1);
  while (state.KeepRunning()) {
    if (one(1) < 0) return state.SkipWithError(caller.message().c_str());
  }
}
BENCHMARK(monitor_alone);

void feedback_only_chain(benchmark::State& state) {
  test::DisconCaller caller("liblac_wrapper", LAC_SOURCE_DIR "/config/nrel5mw/wrapper_fb.IN",
                            kExtendedArraySize);
  run(state, caller, false);
}
BENCHMARK(feedback_only_chain);

/// One library of the chain; the step of the master is not in it.
void ldp_alone(benchmark::State& state, const char* input) {
  test::DisconCaller caller("liblac_ldp", std::string(LAC_SOURCE_DIR "/config/nrel5mw/") + input);
  run(state, caller, true);
}
BENCHMARK_CAPTURE(ldp_alone, average, "ldp.IN");
BENCHMARK_CAPTURE(ldp_alone, all_of_it, "ldp_wind.IN");

void rosco_alone(benchmark::State& state) {
  const test::RoscoFiles rosco;
  if (!rosco.there()) {
    return state.SkipWithError("no ROSCO in build/rosco: it could not be downloaded");
  }
  const test::TempFolder folder;
  test::DisconCaller caller(rosco.library.string(), rosco.copy_input_to(folder), kExtendedArraySize,
                            folder.file("run.SrvD"));
  run(state, caller, false);
}
BENCHMARK(rosco_alone);

}  // namespace
}  // namespace lac
