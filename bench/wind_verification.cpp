// SPDX-License-Identifier: Apache-2.0
// Long runs of generated wind and simulated lidar against the tables of python/;
// docs/verification.md has the commands and the results.
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "sim_harness/analysis/block_transform.hpp"
#include "sim_harness/wind/kaimal_field.hpp"
#include "sim_harness/wind/mann_field.hpp"
#include "sim_harness/wind/stability.hpp"
#include "tests/sim_harness/verification/correlation_table.hpp"
#include "tests/sim_harness/verification/evolving_field.hpp"
#include "tests/sim_harness/verification/lidar_preview.hpp"

namespace lac::sim {
namespace {

constexpr double kSpeed_mps = 16.0;
constexpr double kHub_m = 100.0;
constexpr double kRadius_m = 63.0;

struct Study {
  std::string model;
  Stability stability;
  std::string table;
  int realisations;
  std::uint64_t first_seed;
};

/// The grid of a study.
struct Frame {
  int points;  // in y and z
  double width_m;
  int box_points;  // Mann
  double step_s;
  std::size_t samples;
};

/// Series of a field, transformed, in the order of the comparisons.
using Amplitudes = std::vector<std::complex<double>>;

struct Quantity {
  std::string name;
  std::size_t a, b;  // of the amplitudes
  PairComparison comparison;
};

template <class Params>
Params with_frame(const Frame& frame, Params p) {
  p.mean_speed_mps = kSpeed_mps;
  p.hub_height_m = kHub_m;
  p.width_m = p.height_m = frame.width_m;
  p.ny = p.nz = frame.points;
  p.dt_s = frame.step_s;
  p.duration_s = frame.step_s * static_cast<double>(frame.samples);
  p.threads = 1;
  return p;
}

KaimalPlanes kaimal_planes(const Study& study, const Frame& frame) {
  auto p = with_frame<KaimalFieldParams>(frame, {});
  p.model = stability_kaimal(study.stability, kStabilitySigmaU_mps);
  p.evolution = stability_evolution(study.stability);
  p.lateral_coherence = LateralCoherence::kSameAsU;
  return KaimalPlanes(p);
}

MannPlanes mann_planes(const Study& study, const Frame& frame) {
  auto p = with_frame<MannFieldParams>(frame, {});
  p.model = stability_mann(study.stability);
  p.box_ny = p.box_nz = frame.box_points;
  return MannPlanes(p);
}

/// Adds so many realisations: take(planes) gives the amplitudes of one.
void collect(const Study& study, const Frame& frame, std::vector<Quantity>& quantities,
             const auto& take) {
  const auto go = [&](auto planes) {
    for (int i = 0; i < study.realisations; ++i) {
      planes.restart(study.first_seed + static_cast<std::uint64_t>(i));
      const std::vector<Amplitudes> amplitudes = take(planes);
      for (Quantity& q : quantities) q.comparison.add(amplitudes[q.a], amplitudes[q.b]);
    }
  };
  study.model == "mann" ? go(mann_planes(study, frame)) : go(kaimal_planes(study, frame));
}

struct Share {
  int inside = 0, values = 0;

