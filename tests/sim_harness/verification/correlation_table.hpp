// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <filesystem>
#include <vector>

#include "sim_harness/analysis/block_transform.hpp"
#include "tests/sim_harness/verification/frequency_table.hpp"
#include "tests/sim_harness/verification/spectral_comparison.hpp"

namespace lac::sim {

/// Densities of REWS and lidar estimate at the bins of a transform below a frequency, from a table
/// of python/lidar_correlation.py: f, k1, S_RR, S_LL, |S_RL|, gamma^2, |G|, phase of S_RL.
inline std::vector<PairDensity> lidar_densities(const std::filesystem::path& file,
                                                const BlockTransform& transform, double end_hz) {
  const FrequencyTable table(file, 8);
  std::vector<PairDensity> result{{1.0, 1.0, 0.0}};  // frequency zero is not compared
  for (std::size_t k = 1; transform.frequency_hz(k) < end_hz; ++k) {
    const auto mean = [&](std::size_t column) {
      return transform.expected(k, [&](double f_hz) { return table.positive_at(f_hz, column); });
    };
    result.push_back(
        {mean(2), mean(3), std::polar(mean(4), table.at(transform.frequency_hz(k), 7))});
  }
  return result;
}

}  // namespace lac::sim
