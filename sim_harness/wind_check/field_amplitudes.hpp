// SPDX-License-Identifier: Apache-2.0
// The Fourier amplitudes of a gridded field at its points, and their means over bands of
// frequencies: what is compared with theory.
#pragma once

#include <complex>
#include <vector>

#include "sim_harness/analysis/block_transform.hpp"
#include "sim_harness/wind/gridded_wind.hpp"
#include "sim_harness/wind_check/turbulence_theory.hpp"

namespace lac::sim {

/// Bins [first, end) of a transform.
struct Band {
  std::size_t first = 0;
  std::size_t end = 0;

  double bins() const { return static_cast<double>(end - first); }
};

/// Bands of equal width in log(f), as far as there are bins.
std::vector<Band> log_bands(std::size_t first, std::size_t end, double per_decade);

/// Every stride-th point of a grid, from its corner.
struct GridSampling {
  int stride = 1;
  Lattice lattice;
};

/// The smallest stride that leaves at most this many points (two in a direction always stay).
GridSampling sample_grid(const GridSpec& grid, int most_points);

/// A distance on a lattice.
struct LatticeSteps {
  int y = 0;
  int z = 0;
};

/// One component at all points of the lattice. A is the transform of the series over the root of
/// the density that is expected at its bin, so that E|A|^2 = 1 if the field is as expected.
class FieldAmplitudes {
 public:
  /// expected_density: [bin] [m^2/s^2/Hz]; bins with 0 are left out. transform must outlive this.
  FieldAmplitudes(const GriddedWind& wind, int component, const GridSampling& sampling,
                  const BlockTransform& transform, const std::vector<double>& expected_density);

  /// Mean of |A|^2 over points, blocks and the bins of the band.
  double mean_power(const Band& band) const;
  /// sum Re(A_1 A_2*) / sqrt(sum |A_1|^2 sum |A_2|^2) over all pairs these steps apart.
  double coherence(const Band& band, LatticeSteps steps) const;

 private:
  double product(const Band& band, int point_1, int point_2) const;
  const std::complex<float>* row(int point, std::size_t block) const;

  Lattice lattice_;
  const BlockTransform& transform_;
  std::vector<std::complex<float>> values_;  // [point][block][bin]
};

}  // namespace lac::sim
