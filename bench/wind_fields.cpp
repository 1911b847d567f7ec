// SPDX-License-Identifier: Apache-2.0
// Time and peak memory of generated turbulence, 150 m wide and high, 660 s at 0.1 s, u, v and w, on
// two threads. The memory is that of the process so far: entries rise in size.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "sim_harness/wind/kaimal_field.hpp"
#include "sim_harness/wind/stability.hpp"

namespace lac::sim {
namespace {

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

KaimalFieldParams field(const benchmark::State& state) {
  KaimalFieldParams p;
  p.ny = p.nz = static_cast<int>(state.range(0));
  p.width_m = p.height_m = 150.0;
  return p;
}

/// v and w independent.
void kaimal(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    const GriddedWind wind = make_kaimal_field(field(state));
    benchmark::DoNotOptimize(wind.grid().plane(0).data());
  }
  state.counters["peak_MiB"] = peak_mib();
}

/// v and w with the coherence of u.
void kaimal_coherent(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    KaimalFieldParams p = field(state);
    p.lateral_coherence = LateralCoherence::kSameAsU;
    const GriddedWind wind = make_kaimal_field(p);
    benchmark::DoNotOptimize(wind.grid().plane(0).data());
  }
  state.counters["peak_MiB"] = peak_mib();
}

/// The rotor plane and ten up-wind, the latter thrown away one after the other.
void kaimal_evolving(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    KaimalFieldParams p = field(state);
    p.evolution = stability_evolution(Stability::kNeutral);
    KaimalPlanes planes(p);
    for (int plane = 0; plane <= 10; ++plane)
      benchmark::DoNotOptimize(planes.next(17.0 * plane).grid().plane(0).data());
  }
  state.counters["peak_MiB"] = peak_mib();
}

void once(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kSecond)->Iterations(1)->MeasureProcessCPUTime()->UseRealTime();
}

BENCHMARK(kaimal)->Arg(31)->Apply(once);
BENCHMARK(kaimal_coherent)->Arg(31)->Apply(once);
BENCHMARK(kaimal_evolving)->Arg(31)->Apply(once);
BENCHMARK(kaimal)->Arg(63)->Apply(once);
BENCHMARK(kaimal_coherent)->Arg(63)->Apply(once);
BENCHMARK(kaimal)->Arg(127)->Apply(once);
BENCHMARK(kaimal_coherent)->Arg(127)->Apply(once);

}  // namespace
}  // namespace lac::sim
