// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim_harness/run/flight.hpp"
#include "support/temp_folder.hpp"

namespace lac::test {

/// Sanitizers make everything ten to twenty times slower; cases that repeat the same thing with
/// other seeds or steps are cut short there. They look for faults, not for figures.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

struct Warning {
  double time_s;
  std::string text;
};

struct Flight {
  sim::Recording recording;
  std::vector<Warning> warnings;
};

/// A shipped case and its wind, flown by the libraries of this build; nothing stays on the disk.
class CaseFlight {
 public:
  explicit CaseFlight(const std::string& file, const std::vector<std::string>& overrides = {})
      : c(sim::load_case(std::string(LAC_SOURCE_DIR "/config/") + file, overrides)),
        wind(sim::make_wind(c.wind)),
        rotor_wind(*wind,
                   {c.turbine.rotor.radius_m, c.turbine.hub_height_m, 0.0, c.time.duration_s}) {}

  Flight fly(const sim::CaseController& controller) const {
    const TempFolder results;
    std::vector<Warning> warnings;
    sim::FlightReport report;
    report.on_warning = [&](double time_s, const std::string& text) {
      warnings.push_back({time_s, text});
    };
    sim::Recording recording =
        sim::fly(c, controller, *wind, rotor_wind, results.path() / controller.name, report);
    return {std::move(recording), std::move(warnings)};
  }
  Flight fly(std::size_t controller = 0) const { return fly(c.controllers.at(controller)); }

  sim::Case c;  // the lidar's fault may be changed between flights
  std::unique_ptr<sim::WindField> wind;
  sim::RotorWind rotor_wind;
};

/// Largest |a - b| of one channel in rows [first, last).
inline double largest_difference(const sim::Recording& a, const sim::Recording& b,
                                 const char* channel, std::size_t first, std::size_t last) {
  const auto x = a.column(channel), y = b.column(channel);
  double largest = 0.0;
  for (std::size_t i = first; i < last; ++i) largest = std::max(largest, std::abs(x[i] - y[i]));
  return largest;
}

}  // namespace lac::test
