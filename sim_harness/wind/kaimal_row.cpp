// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/kaimal_row.hpp"

#include <cmath>

#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

PlaneGrid plane_of(const GridSpec& grid) {
  return {grid.ny, grid.nz, grid.dy_m, grid.dz_m};
}

}  // namespace

KaimalRow::KaimalRow(const KaimalSource& source)
    : source_(source), sampler_(plane_of(source.grid())), drawn_(source.grid().plane_points()) {}

void KaimalRow::select(int m) {
  m_ = m;
  const double rate = source_.coherence_rate(m);
  require(sampler_.prepare(rate), "Kaimal field", "coherence rate [1/m]", rate,
          "one whose coherence can be drawn");
}

void KaimalRow::draw(int component, ComplexNormal normal) {
  if (source_.coherent(component)) {
    sampler_.sample(normal, drawn_);
  } else {
    for (auto& a : drawn_) a = normal();
  }
}

void KaimalRow::draw(std::uint64_t seed, std::span<Complex> amplitudes) {
  for (int c = 0; c < 3; ++c) {
    draw(c, ComplexNormal(seed, c, m_));
    const double scale_mps = source_.scale_mps(c, m_);
    Complex* to = amplitudes.data() + c * drawn_.size();
    for (std::size_t i = 0; i < drawn_.size(); ++i) to[i] = Complex(scale_mps * drawn_[i]);
  }
}

void KaimalRow::evolve(double dx_m, std::uint64_t seed, std::size_t plane,
                       std::span<Complex> amplitudes) {
  const double rho = source_.root_coherence(dx_m, m_);
  const auto kept = static_cast<float>(rho);
  for (int c = 0; c < 3; ++c) {
    draw(c, ComplexNormal(seed, 3 * plane + c, m_));
    const double renewed_mps = std::sqrt(1.0 - rho * rho) * source_.scale_mps(c, m_);
    Complex* to = amplitudes.data() + c * drawn_.size();
    for (std::size_t i = 0; i < drawn_.size(); ++i)
      to[i] = kept * to[i] + Complex(renewed_mps * drawn_[i]);
  }
}

}  // namespace lac::sim
