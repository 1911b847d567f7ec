// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "sim_harness/wind/evolving_wind.hpp"
#include "sim_harness/wind/mann_source.hpp"
#include "sim_harness/wind/plane_drawing.hpp"

namespace lac::sim {

/// Draws turbulence with Mann's tensor on a periodic box (methods section 16), one y-z plane over
/// time after the other on its way from the rotor up-wind.
///
///   u(x) = sum over k of e^(i k x) C(k) n(k),   C C^T = integral of Phi over the cell times dk1
///
/// - n are independent complex normal numbers, not phases on fixed moduli; they belong to the half
///   k1 > 0, the other half is its conjugate. k1 = 0 is left out: it is the mean profile.
/// - Time: the box travels down-wind, so the plane with the largest x comes first, and u(t) at the
///   rotor plane is u(x = -U t).
/// - Evolution: planes at distances d have n_(p+1) = rho n_p + sqrt(1 - rho^2) n' with
///   rho = exp(-(d_(p+1) - d_p) / (U tau_e)) and tau_e of the cell. So every plane has the
///   statistics of the tensor, any two of them those of its space-time extension.
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

  const MannBox& box() const { return source_.box(); }
  MannVariance variance() const { return source_.variance(); }

 private:
  class RowWorker;

  MannSource source_;
  std::uint64_t seed_;
  PlaneSequence planes_;
  std::vector<std::complex<float>> noise_;  // n of the last plane, [k1][component][k3][k2]
};

/// The rotor plane alone: frozen turbulence.
GriddedWind make_mann_field(const MannFieldParams& params);

/// All planes of a layout at once, thinned to what is demanded (nullptr: whole): the numbers that
/// MannPlanes gives, drawn for one k1 in all planes before the next k1, so that no noise is kept.
/// Peak memory: what is returned. Planes behind the last one of which something is demanded are not
/// drawn. Throws lac::Error on parameters out of range.
EvolvingGrids draw_evolving_mann(const MannFieldParams& params, const PlaneLayout& layout,
                                 const WindDemand* demand = nullptr);

}  // namespace lac::sim
