// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/analysis/spectrum.hpp"

#include <cmath>
#include <complex>

#include "sim_harness/analysis/block_transform.hpp"

namespace lac::sim {

Spectrum welch(std::span<const double> series, double time_step_s, std::size_t block_samples) {
  const BlockTransform transform(series.size(), time_step_s, block_samples, Taper::kHamming);
  Spectrum spectrum;
  for (std::size_t k = 0; k < transform.bins(); ++k)
    spectrum.frequency_hz.push_back(transform.frequency_hz(k));
  spectrum.density.assign(transform.bins(), 0.0);
  const std::vector<std::complex<double>> x = transform(series);
  for (std::size_t i = 0; i < x.size(); ++i) {
    spectrum.density[i % transform.bins()] +=
        std::norm(x[i]) / static_cast<double>(transform.blocks());
  }
  return spectrum;
}

Spectrum log_binned(const Spectrum& spectrum, std::size_t bins_per_decade) {
  Spectrum binned;
  double count = 0.0;
  long current = 0;
  for (std::size_t k = 0; k < spectrum.frequency_hz.size(); ++k) {
    const double f_hz = spectrum.frequency_hz[k];
    if (f_hz <= 0.0) continue;
    const auto bin =
        std::lround(std::floor(std::log10(f_hz) * static_cast<double>(bins_per_decade)));
    if (count == 0.0 || bin != current) {
      binned.frequency_hz.push_back(0.0);
      binned.density.push_back(0.0);
      current = bin;
      count = 0.0;
    }
    count += 1.0;
    binned.frequency_hz.back() += (f_hz - binned.frequency_hz.back()) / count;
    binned.density.back() += (spectrum.density[k] - binned.density.back()) / count;
  }
  return binned;
}

}  // namespace lac::sim
