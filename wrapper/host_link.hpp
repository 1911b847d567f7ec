// SPDX-License-Identifier: Apache-2.0
// What passes between the host's array and the private one. Rules: see README.md.
#pragma once

#include <algorithm>
#include <array>

#include "core/notice.hpp"
#include "core/state_archive.hpp"
#include "core/swap_view.hpp"
#include "wrapper/chain_config.hpp"
#include "wrapper/private_array.hpp"

namespace lac {

namespace detail {

constexpr bool is_demand(const RecordInfo& r) {
  return r.direction != Direction::In && r.index <= kHostBlock.last() &&
         r.index != static_cast<int>(Rec::LogCount);  // counts values in the private log area
}
constexpr bool is_measured(const RecordInfo& r) {
  return r.direction == Direction::In && r.index <= kHostBlock.last() && r.unit != "-";
}
template <auto predicate>
constexpr auto records_where() {
  constexpr auto count = std::count_if(kRecords.begin(), kRecords.end(), predicate);
  std::array<int, static_cast<std::size_t>(count)> all{};
  std::size_t n = 0;
  for (const RecordInfo& r : kRecords) {
    if (predicate(r)) all[n++] = r.index;
  }
  return all;
}

}  // namespace detail

/// What the chain gives to the host (Out and Both), and what must be finite to control at all.
inline constexpr auto kDemandRecords = detail::records_where<detail::is_demand>();
inline constexpr auto kMeasuredRecords = detail::records_where<detail::is_measured>();

/// [real time]
class HostLink {
 public:
  struct State {
    std::array<float, kHostBlock.size> good{};               // last finite host records
    std::array<float, kDemandRecords.size()> demands{};      // last good demands
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
  void take_doubtful_inputs(const float* host, State& state, Notice& notice) const noexcept;
  void take_lidar(SwapView host, PrivateArray& array, State& state) const noexcept;

  HostLidar lidar_;
  bool extended_demands_;
};

}  // namespace lac
