// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/mann_cells.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr double kNearCells = 6.0;
constexpr double kGaussNode[] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                 0.8611363115940526};
constexpr double kGaussWeight[] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                   0.3478548451374538};

double mesh_point(int m) {
  return std::cos(kPi * m / (FoldedImages::kMesh - 1));
}

/// Of the polynomial through values at the mesh points, at x in [-1, 1].
std::array<double, FoldedImages::kMesh> mesh_weights(double x) {
  std::array<double, FoldedImages::kMesh> weights;
  for (int m = 0; m < FoldedImages::kMesh; ++m) {
    weights[m] = 1.0;
    for (int i = 0; i < FoldedImages::kMesh; ++i) {
      if (i != m) weights[m] *= (x - mesh_point(i)) / (mesh_point(m) - mesh_point(i));
    }
  }
  return weights;
}

}  // namespace

CellIntegrals::CellIntegrals(const MannTensor& tensor, double k1_radpm, double dk2_radpm,
                             double dk3_radpm)
    : tensor_(tensor),
      evolves_(std::isfinite(tensor.params().evolution_s)),
      k1_(k1_radpm),
      dk2_(dk2_radpm),
      dk3_(dk3_radpm),
      near_(kNearCells * std::max(dk2_, dk3_)) {
  if (k1_ >= near_) return;
  for (int j = 0; j * dk2_ < near_; ++j) nodes2_.push_back(axis_cell(dk2_, j));
  for (int j = 0; j * dk3_ < near_; ++j) nodes3_.push_back(axis_cell(dk3_, j));
}

/// Gauss points on k = s sinh(t), s = 0.3 k1; of cell 0 the upper half.
std::vector<CellIntegrals::Node> CellIntegrals::axis_cell(double dk, int j) const {
  const int panels = j == 0 ? 4 : 1;
  const double s = 0.3 * k1_, begin = j == 0 ? 0.0 : std::asinh((j - 0.5) * dk / s);
  const double half = 0.5 * (std::asinh((j + 0.5) * dk / s) - begin) / panels;
  std::vector<Node> nodes;
  for (int p = 0; p < panels; ++p) {
    for (int i = 0; i < 4; ++i) {
      const double t = begin + half * (2 * p + 1 + kGaussNode[i]);
      nodes.push_back({s * std::sinh(t), s * std::cosh(t) * half * kGaussWeight[i]});
    }
  }
  return nodes;
}

CellSums CellIntegrals::at(double k2, double k3) const {
  const SpectralTensor t = tensor_(k1_, k2, k3);
  CellSums sums{};
  std::ranges::copy(t, sums.begin());
  if (evolves_) {
    const double k = std::sqrt(k1_ * k1_ + k2 * k2 + k3 * k3);
    sums[kTensorSize] = (t[kUu] + t[kVv] + t[kWw]) * tensor_.evolution_time_s(k);
  }
  return sums;
}

CellSums CellIntegrals::centre(double k2_radpm, double k3_radpm) const {
  CellSums sums = at(k2_radpm, k3_radpm);
  for (double& value : sums) value *= dk2_ * dk3_;
  return sums;
}

CellSums CellIntegrals::cell(int j2, int j3) const {
  const double k2 = j2 * dk2_, k3 = j3 * dk3_;
  const bool near = k1_ * k1_ + k2 * k2 + k3 * k3 < near_ * near_;
  return near ? near_cell(j2, j3) : centre(k2, k3);
}

CellSums CellIntegrals::near_cell(int j2, int j3) const {
  CellSums sum{};
  for (const Node& a : nodes2_[std::abs(j2)]) {
    for (const Node& b : nodes3_[std::abs(j3)]) {
      const double weight = a.weight_radpm * b.weight_radpm;
      if (j3 >= 0) add(weight, at(a.k_radpm, b.k_radpm), sum);
      if (j3 <= 0) add(weight, at(a.k_radpm, -b.k_radpm), sum);
    }
  }
  const double odd = j2 == 0 ? 0.0 : j2 < 0 ? -1.0 : 1.0, even = j2 == 0 ? 2.0 : 1.0;
  for (int q = 0; q <= kTensorSize; ++q) sum[q] *= q == kUv || q == kVw ? odd : even;
  return sum;
}

/// (k2, k3) = r (edge2, edge3) along the four sides, r = x^(-3/5) since the tensor falls with
/// k^(-11/3).
CellSums CellIntegrals::beyond(double edge2, double edge3) const {
  CellSums sum{};
  for (int i = 0; i < 4; ++i) {
    const double x = 0.5 * (1.0 + kGaussNode[i]), r = std::pow(x, -0.6);
    const double radial = 0.5 * kGaussWeight[i] * 0.6 * r / x * r * edge2 * edge3;
    for (int j = 0; j < 4; ++j) {
      const double t = kGaussNode[j], weight = radial * kGaussWeight[j];
      add(2.0 * weight, at(r * edge2, r * edge3 * t), sum);
      add(weight, at(r * edge2 * t, r * edge3), sum);
      add(weight, at(r * edge2 * t, -r * edge3), sum);
    }
  }
  sum[kUv] = sum[kVw] = 0.0;
  return sum;
}

FoldedImages::FoldedImages(const CellIntegrals& integrals, int ny, int nz) : nz_(nz) {
  const double period2 = ny * integrals.dk2_radpm(), period3 = nz * integrals.dk3_radpm();
  far_ = integrals.beyond(1.5 * period2, 1.5 * period3);
  for (double& value : far_) value /= static_cast<double>(ny) * nz;
  for (int j2 = 0; j2 <= ny / 2; ++j2) weights2_.push_back(mesh_weights(2.0 * j2 / ny));
  for (int j3 = -nz / 2; j3 <= nz / 2; ++j3) weights3_.push_back(mesh_weights(2.0 * j3 / nz));
  for (int m3 = 0; m3 < kMesh; ++m3) {
    for (int m2 = 0; m2 < kMesh; ++m2) {
      CellSums& sum = mesh_[m3][m2];
      sum = {};
      for (int i = 0; i < 9; ++i) {
        const double k2 = period2 * (0.5 * mesh_point(m2) + i % 3 - 1);
        const double k3 = period3 * (0.5 * mesh_point(m3) + i / 3 - 1);
        if (i != 4) add(1.0, integrals.centre(k2, k3), sum);
      }
    }
  }
}

FoldedImages::Row FoldedImages::row(int j3) const {
  const Weights& weights = weights3_[j3 + nz_ / 2];
  Row row{};
  for (int m3 = 0; m3 < kMesh; ++m3) {
    for (int m2 = 0; m2 < kMesh; ++m2) add(weights[m3], mesh_[m3][m2], row[m2]);
  }
  return row;
}

CellSums FoldedImages::at(const Row& row, int j2) const {
  CellSums sum = far_;
  for (int m2 = 0; m2 < kMesh; ++m2) add(weights2_[j2][m2], row[m2], sum);
  return sum;
}

}  // namespace lac::sim
