// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/units.hpp"
#include "sim_harness/lidar/platform_motion.hpp"
#include "sim_harness/tables/number_table.hpp"

namespace lac::sim {
namespace {

constexpr double kLargest_m = 100.0;
constexpr double kLargest_deg = 45.0;  // rates of angles are singular at a pitch of 90
constexpr double kShortestPeriod_s = 0.1;
constexpr const char* kNames[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

bool is_angle(std::size_t freedom) {
  return freedom >= kRoll;
}

double si(std::size_t freedom, double value) {
  return is_angle(freedom) ? rad_from_deg(value) : value;
}

Range range_of(std::size_t freedom) {
  const double most = is_angle(freedom) ? kLargest_deg : kLargest_m;
  return Range::between(-most, most);
}

std::vector<double> values_for(YamlReader& in, const std::string& key, std::size_t count,
                               Range range) {
  const std::vector<double> values = in.numbers(key, range);
  if (values.size() != count) {
    in.fail(key, "found " + std::to_string(values.size()) + " values, expected " +
                     std::to_string(count) + ", one per amplitude");
  }
  return values;
}

PrescribedMotion read_freedom(YamlReader in, std::size_t freedom) {
  PrescribedMotion motion;
  motion.mean = si(freedom, in.number("mean", 0.0, range_of(freedom)));
  if (in.has("amplitude")) {
    const std::vector<double> amplitude = in.numbers("amplitude", range_of(freedom));
    const std::size_t n = amplitude.size();
    const auto period_s =
        values_for(in, "period_s", n, {kShortestPeriod_s, std::numeric_limits<double>::infinity()});
    const std::vector<double> phase_deg = in.has("phase_deg")
                                              ? values_for(in, "phase_deg", n, Range::any())
                                              : std::vector<double>(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      motion.harmonics.push_back(
          {si(freedom, amplitude[i]), period_s[i], rad_from_deg(phase_deg[i])});
    }
  }
  in.finish();
  return motion;
}

void load_table(const std::filesystem::path& file, PlatformMotion& platform) {
  const std::vector<NumberRow> rows =
      load_number_table(file, 7, 7, "time_s surge_m sway_m heave_m roll_deg pitch_deg yaw_deg");
  const auto fail = [&](int line, const std::string& problem) {
    throw Error(file.string() + ":" + std::to_string(line) + ": " + problem);
  };
  if (rows.size() < 2) fail(rows.front().line, "found one row, expected two at least");
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const double time_s = rows[r].values[0];
    if (r > 0 && time_s <= rows[r - 1].values[0]) {
      fail(rows[r].line, "expected a time after that of the row before");
    }
    for (std::size_t f = 0; f < platform.freedoms.size(); ++f) {
      const double value = rows[r].values[f + 1];
      if (!range_of(f).contains(value)) {
        fail(rows[r].line, std::string(kNames[f]) + ": found " + shortest(value) + ", expected " +
                               range_of(f).text());
      }
      platform.freedoms[f].time_s.push_back(time_s);
      platform.freedoms[f].values.push_back(si(f, value));
    }
  }
}

}  // namespace

PlatformMotion read_platform_motion(YamlReader& in) {
  PlatformMotion platform;
  platform.reference_height_m =
      in.number("reference_height_m", 0.0, Range::between(-kLargest_m, 10.0 * kLargest_m));
  if (in.has("table")) {
    load_table(in.existing_file("table"), platform);
    return platform;
  }
  for (std::size_t f = 0; f < platform.freedoms.size(); ++f) {
    if (in.has(kNames[f])) platform.freedoms[f] = read_freedom(in.map(kNames[f]), f);
  }
  return platform;
}

}  // namespace lac::sim
