// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/component_check.hpp"

#include <algorithm>
#include <cmath>

#include "sim_harness/wind_check/lattice_moments.hpp"

namespace lac::sim {
namespace {

constexpr double kSpectrumBandsPerDecade = 6.0;
constexpr double kCoherenceBandsPerDecade = 3.0;
constexpr double kFewestValues = 10.0;

/// Where in a band a smooth function has its mean (Gauss-Legendre), in shares of the band.
struct Node {
  double place;
  double weight;
};
constexpr Node kNodes[] = {
    {0.1127016653792583, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.8872983346207417, 5.0 / 18.0}};

}  // namespace

ComponentCheck::ComponentCheck(const GriddedWind& wind, const TurbulenceTheory& theory,
                               int component, const GridSampling& sampling,
                               const BlockTransform& transform, std::size_t end_bin)
    : theory_(theory),
      component_(component),
      lattice_(sampling.lattice),
      transform_(transform),
      end_bin_(end_bin),
      expected_(densities()),
      bands_(log_bands(transform.first_bin(), end_bin, kSpectrumBandsPerDecade)),
      amplitudes_(wind, component, sampling, transform, expected_) {
  for (const Band& band : bands_) points_.push_back(scatter_of_points(middle_hz(band)));
}

std::vector<double> ComponentCheck::densities() const {
  std::vector<double> all(transform_.bins(), 0.0);
  const auto density = [this](double f_hz) { return theory_.spectrum(component_, f_hz); };
  for (std::size_t k = transform_.first_bin(); k < end_bin_; ++k)
    all[k] = transform_.expected(k, density);
  return all;
}

double ComponentCheck::mean_density(const Band& band) const {
  double sum = 0.0;
  for (std::size_t k = band.first; k < band.end; ++k) sum += expected_[k];
  return sum / band.bins();
}

double ComponentCheck::middle_hz(const Band& band) const {
  return 0.5 * (transform_.frequency_hz(band.first) + transform_.frequency_hz(band.end - 1));
}

double ComponentCheck::scatter_of_points(double frequency_hz) const {
  return variance_of_mean_power(theory_.coherencies(component_, frequency_hz, lattice_));
}

std::vector<Estimate> ComponentCheck::spectrum() const {
  std::vector<Estimate> all;
  for (std::size_t i = 0; i < bands_.size(); ++i) {
    const Band& band = bands_[i];
    const double density = mean_density(band);
    all.push_back({middle_hz(band), density * amplitudes_.mean_power(band), density,
                   points_[i] * transform_.variance_of_mean(band.first, band.end)});
  }
  return all;
}

Estimate ComponentCheck::variance(const std::vector<Estimate>& spectrum) const {
  const double df_hz = transform_.frequency_hz(1);
  Estimate sum{.frequency_hz = transform_.frequency_hz(transform_.first_bin())};
  std::vector<double> weights;  // of the bins, the scatter among points included
  for (std::size_t i = 0; i < bands_.size(); ++i) {
    const Band& band = bands_[i];
    sum.found += spectrum[i].found * df_hz * band.bins();
    sum.expected += spectrum[i].expected * df_hz * band.bins();
    for (std::size_t k = band.first; k < band.end; ++k)
      weights.push_back(expected_[k] * df_hz * std::sqrt(points_[i]));
  }
  sum.variance = transform_.variance_of_sum(weights) / (sum.expected * sum.expected);
  return sum;
}

std::vector<double> ComponentCheck::expected_coherences(
    const Band& band, const std::vector<LatticeSteps>& separations) const {
  Lattice part{1, 1, lattice_.dy_m, lattice_.dz_m};
  for (const LatticeSteps& s : separations) {
    part.ny = std::max(part.ny, s.y + 1);
    part.nz = std::max(part.nz, s.z + 1);
  }
  std::vector<double> mean(separations.size());
  for (const Node& node : kNodes) {
    const double bin = static_cast<double>(band.first) - 0.5 + node.place * band.bins();
    const CoherencyTable table =
        theory_.coherencies(component_, bin * transform_.frequency_hz(1), part);
    for (std::size_t i = 0; i < separations.size(); ++i)
      mean[i] += node.weight * table.at(separations[i].y, separations[i].z).real();
  }
  return mean;
}

std::vector<std::vector<Estimate>> ComponentCheck::coherence(
    const std::vector<LatticeSteps>& separations) const {
  std::vector<std::vector<Estimate>> all(separations.size());
  for (const Band& band : log_bands(transform_.first_bin(), end_bin_, kCoherenceBandsPerDecade)) {
    const CoherencyTable table = theory_.coherencies(component_, middle_hz(band), lattice_);
    const std::vector<double> expected = expected_coherences(band, separations);
    for (std::size_t i = 0; i < separations.size(); ++i) {
      const LatticeSteps s = separations[i];
      const double variance = variance_of_coherence(table, s.y, s.z) *
                              transform_.variance_of_mean(band.first, band.end);
      if (variance > 0.5 / kFewestValues) continue;
      all[i].push_back({middle_hz(band), amplitudes_.coherence(band, s), expected[i], variance});
    }
  }
  return all;
}

}  // namespace lac::sim
