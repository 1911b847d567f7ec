// SPDX-License-Identifier: Apache-2.0
#include "ldp/ldp_reports.hpp"

namespace lac {
namespace {

/// From the start of the run; the farthest gate's wind has long arrived by then.
constexpr double kLongSilence_s = 60.0;
constexpr double kTravelPatience_s = 120.0;  // until TurbineRews should be there

}  // namespace

void LdpReports::report(const Ldp::Outputs& out, double time_s, Notice& notice) noexcept {
  report_silence(out, time_s, notice);
  report_scan(out, notice);
  report_refusal(out, notice);
  report_availability(out, time_s, notice);
  report_travel(out, time_s, notice);
}

void LdpReports::report_silence(const Ldp::Outputs& out, double time_s, Notice& notice) noexcept {
  if (was_valid_ && !out.valid) {
    notice.warn("no valid lidar wind speed: %d samples in the scan window, the last one %.1f s ago",
                out.samples, out.data_age_s);
  }
  if (!silence_reported_ && !out.valid && time_s >= kLongSilence_s) {
    notice.warn("no valid lidar wind speed since the start, %.0f s ago", time_s);
  }
  silence_reported_ = silence_reported_ || out.valid || time_s >= kLongSilence_s;
  was_valid_ = out.valid;
}

void LdpReports::report_scan(const Ldp::Outputs& out, Notice& notice) noexcept {
  if (!out.valid || scan_reported_ || out.scan_time_s <= 1.1 * scan_time_s_) return;
  notice.warn(
      "the lidar comes back to a beam after %.3g s, ScanTime says %.3g s: its average misses "
      "beams",
      out.scan_time_s, scan_time_s_);
  scan_reported_ = true;
}

void LdpReports::report_refusal(const Ldp::Outputs& out, Notice& notice) noexcept {
  if (!out.wind.is_refused() || refusal_reported_) return;
  refusal_reported_ = true;
  notice.warn("the beams cannot tell %s of WindModel (condition %.3g): %s",
              out.wind.reason == WindReason::Partly ? "some quantities" : "any quantity",
              out.wind.condition,
              average_if_refused_ ? "what is not known counts as 0 in the lidar wind speed"
                                  : "no valid lidar wind speed (WhenRefused)");
}

void LdpReports::report_availability(const Ldp::Outputs& out, double time_s,
                                     Notice& notice) noexcept {
  if (!(out.availability < availability_limit_)) {
    if (alarm_) notice.warn("lidar availability is %.0f %% again", 100.0 * out.availability);
    low_since_s_ = -1.0;
    alarm_ = false;
    return;
  }
  if (low_since_s_ < 0.0) low_since_s_ = time_s;
  if (alarm_ || time_s - low_since_s_ < availability_alarm_s_) return;
  alarm_ = true;
  notice.warn("lidar availability is %.0f %%, below %.0f %% for %.0f s", 100.0 * out.availability,
              100.0 * availability_limit_, availability_alarm_s_);
}

void LdpReports::report_travel(const Ldp::Outputs& out, double time_s, Notice& notice) noexcept {
  if (!travel_by_turbine_ || time_s < kTravelPatience_s) return;
  if (out.turbine_sets_travel == !travel_reported_) return;
  travel_reported_ = !out.turbine_sets_travel;
  if (travel_reported_) {
    notice.warn("TravelSpeed turbine: no TurbineRews (3771), the mean of the lidar is used");
  } else {
    notice.warn("TravelSpeed turbine: TurbineRews is there");
  }
}

}  // namespace lac
