// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "core/mann_tensor.hpp"
#include "sim_harness/design/lidar_volumes.hpp"

namespace lac::sim {

/// Of u, v, w: sum over the volumes of a plane of n/n_x phi^(k.n) e^(i k.x).
using PlaneSum = std::array<std::complex<double>, 3>;

/// Probe volumes in the space of wave vectors, planes in a row from the farthest to the nearest.
/// Phases and weightings that belong to one wavenumber alone, or to all volumes of a beam, are
/// computed once.
class VolumeRow {
 public:
  /// The nodes are those of k2 and of k3; lidar and nodes must outlive this.
  VolumeRow(const LidarVolumes& lidar, const SinhNodes& nodes, double k1_radpm);

  /// The wave vector k1, node i2 of k2, node i3 of k3 that plane_sum() is of.
  void set_wave(std::size_t i2, std::size_t i3);
  /// Planes counted from the farthest.
  PlaneSum plane_sum(std::size_t plane) const;

 private:
  struct Probe {
    Vec3 beam_W;
    double range_m;
    double filter = 1.0;  // at this wave vector
  };
  struct Volume {
    Vec3 weight;
    std::size_t probe;
    std::vector<std::complex<double>> across;   // e^(i (k1 x + k2 y)), at each node of k2
    std::vector<std::complex<double>> upwards;  // e^(i k3 z)
  };

  void add(const ProbeVolume& volume);
  std::size_t probe_of(const ProbeVolume& volume);

  const LidarVolumes& lidar_;
  const SinhNodes& nodes_;
  double k1_radpm_;
  std::size_t i2_ = 0, i3_ = 0;
  std::vector<Volume> volumes_;
  std::vector<std::size_t> end_of_plane_;
  std::vector<Probe> probes_;
};

/// Left and right of the lidar are alike: the spectra need the k2 of one sign alone.
bool is_mirrored(const LidarVolumes& lidar);

}  // namespace lac::sim
