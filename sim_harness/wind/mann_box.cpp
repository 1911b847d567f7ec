// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/mann_box.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "sim_harness/wind/mann_cells.hpp"
#include "sim_harness/wind/parallel_jobs.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "Mann box";
constexpr double kLogStep = 0.1;  // of the table over log k1

void check(const MannBoxSpec& s) {
  require(s.ny >= 2 && s.ny % 2 == 0, kWhere, "ny", s.ny, "an even number from 2");
  require(s.nz >= 2 && s.nz % 2 == 0, kWhere, "nz", s.nz, "an even number from 2");
  require_positive(kWhere, "dy_m", s.dy_m);
  require_positive(kWhere, "dz_m", s.dz_m);
  require_positive(kWhere, "k1_min_radpm", s.k1_min_radpm);
  require(std::isfinite(s.k1_max_radpm) && s.k1_max_radpm > s.k1_min_radpm, kWhere, "k1_max_radpm",
          s.k1_max_radpm, "a finite number above k1_min_radpm");
  require(s.threads >= 1, kWhere, "threads", s.threads, "at least 1");
}

bool is_odd_in_k2(int quantity) {
  return quantity == kUv || quantity == kVw;
}

/// Index of the discrete transform to signed index; n/2 to -n/2.
int signed_index(int j, int n) {
  return j < n / 2 ? j : j - n;
}

}  // namespace

/// Fills the rows of nodes.
class MannBox::Filler {
 public:
  Filler(const MannTensor& tensor, MannBox& box)
      : tensor_(tensor),
        box_(box),
        dk2_(2.0 * kPi / (box.spec_.ny * box.spec_.dy_m)),
        dk3_(2.0 * kPi / (box.spec_.nz * box.spec_.dz_m)) {}

  void operator()(int node) const {
    const MannBoxSpec& s = box_.spec_;
    const CellIntegrals integrals(tensor_, box_.node_k1_radpm(node), dk2_, dk3_);
    const FoldedImages images(integrals, s.ny, s.nz);
    const double folded = s.small_eddies == SmallEddies::kFolded ? 1.0 : 0.0;
    float* row = box_.table_.data() + node * box_.row_size();
    for (int j = 0; j < s.nz; ++j) {
      const int j3 = signed_index(j, s.nz);
      const FoldedImages::Row images_of_j3 = images.row(j3);
      for (int j2 = 0; j2 <= s.ny / 2; ++j2, ++row) {
        CellSums sums = integrals.cell(j2, j3);
        add(folded, images.at(images_of_j3, j2), sums);
        store(sums, j2 == 0 || 2 * j2 == s.ny, row);
      }
    }
  }

 private:
  /// At k2 = 0 and at the Nyquist wavenumber, which is its own image, odd quantities vanish.
  void store(const CellSums& sums, bool symmetric, float* row) const {
    for (int q = 0; q < kTensorSize; ++q) {
      const double value = symmetric && is_odd_in_k2(q) ? 0.0 : sums[q];
      row[q * box_.cells_] = static_cast<float>(value);
    }
    if (box_.quantities_ > kTensorSize) {
      const double energy = sums[kUu] + sums[kVv] + sums[kWw];
      row[kTensorSize * box_.cells_] = static_cast<float>(sums[kTensorSize] / energy);
    }
  }

  const MannTensor& tensor_;
  MannBox& box_;
  double dk2_;
  double dk3_;
};

MannBox::MannBox(const MannTensor& tensor, const MannBoxSpec& spec) : spec_(spec) {
  check(spec_);
  cells_ = static_cast<std::size_t>(spec_.nz) * (spec_.ny / 2 + 1);
  quantities_ = std::isfinite(tensor.params().evolution_s) ? kTensorSize + 1 : kTensorSize;
  const double range = std::log(spec_.k1_max_radpm / spec_.k1_min_radpm);
  nodes_ = std::max(static_cast<int>(std::ceil(range / kLogStep)), 3) + 1;
  log_step_ = range / (nodes_ - 1);
  table_.resize(nodes_ * row_size());
  for_each_job(nodes_, spec_.threads, [&] { return Filler(tensor, *this); });
}

double MannBox::node_k1_radpm(int i) const {
  return spec_.k1_min_radpm * std::exp(i * log_step_);
}

void MannBox::row(double k1_radpm, std::span<float> values) const {
  const double s = std::log(k1_radpm / spec_.k1_min_radpm) / log_step_;
  const int first = std::clamp(static_cast<int>(s) - 1, 0, nodes_ - 4);
  const double t = s - first;
  const auto a = static_cast<float>(-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0);
  const auto b = static_cast<float>(t * (t - 2.0) * (t - 3.0) / 2.0);
  const auto c = static_cast<float>(-t * (t - 1.0) * (t - 3.0) / 2.0);
  const auto d = static_cast<float>(t * (t - 1.0) * (t - 2.0) / 6.0);
  const std::size_t size = row_size();
  const float* v = table_.data() + first * size;
  for (std::size_t i = 0; i < size; ++i)
    values[i] = a * v[i] + b * v[i + size] + c * v[i + 2 * size] + d * v[i + 3 * size];
}

CrossSpectra MannBox::cross_spectra(double k1_radpm, int iy, int iz, double dt_s) const {
  std::vector<float> values(row_size());
  row(k1_radpm, values);
  CrossSpectra sum{};
  std::size_t cell = 0;
  for (int j3 = 0; j3 < spec_.nz; ++j3) {
    for (int j2 = 0; j2 <= spec_.ny / 2; ++j2, ++cell) {
      double weight = j2 == 0 || 2 * j2 == spec_.ny ? 1.0 : 2.0;
      if (quantities_ > kTensorSize)
        weight *= std::exp(-dt_s / values[kTensorSize * cells_ + cell]);
      const double angle2 = 2.0 * kPi * j2 * iy / spec_.ny;
      const std::complex<double> phase3 = std::polar(weight, 2.0 * kPi * j3 * iz / spec_.nz);
      for (int q = 0; q < kTensorSize; ++q) {
        const std::complex<double> phase2 =
            is_odd_in_k2(q) ? std::complex<double>(0.0, std::sin(angle2)) : std::cos(angle2);
        sum[q] += static_cast<double>(values[q * cells_ + cell]) * phase2 * phase3;
      }
    }
  }
  return sum;
}

SpectralTensor MannBox::spectra(double k1_radpm) const {
  std::vector<float> values(row_size());
  row(k1_radpm, values);
  SpectralTensor sum{};
  for (int q = 0; q < kTensorSize; ++q) {
    if (is_odd_in_k2(q)) continue;
    const float* value = values.data() + q * cells_;
    for (int j3 = 0; j3 < spec_.nz; ++j3) {
      for (int j2 = 0; j2 <= spec_.ny / 2; ++j2)
        sum[q] += *value++ * (j2 == 0 || 2 * j2 == spec_.ny ? 1.0 : 2.0);
    }
  }
  return sum;
}

}  // namespace lac::sim
