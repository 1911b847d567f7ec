// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/swap_view.hpp"
#include "ldp/ldp.hpp"

namespace lac {

/// The Lidar* records of the chain block. `window_s`: averaging window of the estimate.
inline void write_lidar_rews(const Ldp::Outputs& out, double window_s, SwapView& swap) {
  swap.set(Rec::LidarRews, out.rews_mps);
  swap.set(Rec::LidarRewsLead, out.lead_s);
  swap.set(Rec::LidarRewsSamples, out.samples);
  swap.set(Rec::LidarRewsValid, out.valid ? 1.0 : 0.0);
  swap.set(Rec::LidarMeanSpeed, out.mean_speed_mps);
  swap.set(Rec::LidarScanWindow, window_s);
  swap.set(Rec::LidarDataAge, out.data_age_s);
}

}  // namespace lac
