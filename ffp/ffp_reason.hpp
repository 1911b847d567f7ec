// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lac {

/// Why the feedforward is off, or not fully what was computed. Record FeedforwardReason.
enum class FfpReason {
  None = 0,              // on
  NoWind = 1,            // lidar REWS invalid or stale
  Filling = 2,           // the buffer does not reach back far enough yet
  LeadTooShort = 3,      // the wind arrives before filter, window and actuator have acted
  BufferTooLong = 4,     // LongestBuffer is exceeded
  BelowThreshold = 5,    // wind speed below what Entry acts on
  RateLimited = 6,       // on, but the rate is cut to MaximumRate
  OutsideCurve = 7,      // wind speed outside the static pitch curve
  AuthorityReduced = 8,  // on, but the monitor allows a part of it only
  MonitorInvalid = 9,    // the monitor's records are no share of 0 to 1 and no time: none allowed
  PitchLimited = 10,     // on, but the pitch it has added is at LargestPitch
};

const char* text_of(FfpReason reason);

}  // namespace lac
