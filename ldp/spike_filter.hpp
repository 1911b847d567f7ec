// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/input_file.hpp"
#include "core/native_lidar.hpp"

namespace lac {

struct SpikeFilterParams {
  double limit = 0.0;      // of the robust standard deviation; 0: off
  double floor_mps = 1.0;  // the robust standard deviation counts as this at least

  /// Keys SpikeLimit and, only with one, SpikeFloor. Throws lac::Error.
  static SpikeFilterParams read(InputFile& in);
};

/// Test against outliers after Hampel: a sample is a spike if it is farther from the median of its
/// neighbours than  limit x max(1.4826 MAD, floor).  Neighbours are up to two gates on either side
/// in the same measurement, and the last four measurements of the same gate, of whatever beam.
/// Fewer than four neighbours: no test. What is found stays among the neighbours of later samples,
/// so that a real change is believed after three measurements at the latest; a change that passes
/// the gates with the wind, or rises over more than a measurement, never is a spike: on a straight
/// ramp the last value is 2.5 measurements ahead of the median, 1.7 robust standard deviations.
class SpikeFilter {
 public:
  static constexpr std::size_t kPast = 4;
  static constexpr std::size_t kBeside = 2;  // gates on either side
  static constexpr std::size_t kFewest = 4;
  using Past = std::array<double, kPast>;

  struct State {
    std::vector<Past> past;  // by gate; not a number: none
    std::size_t next = 0;
    void visit(StateArchive& a) { a(past), a(next); }
  };

  SpikeFilter() = default;
  explicit SpikeFilter(SpikeFilterParams params) : params_(params) {}
  bool active() const { return params_.limit > 0.0; }
  State initial_state() const;

  /// Longitudinal speeds of one measurement by gate, not a number where there is none; spikes
  /// become not a number. Returns how many. Precondition: at most kMaxGates values.
  int clean(std::span<double> wind_mps, State& state) const noexcept;

 private:
  bool is_spike(std::span<const double> wind_mps, std::size_t gate,
                const Past& past) const noexcept;

  SpikeFilterParams params_;
};

}  // namespace lac
