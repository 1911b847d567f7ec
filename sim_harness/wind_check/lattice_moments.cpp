// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/lattice_moments.hpp"

#include <cmath>
#include <cstdlib>

namespace lac::sim {
namespace {

/// sum over pairs of points of an ny x nz lattice of f(steps between them), over the number of
/// pairs.
template <class F>
double mean_over_pairs(int ny, int nz, F&& f) {
  double sum = 0.0;
  for (int z = 1 - nz; z < nz; ++z) {
    for (int y = 1 - ny; y < ny; ++y)
      sum += static_cast<double>(ny - std::abs(y)) * (nz - std::abs(z)) * f(y, z);
  }
  const double n = static_cast<double>(ny) * nz;
  return sum / (n * n);
}

}  // namespace

double variance_of_mean_power(const CoherencyTable& g) {
  return mean_over_pairs(g.ny(), g.nz(), [&](int y, int z) { return std::norm(g.at(y, z)); });
}

double variance_of_coherence(const CoherencyTable& g, int y, int z) {
  const int ny = g.ny() - y, nz = g.nz() - z;
  const double gamma = g.at(y, z).real();
  // Between pair (i, i + s) and pair (k, k + s), d = k - i; d + s and s - d stay in the table.
  const double variance = mean_over_pairs(ny, nz, [&](int dy, int dz) {
    const auto same = g.at(dy, dz), back = g.at(-dy, -dz);
    const auto ahead = g.at(dy + y, dz + z), behind = g.at(y - dy, z - dz);
    const double cross = 0.5 * ((same * back).real() + (ahead * behind).real());
    const double with_power = (same * behind).real() + (ahead * back).real();
    const double powers = 0.5 * (std::norm(same) + std::norm(ahead));
    return cross - gamma * with_power + gamma * gamma * powers;
  });
  const double slope = 1.0 - gamma * gamma;
  return variance / (slope * slope);
}

}  // namespace lac::sim
