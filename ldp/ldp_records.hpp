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
  swap.set(Rec::LidarYawError, out.wind.yaw_error_rad);
  swap.set(Rec::LidarHorizontalShear, out.wind.du_dy_per_s);
  swap.set(Rec::LidarVerticalShear, out.wind.du_dz_per_s);
  swap.set(Rec::LidarInflowAngle, out.wind.inflow_angle_rad);
  swap.set(Rec::LidarReconstruction, static_cast<int>(out.wind.reason));
  swap.set(Rec::LidarAvailability, out.availability);
}

}  // namespace lac
