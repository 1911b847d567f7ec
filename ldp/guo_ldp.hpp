// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/filters.hpp"
#include "core/lidar_block.hpp"
#include "ldp/guo_ldp_params.hpp"
#include "ldp/ldp.hpp"

namespace lac {

/// Rotor-effective wind speed of Guo's LDP: the mean of the last `samples` measurements,
///   u = (v_los - n . V_lidar) / (-n_x)          n: beam from the lidar, frame I
/// with n level and straight up-wind and V_lidar = 0 unless the motion is compensated. What
/// theirs does not have: a measurement takes its place in the mean but not part in it if it is not
/// finite, an error value (below -90, 999) or implausible; the estimate is valid once all places
/// are taken, at least half of them by good samples, and until the last good one is older than two
/// scans (at least 2 s). With `legacy_timing` all of that is left out.
class GuoLdp {
 public:
  struct Inputs {
    const LidarMeasurement* measurement = nullptr;  // nullptr: nothing new in this step. Beam id
                                                    // and gate count have been checked.
    double time_s = 0.0;
  };
  struct State {
    std::vector<double> wind_mps;  // the last `samples`, a ring; not a number: not part of the mean
    std::size_t next = 0;
    int arrivals = 0;  // up to `samples`
    int good = 0;      // in the mean
    double rews_mps = 0.0;
    double last_arrival_s = 0.0;
    double interval_s = 0.0;  // shortest between two arrivals; 0: unknown
    double last_good_s = -1.0e30;
    SlowMean mean_speed;
    void visit(StateArchive& a) {
      a(wind_mps), a(next), a(arrivals), a(good), a(rews_mps), a(last_arrival_s), a(interval_s);
      a(last_good_s), a(mean_speed);
    }
  };

  explicit GuoLdp(GuoLdpParams params);
  State initial_state() const;

  /// lead_s of the outputs is 0: not known. With legacy_timing rews_mps is what theirs would
  /// write: 0 before the first measurement, 999 without a sample.
  Ldp::Outputs step(const Inputs& in, State& state) const noexcept;

  const GuoLdpParams& params() const { return params_; }

 private:
  double longitudinal_mps(const LidarMeasurement& m) const noexcept;
  void take_in(const Inputs& in, State& state) const noexcept;

  GuoLdpParams params_;
};

}  // namespace lac
