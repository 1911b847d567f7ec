// SPDX-License-Identifier: Apache-2.0
#include "ldp/ldp_params.hpp"

namespace lac {

LdpParams LdpParams::read(InputFile& in) {
  LdpParams p;
  p.reader = LidarReaderParams::read(in);
  p.scan_time_s = in.number("ScanTime", Range::positive());
  p.required_lead_s = in.number("RequiredLead", p.required_lead_s, Range::not_negative());
  p.longest_lead_s = in.number("LongestLead", p.longest_lead_s, Range::between(1.0, 600.0));
  p.mean_speed_window_s = in.number("MeanSpeedWindow", p.mean_speed_window_s, Range::positive());
  p.settling_time_s = in.number("SettlingTime", p.settling_time_s, Range::not_negative());
  p.minimum_samples = in.integer("MinimumSamples", p.reader.number_of_beams, {1.0});
  p.maximum_age_s = in.number("MaximumAge", 2.0 * p.scan_time_s, Range::positive());
  p.motion_compensation = in.flag("MotionCompensation", p.motion_compensation);
  if (p.required_lead_s + p.scan_time_s >= p.longest_lead_s) {
    in.fail("LongestLead", "found " + std::to_string(p.longest_lead_s) +
                               " s, expected more than RequiredLead plus ScanTime");
  }
  in.finish();
  return p;
}

}  // namespace lac
