// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/input_file.hpp"
#include "core/lidar_block.hpp"
#include "core/notice.hpp"
#include "core/state_archive.hpp"

namespace lac {

/// What Guo's layout does not carry; one entry per beam, per gate.
struct GuoLidarParams {
  std::vector<Vec3> beam_dir_L;
  std::vector<double> gate_range_m;
  Vec3 position_I_m;

  /// Keys BeamAzimuth, BeamElevation [deg], GateRanges, LidarPosition [m].
  static GuoLidarParams read(InputFile& in, int number_of_beams);
};

/// Measurements out of the block at record 63 (Guo's chain).
class GuoLidar {
 public:
  struct State {
    bool reported = false;
    void visit(StateArchive& a) { a(reported); }
  };

  explicit GuoLidar(GuoLidarParams params);

  /// Nothing to check: the user has said that the block is there.
  void require(const SwapReader&, double, Notice&) const {}
  State initial_state() const { return {}; }
  /// True while the flag is up; `time_s` becomes the time of the measurement. A block with another
  /// number of gates is reported once.
  bool fetch(const SwapReader& swap, double time_s, State& state, LidarMeasurement& m,
             Notice& notice) const noexcept;

 private:
  GuoLidarParams params_;
};

}  // namespace lac
