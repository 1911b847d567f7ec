// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/mann_theory.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/units.hpp"

namespace lac::sim {
namespace {

constexpr double kLogFirst = -3.0;  // log10(k1 L)
constexpr double kPerDecade = 12.0;
constexpr int kSteps = 85;
constexpr int kNodes = 301;

double at(const std::vector<std::array<double, 3>>& table, int component, double step) {
  const int i = std::clamp(static_cast<int>(std::floor(step)), 0, kSteps - 2);
  const double t = step - i;
  const auto value = [&](int k) {
    return table[static_cast<std::size_t>(k)][static_cast<std::size_t>(component)];
  };
  const double y1 = value(i), y2 = value(i + 1);
  if (i == 0 || i == kSteps - 2 || t < 0.0 || t > 1.0) return y1 + t * (y2 - y1);
  const double y0 = value(i - 1), y3 = value(i + 2);
  return y1 + 0.5 * t *
                  (y2 - y0 +
                   t * (2.0 * y0 - 5.0 * y1 + 4.0 * y2 - y3 + t * (3.0 * (y1 - y2) + y3 - y0)));
}

}  // namespace

MannTheory::MannTheory(const MannParams& params, double mean_speed_mps)
    : tensor_(params), mean_speed_mps_(mean_speed_mps) {
  for (int i = 0; i < kSteps; ++i) {
    const double k1_radpm = std::pow(10.0, kLogFirst + i / kPerDecade) / params.length_m;
    const SpectralTensor f = tensor_.spectra(k1_radpm, kNodes);
    log_spectra_.push_back({std::log(f[kUu]), std::log(f[kVv]), std::log(f[kWw])});
  }
}

double MannTheory::spectrum(int component, double frequency_hz) const {
  const double per_hz = 2.0 * kPi / mean_speed_mps_;
  const double log_kl = std::log10(frequency_hz * per_hz * tensor_.params().length_m);
  return 2.0 * per_hz * std::exp(at(log_spectra_, component, (log_kl - kLogFirst) * kPerDecade));
}

/// The double Fourier integral, k2 first: a diagonal component is even in k2, so cosines over half
/// of the nodes do.
CoherencyTable MannTheory::coherencies(int component, double frequency_hz,
                                       const Lattice& lattice) const {
  const double k1_radpm = 2.0 * kPi * frequency_hz / mean_speed_mps_;
  const SinhNodes nodes(k1_radpm, tensor_.params().length_m, kNodes);
  const std::size_t n = nodes.k_radpm.size(), zero = n / 2;
  const auto ny = static_cast<std::size_t>(lattice.ny);
  std::vector<double> cosines(n * ny), row(ny);
  for (std::size_t i = zero; i < n; ++i) {
    const double weight = (i == zero ? 1.0 : 2.0) * nodes.weight_radpm[i];
    for (std::size_t y = 0; y < ny; ++y) {
      const double phase_rad = nodes.k_radpm[i] * static_cast<double>(y) * lattice.dy_m;
      cosines[i * ny + y] = weight * std::cos(phase_rad);
    }
  }
  CoherencyTable table(lattice);
  for (std::size_t j = 0; j < n; ++j) {
    std::fill(row.begin(), row.end(), 0.0);
    for (std::size_t i = zero; i < n; ++i) {
      const double phi = tensor_(k1_radpm, nodes.k_radpm[i],
                                 nodes.k_radpm[j])[static_cast<std::size_t>(component)];
      for (std::size_t y = 0; y < ny; ++y) row[y] += phi * cosines[i * ny + y];
    }
    for (int z = 1 - lattice.nz; z < lattice.nz; ++z) {
      const auto turn = std::polar(nodes.weight_radpm[j], nodes.k_radpm[j] * z * lattice.dz_m);
      for (int y = 0; y < lattice.ny; ++y)
        table.at(y, z) += row[static_cast<std::size_t>(y)] * turn;
    }
  }
  const double one_point = table.at(0, 0).real();
  for (int z = 1 - lattice.nz; z < lattice.nz; ++z) {
    for (int y = 0; y < lattice.ny; ++y) {
      table.at(y, z) /= one_point;
      table.at(-y, z) = table.at(y, z);
    }
  }
  return table;
}

std::string MannTheory::name() const {
  const MannParams& p = tensor_.params();
  std::ostringstream text;
  text.precision(4);
  text << "Mann, alpha epsilon^(2/3) " << p.alpha_epsilon << " m^(4/3)/s^2, L " << p.length_m
       << " m, Gamma " << p.gamma << ", eddy lifetime of "
       << (p.lifetime == EddyLifetime::kMann ? "Mann" : "Guo");
  return text.str();
}

}  // namespace lac::sim
