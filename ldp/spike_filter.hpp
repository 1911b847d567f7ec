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

/// Test against outliers after Hampel: a sample is a spike if it is farther than
/// limit x max(1.4826 MAD, floor)  from the median of its neighbours: the last four measurements,
/// of whatever beam, of the same gate and of the second one behind it, which a gust has passed a
/// little before. Fewer than four of them: no test. The gates beside it in the same measurement
/// have no vote: a hard target fills as many of them as the pulse is long. Spikes stay among the
/// neighbours of later samples, so that a change that lasts is believed after four measurements;
/// one that rises over some of them never is a spike: on a straight ramp the next value is 2.5
/// measurements ahead of the median of one gate, 1.7 robust standard deviations. A target that
/// fills a gate in half of all measurements cannot be told from the wind.
class SpikeFilter {
 public:
  static constexpr std::size_t kPast = 4;
  static constexpr std::size_t kBehind = 2;  // gates
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
  /// After a silence: what was measured before it says nothing of what comes.
  void forget(State& state) const noexcept;

 private:
  bool is_spike(double wind_mps, std::size_t gate, std::size_t gates,
                const State& state) const noexcept;

  SpikeFilterParams params_;
};

}  // namespace lac
