// SPDX-License-Identifier: Apache-2.0
// What passes between the host's array and the private one. Rules: see README.md.
#pragma once

#include <array>

#include "core/notice.hpp"
#include "core/state_archive.hpp"
#include "core/swap_view.hpp"
#include "wrapper/chain_config.hpp"
#include "wrapper/host_records.hpp"
#include "wrapper/private_array.hpp"

namespace lac {

/// [real time]
class HostLink {
 public:
  struct State {
    std::array<float, kPackedSize<kJudgedRuns>> good{};      // last finite inputs, packed
    std::array<float, kPackedSize<kDemandRuns>> demands{};   // last good demands, packed
    std::array<bool, kMeasuredRecords.size()> not_finite{};  // measured records in doubt
    bool holding = false;                                    // any of them
    int log_start = kPrivateLogBlock.first;  // record 63 for the secondaries; Guo: lidar block
    void visit(StateArchive& a) { a(good), a(demands), a(not_finite), a(holding), a(log_start); }
  };

  HostLink(HostLidar lidar, bool extended_demands)
      : lidar_(lidar), extended_demands_(extended_demands) {}

  /// Throws lac::Error if the host's array cannot carry what is configured.
  void require(const SwapReader& host) const;

  /// Everything known of the host's array, once. Throws lac::Error naming measured records that
  /// are not finite: there is nothing to hold yet.
  void start(SwapView host, PrivateArray& array, State& state) const;

  /// What changes from call to call. Measured records that are not finite stay at their last good
  /// value; reported once when that begins and once when all are good again.
  void take_inputs(SwapView host, PrivateArray& array, State& state, Notice& notice) const noexcept;

  /// Keeps the demands in the private array as the good ones.
  void keep_demands(PrivateArray& array, State& state) const noexcept;
  /// Puts the good ones back there.
  void hold_demands(PrivateArray& array, const State& state) const noexcept;
  /// Gives them to the host, which keeps its own cable and structural demands unless `fresh`.
  void give_demands(PrivateArray& array, SwapView host, bool fresh) const noexcept;

  /// First demand record that is not finite, or 0.
  static int bad_demand(PrivateArray& array) noexcept;

  /// False in Guo's layout, where record 63 is the lidar block and there is no logging.
  bool logging() const { return lidar_ != HostLidar::Guo; }

 private:
  void take_doubtful_inputs(const float* host, PrivateArray& array, State& state,
                            Notice& notice) const noexcept;

  HostLidar lidar_;
  bool extended_demands_;
};

}  // namespace lac
