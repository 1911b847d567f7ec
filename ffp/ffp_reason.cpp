// SPDX-License-Identifier: Apache-2.0
#include "ffp/ffp_reason.hpp"

namespace lac {

const char* text_of(FfpReason reason) {
  switch (reason) {
    case FfpReason::None:
      return "on";
    case FfpReason::NoWind:
      return "no valid lidar wind speed";
    case FfpReason::Filling:
      return "the buffer is filling";
    case FfpReason::LeadTooShort:
      return "the lead time is too short for filter and actuator";
    case FfpReason::BufferTooLong:
      return "the buffer time exceeds LongestBuffer";
    case FfpReason::BelowThreshold:
      return "the wind speed is below what Entry acts on";
    case FfpReason::RateLimited:
      return "the rate is cut to MaximumRate";
    case FfpReason::OutsideCurve:
      return "the wind speed is outside the static pitch curve";
    case FfpReason::AuthorityReduced:
      return "the monitor allows a part of it only";
    case FfpReason::MonitorInvalid:
      return "the monitor's authority is not within 0 and 1, or its trim not a number";
    case FfpReason::PitchLimited:
      return "the pitch it has added is at LargestPitch";
  }
  return "unknown";
}

}  // namespace lac
