// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <string>

#include "core/kaimal.hpp"
#include "sim_harness/wind/kaimal_field.hpp"

namespace lac::sim {

/// Steps of a regular y-z lattice, and how many points it has.
struct Lattice {
  int ny = 0;
  int nz = 0;
  double dy_m = 0.0;
  double dz_m = 0.0;

  int points() const { return ny * nz; }
};

/// Root coherencies between points of a lattice, by their distance in steps: from a point to the
/// one `y` steps to the left and `z` steps above it; |y| < ny, |z| < nz.
class CoherencyTable {
 public:
  explicit CoherencyTable(const Lattice& lattice)
      : ny_(lattice.ny),
        nz_(lattice.nz),
        values_(static_cast<std::size_t>(2 * ny_ - 1) * (2 * nz_ - 1)) {}

  std::complex<double>& at(int y, int z) { return values_[index(y, z)]; }
  std::complex<double> at(int y, int z) const { return values_[index(y, z)]; }
  int ny() const { return ny_; }
  int nz() const { return nz_; }

 private:
  std::size_t index(int y, int z) const {
    return static_cast<std::size_t>(z + nz_ - 1) * (2 * ny_ - 1) + (y + ny_ - 1);
  }

  int ny_;
  int nz_;
  std::vector<std::complex<double>> values_;
};

/// Second-order statistics of homogeneous turbulence that passes a plane: component 0 u, 1 v, 2 w.
class TurbulenceTheory {
 public:
  virtual ~TurbulenceTheory() = default;

  /// One-sided density [m^2/s^2/Hz], f > 0.
  virtual double spectrum(int component, double frequency_hz) const = 0;

  /// E[X_1 X_2*] / S of one component between a point and others; X the transform of a series as
  /// sum x e^(-i 2 pi f t). Not squared; at (0, 0) it is 1.
  virtual CoherencyTable coherencies(int component, double frequency_hz,
                                     const Lattice& lattice) const = 0;

  /// For reports.
  virtual std::string name() const = 0;
};

/// Kaimal spectra with exponential coherence (core/kaimal.hpp).
class KaimalTheory final : public TurbulenceTheory {
 public:
  KaimalTheory(const KaimalModel& model, double mean_speed_mps, LateralCoherence lateral)
      : model_(model), mean_speed_mps_(mean_speed_mps), lateral_(lateral) {}

  double spectrum(int component, double frequency_hz) const override {
    const KaimalComponent& c = component == 0 ? model_.u : component == 1 ? model_.v : model_.w;
    return c.spectrum(frequency_hz, mean_speed_mps_);
  }

  CoherencyTable coherencies(int component, double frequency_hz,
                             const Lattice& lattice) const override {
    CoherencyTable table(lattice);
    const bool coherent = component == 0 || lateral_ == LateralCoherence::kSameAsU;
    for (int z = 1 - lattice.nz; z < lattice.nz; ++z) {
      for (int y = 1 - lattice.ny; y < lattice.ny; ++y) {
        const double r_m = std::hypot(y * lattice.dy_m, z * lattice.dz_m);
        const bool same = y == 0 && z == 0;
        table.at(y, z) =
            coherent || same ? model_.root_coherence(r_m, frequency_hz, mean_speed_mps_) : 0.0;
      }
    }
    return table;
  }

  std::string name() const override {
    return lateral_ == LateralCoherence::kSameAsU ? "Kaimal, v and w coherent as u"
                                                  : "Kaimal, v and w independent";
  }

 private:
  KaimalModel model_;
  double mean_speed_mps_;
  LateralCoherence lateral_;
};

}  // namespace lac::sim
