// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/volume_row.hpp"

#include <algorithm>

namespace lac::sim {
namespace {

using Complex = std::complex<double>;

constexpr double kSameDirection = 1e-12;
constexpr double kSamePlace_m = 1e-6;

bool is_mirror_of(const ProbeVolume& a, const ProbeVolume& b) {
  const Vec3 turned{a.beam_W.x, -a.beam_W.y, a.beam_W.z};
  const Vec3 place{a.centre_W.x, -a.centre_W.y, a.centre_W.z};
  return norm(turned - b.beam_W) < kSameDirection && norm(place - b.centre_W) < kSamePlace_m;
}

}  // namespace

VolumeRow::VolumeRow(const LidarVolumes& lidar, const SinhNodes& nodes, double k1_radpm)
    : lidar_(lidar), nodes_(nodes), k1_radpm_(k1_radpm) {
  for (auto plane = lidar.planes.rbegin(); plane != lidar.planes.rend(); ++plane) {
    for (const ProbeVolume& v : plane->volumes) add(v);
    end_of_plane_.push_back(volumes_.size());
  }
}

void VolumeRow::add(const ProbeVolume& v) {
  Volume volume{v.weight, probe_of(v), {}, {}};
  for (const double k : nodes_.k_radpm) {
    volume.across.push_back(std::polar(1.0, k1_radpm_ * v.centre_W.x + k * v.centre_W.y));
    volume.upwards.push_back(std::polar(1.0, k * v.centre_W.z));
  }
  volumes_.push_back(std::move(volume));
}

/// The volumes of one beam are alike unless their length depends on the range.
std::size_t VolumeRow::probe_of(const ProbeVolume& v) {
  const bool any_range = lidar_.weighting.kind != ProbeKind::kLorentzian;
  const auto found = std::ranges::find_if(probes_, [&](const Probe& p) {
    return norm(p.beam_W - v.beam_W) < kSameDirection && (any_range || p.range_m == v.range_m);
  });
  if (found != probes_.end()) return static_cast<std::size_t>(found - probes_.begin());
  probes_.push_back({v.beam_W, v.range_m});
  return probes_.size() - 1;
}

void VolumeRow::set_wave(std::size_t i2, std::size_t i3) {
  i2_ = i2, i3_ = i3;
  const Vec3 k{k1_radpm_, nodes_.k_radpm[i2], nodes_.k_radpm[i3]};
  for (Probe& p : probes_) p.filter = lidar_.transform(dot(k, p.beam_W), p.range_m);
}

PlaneSum VolumeRow::plane_sum(std::size_t plane) const {
  PlaneSum a{};
  for (std::size_t i = plane == 0 ? 0 : end_of_plane_[plane - 1]; i < end_of_plane_[plane]; ++i) {
    const Volume& v = volumes_[i];
    const Complex p = v.across[i2_], q = v.upwards[i3_];
    const double filter = probes_[v.probe].filter;  // the product without its case for infinities
    const double re = filter * (p.real() * q.real() - p.imag() * q.imag());
    const double im = filter * (p.real() * q.imag() + p.imag() * q.real());
    a[0] += Complex(v.weight.x * re, v.weight.x * im);
    a[1] += Complex(v.weight.y * re, v.weight.y * im);
    a[2] += Complex(v.weight.z * re, v.weight.z * im);
  }
  return a;
}

bool is_mirrored(const LidarVolumes& lidar) {
  return std::ranges::all_of(lidar.planes, [](const LidarPlane& plane) {
    return std::ranges::all_of(plane.volumes, [&](const ProbeVolume& a) {
      return std::ranges::any_of(plane.volumes,
                                 [&](const ProbeVolume& b) { return is_mirror_of(a, b); });
    });
  });
}

}  // namespace lac::sim