  void add(const std::vector<ComparedBand>& bands) {
    for (const ComparedBand& b : bands) inside += b.inside(), ++values;
  }
};

double worst(const std::vector<ComparedBand>& bands) {
  double most = 0.0;
  for (const ComparedBand& b : bands) most = std::max(most, std::abs(b.found - b.expected));
  return most;
}

void print_power(const std::string& name, const std::vector<ComparedBand>& bands,
                 const ComparedBand& variance) {
  Share share;
  share.add(bands);
  std::printf("| %s | %d of %d | %+.1f %% of variance (95 %%: +-%.1f) |\n", name.c_str(),
              share.inside, share.values, 100.0 * (variance.found - 1.0),
              100.0 * (variance.high - 1.0));
}

void print_bands(const std::string& name, const std::vector<ComparedBand>& bands) {
  Share share;
  share.add(bands);
  double mean = 0.0;
  for (const ComparedBand& b : bands) mean += (b.found - b.expected) / share.values;
  std::printf("| %s | %d of %d | mean %+.3f, largest %.3f |\n", name.c_str(), share.inside,
              share.values, mean, worst(bands));
}

void print_details(const std::string& name, const std::vector<ComparedBand>& bands) {
  for (const ComparedBand& b : bands) {
    std::fprintf(stderr, "%s %.5f %.5f %.5f %.5f %.5f\n", name.c_str(), b.frequency_hz, b.expected,
                 b.found, b.low, b.high);
  }
}

// Columns of python/turbulence_models.py.
constexpr std::size_t kSeparations = 5, kDistances = 3;
constexpr std::size_t kFirstAcross = 4, kFirstAlong = kFirstAcross + 3 * kSeparations;
constexpr std::size_t kUw = kFirstAlong + kDistances, kPointColumns = kUw + 1;

/// Theory of two series of components a and b; column 0: one series with itself.
std::vector<PairDensity> point_densities(const FrequencyTable& table,
                                         const BlockTransform& transform, std::size_t a,
                                         std::size_t b, std::size_t column) {
  std::vector<PairDensity> result{{1.0, 1.0, 0.0}};
  for (std::size_t k = 1; k < transform.end_bin(); ++k) {
    const auto spectrum = [&](std::size_t component) {
      return transform.expected(
          k, [&](double f_hz) { return table.positive_at(f_hz, 1 + component); });
    };
    const double aa = spectrum(a), bb = spectrum(b);
    const double coherence = column == 0 ? 1.0 : table.at(transform.frequency_hz(k), column);
    result.push_back({aa, bb, coherence * std::sqrt(aa * bb)});
  }
  return result;
}

/// One-point spectra, coherence across and along the wind, uw.
void study_points(const Study& study) {
  const Frame frame{17, 160.0, 64, 5.0 / 6.0, 768};
  const std::vector<double> distances_m{50.0, 100.0, 170.0};
  const std::vector<int> steps{0, 1, 2, 4, 8, 16};  // of 10 m, from the left edge
  const BlockTransform transform(frame.samples, frame.step_s, frame.samples, Taper::kNone);
  const FrequencyTable table(study.table, kPointColumns);
  std::vector<Quantity> powers, coherences;
  const auto quantity = [&](const std::string& name, std::size_t a, std::size_t b, std::size_t ca,
                            std::size_t cb, std::size_t column) {
    return Quantity{
        name, a, b, {point_densities(table, transform, ca, cb, column), transform.frequency_hz(1)}};
  };
  // Amplitudes: per component the six points of steps; then u of the planes at the first point.
  for (std::size_t c = 0; c < 3; ++c) {
    const std::string letter(1, "uvw"[c]);
    powers.push_back(quantity("spectrum of " + letter, 6 * c, 6 * c, c, c, 0));
    for (std::size_t s = 0; s < kSeparations; ++s) {
      coherences.push_back(quantity(
          "coherence of " + letter + ", " + std::to_string(10 * steps[s + 1]) + " m across", 6 * c,
          6 * c + s + 1, c, c, kFirstAcross + kSeparations * c + s));
    }
  }
  for (std::size_t d = 0; d < kDistances; ++d) {
    coherences.push_back(
        quantity("coherence of u, " + std::to_string(int(distances_m[d])) + " m along", 0, 18 + d,
                 0, 0, kFirstAlong + d));
  }
  if (study.model == "mann")
    coherences.push_back(quantity("co-coherence of u and w", 0, 12, 0, 2, kUw));

  std::vector<Quantity> all = powers;
  all.insert(all.end(), coherences.begin(), coherences.end());
  collect(study, frame, all, [&](auto& planes) {
    std::vector<Amplitudes> result;
    const auto add = [&](const GriddedWind& wind, int iy, int component) {
      std::vector<double> series(frame.samples);
      for (std::size_t i = 0; i < series.size(); ++i)
        series[i] = wind.grid().at(static_cast<int>(i), 8, iy, component);
      result.push_back(transform(series));
    };
    const GriddedWind rotor = planes.next(0.0);
    for (int c = 0; c < 3; ++c) {
      for (const int iy : steps) add(rotor, iy, c);
    }
    for (const double distance_m : distances_m) add(planes.next(distance_m), 0, 0);
    return result;
  });
  Share total;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PairComparison& c = all[i].comparison;
    const auto bands = i < powers.size() ? c.power_a() : c.coherence();
    total.add(bands);
    print_details(all[i].name, bands);
    i < powers.size() ? print_power(all[i].name, bands, c.variance_a())
                      : print_bands(all[i].name, bands);
  }
  std::printf("| together | %d of %d, %.1f %% | |\n", total.inside, total.values,
              100.0 * total.inside / total.values);
}

/// REWS and its estimate by four beams and ten gates.
void study_lidar(const Study& study) {
  const Frame frame{21, 140.0, 80, 5.0 / 6.0, 768};
  std::vector<double> gates_m;
  for (int i = 4; i < 14; ++i) gates_m.push_back(i * kSpeed_mps * frame.step_s);
  const LidarParams lidar = preview_lidar(gates_m, frame.step_s);
  const BlockTransform transform(frame.samples, frame.step_s, frame.samples, Taper::kNone);
  std::vector<Quantity> all{
      {"", 0, 1, {lidar_densities(study.table, transform, 0.3), transform.frequency_hz(1)}}};
  collect(study, frame, all, [&](auto& planes) {
    const EvolvingWind wind = evolving_field(planes, gates_m);
    return std::vector<Amplitudes>{
        transform(rotor_speed(wind, kRadius_m, kHub_m, frame.step_s, frame.samples)),
        transform(lidar_estimate(wind, lidar, kHub_m, frame.samples))};
  });
  const PairComparison& c = all[0].comparison;
  print_power("S_RR", c.power_a(), c.variance_a());
  print_power("S_LL", c.power_b(), c.variance_b());
  print_bands("root coherence", c.coherence());
  print_bands("transfer function over its theory", c.transfer());
  for (const auto& [name, bands] :
       std::map<std::string, std::vector<ComparedBand>>{{"S_RR", c.power_a()},
                                                        {"S_LL", c.power_b()},
                                                        {"coherence", c.coherence()},
                                                        {"transfer", c.transfer()}}) {
    print_details(name, bands);
  }
  std::printf("| k0.5 | | %+.1f %% |\n", 100.0 * (half_coherence_ratio(c.coherence()) - 1.0));
}

/// REWS alone, on the grid of tests/data/lidar_correlation: many realisations in little time.
void study_rotor(const Study& study) {
  const Frame frame{9, 140.0, 40, 5.0 / 6.0, 768};
  const BlockTransform transform(frame.samples, frame.step_s, frame.samples, Taper::kNone);
  std::vector<Quantity> all{
      {"", 0, 0, {lidar_densities(study.table, transform, 0.3), transform.frequency_hz(1)}}};
  collect(study, frame, all, [&](auto& planes) {
    return std::vector<Amplitudes>{
        transform(rotor_speed(planes.next(0.0), kRadius_m, kHub_m, frame.step_s, frame.samples))};
  });
  const PairComparison& c = all[0].comparison;
  print_power("S_RR", c.power_a(), c.variance_a());
  print_details("S_RR", c.power_a());
}

Study study_of(std::span<char*> arguments) {
  const std::map<std::string, Stability> classes{{"unstable", Stability::kUnstable},
                                                 {"neutral", Stability::kNeutral},
                                                 {"stable", Stability::kStable}};
  const std::string model = arguments[2], stability = arguments[3];
  if ((model != "kaimal" && model != "mann") || !classes.contains(stability))
    throw Error("unknown model or class: " + model + " " + stability);
  return {model, classes.at(stability), arguments[4], std::atoi(arguments[5]),
          std::strtoull(arguments[6], nullptr, 10)};
}

}  // namespace
}  // namespace lac::sim

int main(int count, char** arguments) {
  if (count != 7) {
    std::cerr << "wind_verification points|lidar|rotor kaimal|mann unstable|neutral|stable TABLE "
                 "REALISATIONS FIRST_SEED\n";
    return 2;
  }
  try {
    const lac::sim::Study study = lac::sim::study_of({arguments, arguments + count});
    const std::map<std::string, void (*)(const lac::sim::Study&)> studies{
        {"points", lac::sim::study_points},
        {"lidar", lac::sim::study_lidar},
        {"rotor", lac::sim::study_rotor}};
    if (!studies.contains(arguments[1]))
      throw lac::Error(std::string("unknown study: ") + arguments[1]);
    studies.at(arguments[1])(study);
  } catch (const lac::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
