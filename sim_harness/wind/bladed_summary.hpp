// SPDX-License-Identifier: Apache-2.0
// The .sum file beside a Bladed-style .wnd file: text in which a few phrases stand behind or
// before a number. As InflowWind reads it, upper and lower case alike, in this order:
//   <T|F> ... clockwise ...            optional: T if the points of a row run from y > 0 to y < 0
//   <number> ... hub height (or zhub)
//   UBar = <number>                    and the three lines below it: ... = <number> %, u, v, w
//   height offset = <number>           optional: hub height less height of the grid's centre
//   periodic                           optional
//   Bladed left-hand rule              optional: v is positive to the right, towards -y
#pragma once

#include <array>
#include <filesystem>

namespace lac::sim {

struct BladedSummary {
  bool clockwise = false;
  double hub_height_m = 0.0;
  double mean_speed_mps = 0.0;
  std::array<double, 3> intensity{};  // sigma / U [-], scales the integers of the .wnd file
  double height_offset_m = 0.0;
  bool periodic = false;
  bool left_handed = false;
};

/// Throws lac::Error with file, line, found and expected if a number is missing or cannot be.
BladedSummary read_bladed_summary(const std::filesystem::path& file);

/// Throws lac::Error if it cannot be written.
void write_bladed_summary(const std::filesystem::path& file, const BladedSummary& summary);

}  // namespace lac::sim
