// SPDX-License-Identifier: Apache-2.0
#include "ldp/ldp_params.hpp"

#include <algorithm>

namespace lac {

LdpParams LdpParams::read(InputFile& in) {
  LdpParams p;
  p.reader = LidarReaderParams::read(in);
  p.scan_time_s = p.reader.read_scan_time(in, Range::positive());
  p.required_lead_s = in.number("RequiredLead", p.required_lead_s, Range::not_negative());
  p.lead_margin_s = in.number("LeadMargin", p.lead_margin_s, Range::not_negative());
  p.longest_lead_s = in.number("LongestLead", p.longest_lead_s, Range::between(1.0, 600.0));
  p.mean_speed_window_s = in.number("MeanSpeedWindow", p.mean_speed_window_s, Range::positive());
  p.settling_time_s = in.number("SettlingTime", std::min(p.settling_time_s, p.mean_speed_window_s),
                                Range::between(0.0, 3600.0));
  p.minimum_samples =
      in.integer("MinimumSamples", p.reader.number_of_beams, Range::between(1.0, 1.0e6));
  p.maximum_age_s = in.number("MaximumAge", 2.0 * p.scan_time_s, Range::positive());
  p.motion_compensation = in.flag("MotionCompensation", p.motion_compensation);
  p.wind = WindModelParams::read(in, p.reader.layout != LidarLayout::OpenFast);
  p.induction = InductionCorrectionParams::read(in);
  if (p.reader.layout == LidarLayout::OpenFast &&
      p.induction.model == InductionModel::kVortexCylinder) {
    in.fail("InductionModel",
            "found vortex_cylinder, expected one_dimensional or none with LidarLayout openfast: it "
            "gives x of its points alone");
  }
  p.spikes = SpikeFilterParams::read(in);
  p.travel = static_cast<TravelSpeed>(in.choice("TravelSpeed", 0, {"lidar", "turbine"}));
  p.read_availability(in);
  if (p.required_lead_s + p.scan_time_s >= p.longest_lead_s) {
    in.fail("LongestLead", "found " + shortest(p.longest_lead_s) +
                               " s, expected more than RequiredLead plus ScanTime");
  }
  if (p.settling_time_s > p.mean_speed_window_s) {
    in.fail("SettlingTime", "found " + shortest(p.settling_time_s) +
                                " s, expected no more than MeanSpeedWindow, " +
                                shortest(p.mean_speed_window_s) + " s");
  }
  in.finish();
  return p;
}

void LdpParams::read_availability(InputFile& in) {
  bridged_gap_s = in.number("BridgeGaps", bridged_gap_s, Range::between(0.0, 60.0));
  availability_window_s =
      in.number("AvailabilityWindow", availability_window_s, Range::between(1.0, 86400.0));
  availability_limit = in.number("AvailabilityLimit", availability_limit, Range::between(0.0, 1.0));
  if (availability_limit <= 0.0) return;
  availability_alarm_s =
      in.number("AvailabilityAlarmTime", availability_alarm_s, Range::not_negative());
}

void LdpParams::check_time_step(const InputFile& in, double time_step_s) const {
  const auto require_a_step = [&](const char* key, double time_s) {
    if (time_s >= time_step_s * (1.0 - 1e-9)) return;
    in.fail(key, "found " + shortest(time_s) + " s, expected at least one step of " +
                     shortest(time_step_s) + " s");
  };
  require_a_step("ScanTime", scan_time_s);
  require_a_step("MeanSpeedWindow", mean_speed_window_s);
  require_a_step("MaximumAge", maximum_age_s);
}

}  // namespace lac
