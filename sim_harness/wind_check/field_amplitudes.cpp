// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind_check/field_amplitudes.hpp"

#include <cmath>

namespace lac::sim {

std::vector<Band> log_bands(std::size_t first, std::size_t end, double per_decade) {
  std::vector<Band> bands;
  const auto number = [=](std::size_t bin) {
    return std::floor(per_decade * std::log10(static_cast<double>(bin)) + 1e-9);
  };
  for (std::size_t bin = first; bin < end; ++bin) {
    if (bands.empty() || number(bin) != number(bin - 1)) bands.push_back({bin, bin});
    bands.back().end = bin + 1;
  }
  return bands;
}

GridSampling sample_grid(const GridSpec& g, int most_points) {
  GridSampling s;
  for (;; ++s.stride) {
    s.lattice = {(g.ny - 1) / s.stride + 1, (g.nz - 1) / s.stride + 1, s.stride * g.dy_m,
                 s.stride * g.dz_m};
    if (s.lattice.points() <= most_points || s.lattice.ny == 2 || s.lattice.nz == 2) return s;
  }
}

FieldAmplitudes::FieldAmplitudes(const GriddedWind& wind, int component,
                                 const GridSampling& sampling, const BlockTransform& transform,
                                 const std::vector<double>& expected_density)
    : lattice_(sampling.lattice), transform_(transform) {
  const int nt = wind.grid().spec().nt, stride = sampling.stride;
  std::vector<double> series(static_cast<std::size_t>(nt));
  values_.reserve(transform.blocks() * transform.bins() * lattice_.points());
  for (int point = 0; point < lattice_.points(); ++point) {
    const int z = point / lattice_.ny, y = point % lattice_.ny;
    for (int it = 0; it < nt; ++it)
      series[it] = wind.grid().at(it, z * stride, y * stride, component);
    const std::vector<std::complex<double>> x = transform(series);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double density = expected_density[i % transform.bins()];
      values_.emplace_back(density > 0.0 ? x[i] / std::sqrt(density) : 0.0);
    }
  }
}

const std::complex<float>* FieldAmplitudes::row(int point, std::size_t block) const {
  const std::size_t at = static_cast<std::size_t>(point) * transform_.blocks() + block;
  return values_.data() + at * transform_.bins();
}

double FieldAmplitudes::product(const Band& band, int point_1, int point_2) const {
  double sum = 0.0;
  for (std::size_t b = 0; b < transform_.blocks(); ++b) {
    const std::complex<float>*a1 = row(point_1, b), *a2 = row(point_2, b);
    for (std::size_t k = band.first; k < band.end; ++k)
      sum += a1[k].real() * a2[k].real() + a1[k].imag() * a2[k].imag();
  }
  return sum;
}

double FieldAmplitudes::mean_power(const Band& band) const {
  double sum = 0.0;
  for (int p = 0; p < lattice_.points(); ++p) sum += product(band, p, p);
  return sum / (band.bins() * static_cast<double>(transform_.blocks()) * lattice_.points());
}

double FieldAmplitudes::coherence(const Band& band, LatticeSteps steps) const {
  double cross = 0.0, power_1 = 0.0, power_2 = 0.0;
  for (int z = 0; z + steps.z < lattice_.nz; ++z) {
    for (int y = 0; y + steps.y < lattice_.ny; ++y) {
      const int p1 = z * lattice_.ny + y, p2 = (z + steps.z) * lattice_.ny + y + steps.y;
      cross += product(band, p1, p2);
      power_1 += product(band, p1, p1);
      power_2 += product(band, p2, p2);
    }
  }
  return cross / std::sqrt(power_1 * power_2);
}

}  // namespace lac::sim
