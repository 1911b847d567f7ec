// SPDX-License-Identifier: Apache-2.0
// Integrals of Mann's tensor over the cells of a box, at one k1. Cell (j2, j3) is
// (j2 -+ 1/2) dk2, (j3 -+ 1/2) dk3.
#pragma once

#include <array>
#include <vector>

#include "core/mann_tensor.hpp"

namespace lac::sim {

/// Tensor [m^3/s^2] and, behind it, energy times tau_e (0 for frozen turbulence).
using CellSums = std::array<double, kTensorSize + 1>;

inline void add(double weight, const CellSums& t, CellSums& sum) {
  for (std::size_t q = 0; q < t.size(); ++q) sum[q] += weight * t[q];
}

class CellIntegrals {
 public:
  CellIntegrals(const MannTensor& tensor, double k1_radpm, double dk2_radpm, double dk3_radpm);

  double dk2_radpm() const { return dk2_; }
  double dk3_radpm() const { return dk3_; }

  /// Within six cell widths of the origin by Gauss points on the sinh scale of k1, else centre
  /// times area.
  CellSums cell(int j2, int j3) const;
  /// Centre times area, of a cell at (k2, k3).
  CellSums centre(double k2_radpm, double k3_radpm) const;
  /// Everything outside |k2| <= edge2, |k3| <= edge3.
  CellSums beyond(double edge2_radpm, double edge3_radpm) const;

 private:
  struct Node {
    double k_radpm;
    double weight_radpm;
  };

  CellSums at(double k2, double k3) const;
  CellSums near_cell(int j2, int j3) const;
  std::vector<Node> axis_cell(double dk, int j) const;

  const MannTensor& tensor_;
  bool evolves_;
  double k1_;
  double dk2_;
  double dk3_;
  double near_;
  std::vector<std::vector<Node>> nodes2_;  // of cells j >= 0 near the origin
  std::vector<std::vector<Node>> nodes3_;
};

/// What sampling folds into the cells of a grid: energy beyond its Nyquist wavenumbers. The sum
/// over the eight neighbour images is smooth; it is taken on a mesh of 9 x 9 Chebyshev points
/// (error 1e-4 of it at the rim and less inside). What is beyond them spreads evenly.
class FoldedImages {
 public:
  static constexpr int kMesh = 9;
  /// Sums at one k3, at the mesh points of k2.
  using Row = std::array<CellSums, kMesh>;

  FoldedImages(const CellIntegrals& integrals, int ny, int nz);

  Row row(int j3) const;                      // |j3| <= nz/2
  CellSums at(const Row& row, int j2) const;  // 0 <= j2 <= ny/2

 private:
  using Weights = std::array<double, kMesh>;

  int nz_;
  std::vector<Weights> weights2_;  // of j2 = 0..ny/2
  std::vector<Weights> weights3_;  // of j3 = -nz/2..nz/2
  CellSums far_;
  std::array<Row, kMesh> mesh_;
};

}  // namespace lac::sim
