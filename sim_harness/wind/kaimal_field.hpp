// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/kaimal.hpp"
#include "sim_harness/wind/gridded_wind.hpp"

namespace lac::sim {

/// What connects v, and w, of different points. IEC gives a coherence for u only; the choice moves
/// the cut-off frequency of a multi-beam lidar by up to 10 % (methods section 1): say which one
/// was used with every result.
enum class LateralCoherence {
  kIndependent,  // no connection: the text of IEC, TurbSim's default
  kSameAsU,      // the coherence of u: what the frequency-domain correlation codes assume
};

struct KaimalFieldParams {
  KaimalModel model = iec_kaimal(3.056, 90.0);  // class A at 18 m/s
  double mean_speed_mps = 18.0;                 // U at hub height
  double hub_height_m = 90.0;                   // centre of the grid
  double shear_exponent = 0.0;                  // U (z / z_hub)^exponent; IEC has 0.2
  double width_m = 140.0;
  double height_m = 140.0;
  int ny = 27;
  int nz = 27;
  double dt_s = 0.1;
  double duration_s = 660.0;  // the period: the field repeats after it
  std::uint64_t seed = 1;
  LateralCoherence lateral_coherence = LateralCoherence::kIndependent;
  int threads = 2;  // changes the time taken, not one bit of the field
};

/// A periodic turbulent field with Kaimal spectra and exponential yz-coherence (methods sections
/// 1 and 15): per point and component u(t) = sum over m = 1..nt/2 of Re{A_m exp(i 2 pi m t / T)}.
///
/// - A_m are complex normal over points with the model's root coherence, not random phases on
///   fixed moduli: variances scatter from seed to seed as they do in nature.
/// - E|A_m|^2 / 2 is the spectrum integrated over (m -+ 1/2) / T. The expected variance is thus the
///   closed form between 1/(2 T) and half a step above the Nyquist frequency, and a few percent
///   below sigma^2; nothing is rescaled. Frequency zero is the mean profile.
/// - u, v and w are independent of each other.
/// - The same parameters and seed give the same field, to the last bit on one machine.
///
/// Cost: 2-D transforms per frequency and transforms in time; a period nt with prime factors above
/// 5 is slower. Peak memory: the field (12 bytes per point and step) plus a third of it.
/// Throws lac::Error on parameters out of range, or if the coherence cannot be factored.
GriddedWind make_kaimal_field(const KaimalFieldParams& params);

}  // namespace lac::sim
