// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "sim_harness/wind/evolving_wind.hpp"
#include "sim_harness/wind/mann_box.hpp"

namespace lac::sim {

struct MannFieldParams {
  MannParams model;
  double mean_speed_mps = 18.0;  // U at hub height
  double hub_height_m = 90.0;    // centre of the grid
  double shear_exponent = 0.0;   // of the mean profile U (z / z_hub)^exponent
  double width_m = 140.0;        // of what is handed out; the box is wider
  double height_m = 140.0;
  int ny = 27;
  int nz = 27;
  /// Points of the box, in which the field repeats: even, at least ny and nz. 0: the next length
  /// from 2.5 times as many that transforms are fast at. See MannBox on what the period does.
  int box_ny = 0;
  int box_nz = 0;
  double dt_s = 0.1;
  double duration_s = 660.0;  // the period: the field repeats after it
  std::uint64_t seed = 1;
  SmallEddies small_eddies = SmallEddies::kFolded;
  bool rescale = false;  // each component to the variance of the tensor
  int threads = 2;       // changes the time taken, not one bit of the field
};

/// Expected variances (and covariances) [m^2/s^2] of a generated field: of the tensor, over all
/// wavenumbers, and what the box has of them without rescaling.
struct MannVariance {
  SpectralTensor tensor;
  SpectralTensor box;
};

/// Draws turbulence with Mann's tensor on a periodic box (methods section 16), one y-z plane over
/// time after the other on its way from the rotor up-wind.
///
///   u(x) = sum over k of e^(i k x) C(k) n(k),   C C^T = integral of Phi over the cell times dk1
///
/// - n are independent complex normal numbers, not phases on fixed moduli; they belong to the k1 >
/// 0
///   half, the other one is its conjugate. k1 = 0 is left out: it is the mean profile.
/// - Time: the box travels down-wind, so the plane with the largest x comes first, and u(t) at the
///   rotor plane is u(x = -U t).
/// - Evolution: planes at distances d have n_(p+1) = rho n_p + sqrt(1 - rho^2) n' (every one has
/// the
///   statistics of the tensor, any two of them its space-time extension), with
///   rho = exp(-(d_(p+1) - d_p) / (U tau_e)) and tau_e of the cell.
/// - The same parameters and seed give the same field, to the last bit on one machine. Numbers are
///   drawn per plane and k1.
///
/// Cost: per k1 one pass over the box and 2-D transforms, then transforms in time of the points
/// wanted; lengths with prime factors above 5 are slower. Peak memory: a plane handed out (12 bytes
/// per point and step; it is transformed in place) and, with evolution, 12 bytes per point of the
/// box and step, whatever the number of planes.
class MannPlanes {
 public:
  /// Throws lac::Error on parameters out of range.
  explicit MannPlanes(const MannFieldParams& params);

  /// The field at this distance up-wind [m]: the first at 0, then rising. Throws lac::Error if not.
  GriddedWind next(double distance_m);
  /// Back to the rotor, for a field of another seed.
  void restart(std::uint64_t seed);

  const MannBox& box() const { return box_; }
  MannVariance variance() const;

 private:
  class RowWorker;

  GridSpec grid_spec() const;
  double k1_radpm(int m) const;

  MannFieldParams params_;
  MannBox box_;
  std::array<float, 3> scale_;              // of u, v and w
  int planes_ = 0;                          // handed out
  double distance_m_ = 0.0;                 // of the last one
  double lead_s_ = 0.0;                     // from it to the one in work
  std::vector<std::complex<float>> noise_;  // n of the last plane, [k1][component][k3][k2]
};

/// The rotor plane alone: frozen turbulence.
GriddedWind make_mann_field(const MannFieldParams& params);

/// Planes at the rotor and at these distances up-wind (above 0, rising), all of them in memory.
EvolvingWind make_evolving_mann_field(const MannFieldParams& params,
                                      std::span<const double> distances_m);

}  // namespace lac::sim
