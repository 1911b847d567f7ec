// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/carrier_to_noise.hpp"

#include <cmath>

namespace lac::sim {
namespace {

CarrierToNoiseParams read_fluctuation(YamlReader& in, CarrierToNoiseParams p) {
  p.threshold_db = in.number("threshold_db", Range::between(-60.0, 60.0));
  p.scatter_db = in.number("scatter_db", p.scatter_db, Range::not_negative());
  p.drift_db = in.number("drift_db", p.drift_db, Range::not_negative());
  if (in.has("drift_time_s") && !in.has("drift_db")) {
    in.fail("drift_time_s", "there is no drift_db that drifts");
  }
  p.drift_time_s = in.number("drift_time_s", p.drift_time_s, Range::positive());
  return p;
}

}  // namespace

CarrierToNoiseParams read_carrier_to_noise(YamlReader& in) {
  const Range positive = Range::positive();
  const Range not_negative = Range::not_negative();
  CarrierToNoiseParams p;
  p.enabled = true;
  p.reference_db = in.number("reference_db", Range::between(-60.0, 60.0));
  p.constant = in.choice("over_range", 0, {"pulsed", "constant"}) == 1;
  p.reference_range_m = in.number("reference_range_m", p.reference_range_m, positive);
  p.rayleigh_length_m = in.number("rayleigh_length_m", p.rayleigh_length_m, not_negative);
  p.focus_range_m = in.number("focus_range_m", p.focus_range_m, positive);
  if (in.has("focus_range_m") && !in.has("rayleigh_length_m")) {
    in.fail("focus_range_m", "has no effect without rayleigh_length_m beside it");
  }
  p.extinction_per_km = in.number("extinction_per_km", p.extinction_per_km, not_negative);
  return read_fluctuation(in, p);
}

CarrierToNoise::CarrierToNoise(const CarrierToNoiseParams& params, std::uint64_t seed)
    : params_(params),
      reference_loss_db_(loss_db(params.reference_range_m)),
      scatter_(seed, LidarStream::kScatter),
      drift_(seed, LidarStream::kDrift),
      drift_db_(params.drift_db * drift_.normal()) {}

double CarrierToNoise::loss_db(double range_m) const noexcept {
  const double defocus_m = params_.rayleigh_length_m * (1.0 - range_m / params_.focus_range_m);
  const double extinction = 2e-3 * params_.extinction_per_km * range_m;
  return 10.0 * std::log10(range_m * range_m + defocus_m * defocus_m) +
         10.0 * std::log10(std::exp(1.0)) * extinction;
}

double CarrierToNoise::mean_db(double range_m) const noexcept {
  const double gain_db = params_.constant ? 0.0 : reference_loss_db_ - loss_db(range_m);
  return params_.reference_db + gain_db;
}

void CarrierToNoise::move_on(double time_s) noexcept {
  const double kept = std::exp(-(time_s - time_s_) / params_.drift_time_s);
  time_s_ = time_s;
  drift_db_ = kept * drift_db_ + params_.drift_db * std::sqrt(1.0 - kept * kept) * drift_.normal();
}

}  // namespace lac::sim
