// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/mann_tensor.hpp"

namespace lac::sim {

/// What becomes of eddies that are too small for the grid in y and z.
enum class SmallEddies {
  kFolded,  // stay, as in samples of a real field: spectra at the points are those of the tensor
  kCut,     // left out, as most generators do: spectra and variance are too low
};

/// A box that repeats in y and z, and a range of k1.
struct MannBoxSpec {
  int ny = 0;  // points per period, even
  int nz = 0;
  double dy_m = 0.0;
  double dz_m = 0.0;
  double k1_min_radpm = 0.0;  // above 0
  double k1_max_radpm = 0.0;
  SmallEddies small_eddies = SmallEddies::kFolded;
  int threads = 1;
};

/// Mann's tensor on the wave vectors of a box: for each k1 and each (k2, k3) of the discrete
/// Fourier transform its integral over the cell of that pair (methods section 16).
///
/// - Cells within six cell widths of the origin (in |k|, k1 included) are integrated with Gauss
///   points on the sinh scale of k1, the others by their centre. (The rule |k| L < 3 instead is
///   about the same where the period is a few L.)
/// - Folded: energy beyond the Nyquist wavenumbers is added where sampling puts it, so that
///   covariances between grid points are those of the continuous field: the eight neighbour images,
///   summed on a mesh, and what is beyond them evenly.
/// - In k1 the integrals are tabulated at logarithmic steps of 0.1 or below, with a cubic between.
///
/// What a period does to coherence: the covariance at a separation r is multiplied by
/// sinc(pi r / period) in y and z each (that is what a cell mean does) and gets the tails of the
/// images. Ask cross_spectra() how far that is from the tensor's.
class MannBox {
 public:
  /// Throws lac::Error on a box that is none.
  MannBox(const MannTensor& tensor, const MannBoxSpec& spec);

  const MannBoxSpec& spec() const { return spec_; }
  /// Cells of one k1: [k3 index 0..nz-1][k2 index 0..ny/2]; negative k2 by symmetry (uv and vw
  /// change sign).
  std::size_t cells() const { return cells_; }
  /// The six of the tensor [m^3/s^2] and, where turbulence evolves, the time scale tau_e [s] of the
  /// cell (mean with the energy as its weight).
  int quantities() const { return quantities_; }

  /// Numbers at k1 (within the range), [quantity][cell].
  void row(double k1_radpm, std::span<float> values) const;

  /// What the box has of F_ij(k1) at each of its points, [m^3/s^2], two-sided.
  SpectralTensor spectra(double k1_radpm) const;
  /// The same between points (iy, iz) steps and dt apart, as the fields made from it have it.
  CrossSpectra cross_spectra(double k1_radpm, int iy, int iz, double dt_s = 0.0) const;

 private:
  class Filler;

  double node_k1_radpm(int i) const;
  std::size_t row_size() const { return quantities_ * cells_; }

  MannBoxSpec spec_;
  std::size_t cells_;
  int quantities_;
  int nodes_;
  double log_step_;
  std::vector<float> table_;  // [node][quantity][cell]
};

}  // namespace lac::sim
