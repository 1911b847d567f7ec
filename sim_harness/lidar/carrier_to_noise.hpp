// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/lidar/random_stream.hpp"

namespace lac::sim {

struct CarrierToNoiseParams {
  bool enabled = false;
  bool constant = false;      // over the range, as of a continuous-wave lidar
  double reference_db = 0.0;  // mean at the reference range
  double reference_range_m = 100.0;
  double focus_range_m = std::numeric_limits<double>::infinity();  // infinity: collimated
  double rayleigh_length_m = 0.0;  // pi D^2 / (4 lambda), D the beam's 1/e^2 diameter at the lens
  double extinction_per_km = 0.0;  // of the air, one way
  double scatter_db = 0.0;         // standard deviation, new for every gate and measurement
  double drift_db = 0.0;           // standard deviation, common to all gates
  double drift_time_s = 600.0;     // after which the drift has forgotten 63 % of itself
  double threshold_db = 0.0;       // below: gate invalid
};

/// Map `carrier_to_noise`: reference_db, threshold_db and, with defaults, over_range (pulsed;
/// constant, which leaves those of the range unused) and the others above. Throws lac::Error, also
/// for a drift_time_s without drift_db and a focus_range_m without rayleigh_length_m.
CarrierToNoiseParams read_carrier_to_noise(YamlReader& in);

/// Carrier-to-noise ratio of a pulsed lidar over the range R along the beam:
///
///   CNR(R) ~ exp(-2 alpha R) / (R^2 + z0^2 (1 - R/F)^2)
///
/// the monostatic lidar equation with the antenna efficiency of a Gaussian beam focused at F in
/// still air (Frehlich and Kavaya 1991; Kameyama et al. 2007, eq. 1 without turbulence). It is
/// largest at F z0^2 / (F^2 + z0^2) without extinction. That of a continuous-wave lidar hardly
/// depends on its focus distance (Sonnenschein and Horrigan 1971). In dB, scatter and drift are
/// Gaussian; the drift is a first-order autoregression in continuous time. A gate is detected with
/// the probability Phi((mean - threshold) / sqrt(scatter^2 + drift^2)).
class CarrierToNoise {
 public:
  CarrierToNoise(const CarrierToNoiseParams& params, std::uint64_t seed);

  double mean_db(double range_m) const noexcept;
  /// To be called once per measurement, in order of time.
  void move_on(double time_s) noexcept;
  /// Of one gate of the present measurement; draws.
  double draw_db(double range_m) noexcept {
    return mean_db(range_m) + drift_db_ + params_.scatter_db * scatter_.normal();
  }
  bool detects(double cnr_db) const noexcept { return cnr_db >= params_.threshold_db; }
  bool enabled() const noexcept { return params_.enabled; }

 private:
  double loss_db(double range_m) const noexcept;

  CarrierToNoiseParams params_;
  double reference_loss_db_;
  RandomStream scatter_;
  RandomStream drift_;
  double drift_db_;
  double time_s_ = 0.0;
};

}  // namespace lac::sim
