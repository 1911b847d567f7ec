// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "sim_harness/wind/evolving_grids.hpp"
#include "sim_harness/wind/gridded_wind.hpp"
#include "sim_harness/wind/kaimal_source.hpp"
#include "sim_harness/wind/plane_drawing.hpp"

namespace lac::sim {

/// How well a field has the coherence of the model.
struct KaimalReport {
  /// The largest difference of the root coherence at any frequency and pair of points: an upper
  /// bound, from the eigenvalues; at most kCoherenceTolerance.
  double coherence_error = 0.0;
  double frequency_hz = 0.0;  // where
};

/// Draws turbulence with Kaimal spectra and exponential coherence (methods sections 1, 3 and 15),
/// one y-z plane over time after the other on its way from the rotor up-wind: per point and
/// component u(t) = sum over m = 1..nt/2 of Re{A_m exp(i 2 pi m t / T)}, periodic.
///
/// - A_m are complex normal over points with the model's root coherence, not random phases on
///   fixed moduli: variances scatter from seed to seed as they do in nature.
/// - E|A_m|^2 / 2 is the spectrum integrated over (m -+ 1/2) / T. The expected variance is thus the
///   closed form between 1/(2 T) and half a step above the Nyquist frequency, and a few percent
///   below sigma^2; nothing is rescaled. Frequency zero is the mean profile.
/// - u, v and w are independent of each other.
/// - Evolution: planes at distances d have A_(p+1) = rho A_p + sqrt(1 - rho^2) A' (each has the
///   statistics of the first, any two of them the product of the coherences across and along the
///   wind), with rho the root coherence over d_(p+1) - d_p. It is the same for u, v and w: v and w
///   of one (y, z) are connected along the wind in both lateral conventions.
/// - The same parameters and seed give the same field, to the last bit on one machine. Numbers are
///   drawn per plane, component and frequency.
///
/// Cost: 2-D transforms per frequency of 1.3 to 15 times the points (most 1.3 to 2.3 times), and
/// transforms in time; a period nt with prime factors above 5 is slower. Peak memory: the plane
/// handed out (12 bytes per point and step; it is transformed in place) and, with evolution, as
/// much for the amplitudes, whatever the number of planes.
class KaimalPlanes {
 public:
  /// Throws lac::Error on parameters out of range.
  explicit KaimalPlanes(const KaimalFieldParams& params);

  /// The field at this distance up-wind [m]: the first at 0, then rising. Throws lac::Error if not,
  /// or if the coherence cannot be reached within kCoherenceTolerance.
  GriddedWind next(double distance_m);
  /// Back to the rotor, for a field of another seed.
  void restart(std::uint64_t seed);

  /// Of the planes handed out.
  KaimalReport report() const;

 private:
  class RowWorker;

  KaimalSource source_;
  std::uint64_t seed_;
  PlaneSequence planes_;
  std::vector<std::complex<float>> amplitudes_;  // of the last plane, [m - 1][component][z][y]
  std::vector<double> coherence_error_;          // [m - 1]
};

/// The rotor plane alone: frozen turbulence.
GriddedWind make_kaimal_field(const KaimalFieldParams& params);

/// All planes of a layout at once, thinned to what is demanded (nullptr: whole): the numbers that
/// KaimalPlanes gives, drawn for one frequency in all planes before the next one, so that no
/// amplitudes are kept. Peak memory: what is returned. Planes behind the last one of which
/// something is demanded are not drawn. Throws lac::Error on parameters out of range.
EvolvingGrids draw_evolving_kaimal(const KaimalFieldParams& params, const PlaneLayout& layout,
                                   const WindDemand* demand = nullptr);

}  // namespace lac::sim
