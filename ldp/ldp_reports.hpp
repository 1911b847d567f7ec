// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/notice.hpp"
#include "ldp/ldp.hpp"

namespace lac {

/// What LDP tells the user: changes, each once.
class LdpReports {
 public:
  explicit LdpReports(const LdpParams& params)
      : scan_time_s_(params.scan_time_s),
        availability_limit_(params.availability_limit),
        availability_alarm_s_(params.availability_alarm_s),
        average_if_refused_(params.wind.average_if_refused),
        travel_by_turbine_(params.travel == TravelSpeed::Turbine) {}

  void report(const Ldp::Outputs& out, double time_s, Notice& notice) noexcept;
  void visit(StateArchive& a) {
    a(was_valid_), a(silence_reported_), a(scan_reported_), a(refusal_reported_);
    a(low_since_s_), a(alarm_), a(travel_reported_);
  }

 private:
  void report_silence(const Ldp::Outputs& out, double time_s, Notice& notice) noexcept;
  void report_scan(const Ldp::Outputs& out, Notice& notice) noexcept;
  void report_refusal(const Ldp::Outputs& out, Notice& notice) noexcept;
  void report_availability(const Ldp::Outputs& out, double time_s, Notice& notice) noexcept;
  void report_travel(const Ldp::Outputs& out, double time_s, Notice& notice) noexcept;

  double scan_time_s_;
  double availability_limit_;
  double availability_alarm_s_;
  bool average_if_refused_;
  bool travel_by_turbine_;

  bool was_valid_ = false;
  bool silence_reported_ = false;  // or there was none
  bool scan_reported_ = false;
  bool refusal_reported_ = false;
  double low_since_s_ = -1.0;  // availability; negative: it is not low
  bool alarm_ = false;
  bool travel_reported_ = false;
};

}  // namespace lac
