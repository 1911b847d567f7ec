// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/lidar_reader.hpp"
#include "core/notice.hpp"
#include "core/state_archive.hpp"
#include "wrapper/chain_config.hpp"
#include "wrapper/private_array.hpp"

namespace lac {

/// The lidar block of Guo's chain for the secondaries that GuoSecondaries names: kept in
/// kPrivateGuoBlock, filled from whatever lidar the host has, with the four results of that chain
/// behind it, and those results made known to our own libraries in the chain block.
///
/// Their libraries know no validity. What protects them and those behind them:
///   - a measurement whose first gate is invalid is not announced (they would take it for a wind
///     speed); other invalid gates hold -99, the error value of their simulator;
///   - the number of gates never changes, since some of theirs allocate by it in their first call:
///     50 (native) or 5 (openfast), those that are not measured hold -99. In layout guo it is the
///     host's, 1 before its block comes. The results lie behind them;
///   - their REWS counts as valid if it is a wind speed (above 0, at most 100 m/s, not 999) and a
///     measurement was announced in the last kOldest_s;
///   - their pitch rate counts if the buffered REWS is a wind speed for the second call in a row.
///     The step from what their buffer was filled with at the start would be one huge pulse.
/// [real time]
class GuoLink {
 public:
  static constexpr double kOldest_s = 10.0;
  static constexpr double kFastestRate_radps = 2.0;  // 2.5 m/s in one step at 80 Hz, unfiltered

  struct State {
    LidarReader::State lidar;
    int gates = 0;                 // 0: no measurement yet
    std::int64_t calls_since = 0;  // the last announced measurement
    bool announced = false, no_block_reported = false;
    bool buffered_was_good = false, buffered_is_good = false;
    std::array<float, 2> rews{};         // as put into the chain block last, see GuoLink::give
    std::array<float, 3> feedforward{};  // likewise
    void visit(StateArchive& a) {
      a(lidar), a(gates), a(calls_since), a(announced), a(no_block_reported);
      a(buffered_was_good), a(buffered_is_good), a(rews), a(feedforward);
    }
  };

  /// Precondition: params.lidar is not None.
  explicit GuoLink(const WrapperParams& params);

  /// First call of a run: throws lac::Error if the host does not send what the layout needs.
  void require(const SwapReader& array, double time_step_s, Notice& notice) const;
  State initial_state() const;

  /// In each call, when the host's records are in the array: the part of the host. `host_block` is
  /// the first record of Guo's block in layout guo, 0 if there is none.
  void fill(PrivateArray& array, int host_block, double time_s, State& state,
            Notice& notice) noexcept;

  /// Before a Guo-type secondary: the REWS of an LDP of ours, if one writes it.
  void take(PrivateArray& array, const State& state) const noexcept;
  /// After one that is not ours: its results go to LidarRews, LidarRewsLead (0: not known),
  /// LidarRewsValid, LidarDataAge, and to FeedforwardPitchRate, FeedforwardActive,
  /// FeedforwardReason, RewsFiltered, RewsBuffered, unless a library of ours writes them.
  void give(PrivateArray& array, State& state) const noexcept;

 private:
  bool read_lidar(PrivateArray& array, double time_s, State& state, Notice& notice) noexcept;
  bool copy_block(PrivateArray& array, int host_block, State& state, Notice& notice) const noexcept;

  bool copies_;
  int announced_gates_;  // if not copied
  LidarReader reader_;
  LidarMeasurement measurement_;
};

}  // namespace lac
