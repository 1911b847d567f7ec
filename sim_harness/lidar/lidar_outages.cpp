// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/lidar/lidar_outages.hpp"

#include <algorithm>
#include <sstream>

#include "core/error.hpp"

namespace lac::sim {
namespace {

constexpr double kLargestShare = 0.99;

}  // namespace

OutageParams read_outages(YamlReader& in) {
  const Range share{0.0, kLargestShare};
  OutageParams p;
  p.share = in.number("share", p.share, share);
  p.per_gate = in.choice("of", 0, {"measurements", "gates"}) == 1;
  p.burst_share = in.number("burst_share", p.burst_share, share);
  if (p.burst_share > 0.0 || in.has("burst_length_s")) {
    p.burst_length_s = in.number("burst_length_s", Range::positive());
  }
  return p;
}

Outages::Outages(const OutageParams& params, double interval_s, std::uint64_t seed)
    : params_(params),
      ends_(params.burst_share > 0.0 ? interval_s / params.burst_length_s : 1.0),
      begins_(ends_ * params.burst_share / (1.0 - params.burst_share)),
      single_(seed, LidarStream::kOutage),
      chain_(seed, LidarStream::kBurst),
      in_burst_(chain_.happens(params.burst_share)) {
  if (ends_ <= 1.0 && begins_ <= 1.0) return;
  std::ostringstream text;
  text << "lidar: outages: burst_length_s = " << params.burst_length_s
       << " with burst_share = " << params.burst_share << " and a measurement every " << interval_s
       << " s; expected a mean length of at least "
       << interval_s * std::max(1.0, params.burst_share / (1.0 - params.burst_share)) << " s";
  throw Error(text.str());
}

bool Outages::next_is_in_burst() noexcept {
  const bool now = in_burst_;
  in_burst_ = in_burst_ ? !chain_.happens(ends_) : chain_.happens(begins_);
  return now;
}

void Outages::strike(LidarMeasurement& m) noexcept {
  const bool whole_lost = next_is_in_burst();
  const bool single_lost = !params_.per_gate && single_.happens(params_.share);
  for (int g = 0; g < m.gate_count; ++g) {
    const bool gate_lost = params_.per_gate && single_.happens(params_.share);
    if (whole_lost || single_lost || gate_lost) m.gates[static_cast<std::size_t>(g)].valid = false;
  }
}

}  // namespace lac::sim
