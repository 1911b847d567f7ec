// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/lidar/random_stream.hpp"

namespace lac::sim {

struct SpeedNoiseParams {
  double sigma_mps = 0.0;  // 0: off
  double doubling_cnr_db =
      -std::numeric_limits<double>::infinity();  // sigma is twice as large here
};

/// Map `speed_noise`: sigma_mps, doubling_cnr_db (without it sigma is fixed). Throws lac::Error.
SpeedNoiseParams read_speed_noise(YamlReader& in);

/// Gaussian noise of line-of-sight speeds, new for every gate and measurement:
///
///   sigma(CNR) = sigma (1 + 10^((CNR_2 - CNR)/10)),   CNR_2 = doubling_cnr_db
///
/// constant for strong signals, growing as 1/CNR for weak ones. It is the approximation of Rye and
/// Hardesty (1997, as O'Connor et al. 2010 have it) to the lower bound of spectral estimates, of
/// which CNR_2 = 10 log10(2 pi dv/B): dv width of the spectrum, B bandwidth, both as speeds.
class SpeedNoise {
 public:
  SpeedNoise(const SpeedNoiseParams& params, std::uint64_t seed)
      : params_(params), draw_(seed, LidarStream::kNoise) {}

  bool enabled() const noexcept { return params_.sigma_mps > 0.0; }
  double sigma_mps(double cnr_db) const noexcept;
  double draw_mps(double cnr_db) noexcept { return sigma_mps(cnr_db) * draw_.normal(); }

 private:
  SpeedNoiseParams params_;
  RandomStream draw_;
};

}  // namespace lac::sim
