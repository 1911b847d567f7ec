// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/input_file.hpp"
#include "core/lidar_block.hpp"
#include "core/notice.hpp"
#include "core/state_archive.hpp"

namespace lac {

/// What LDP and TI estimator both need to know about the lidar.
struct LidarReaderParams {
  LidarLayout layout = LidarLayout::Native;
  int number_of_beams = 4;
  // Plausible line-of-sight speeds; outside of them a sample is invalid.
  double min_speed_mps = -5.0;
  double max_speed_mps = 60.0;
  // A beam that repeats itself this often, to the last bit, while record 27 (nacelle anemometer)
  // moved by more than stuck_wind_change_mps since its last fresh value, is stuck until it gives a
  // fresh one. 0: no check.
  int stuck_scans = 3;
  double stuck_wind_change_mps = 0.5;
  // Only for the Guo layout, which does not carry them; one entry per beam, per gate.
  std::vector<Vec3> beam_dir_L;
  std::vector<double> gate_range_m;
  Vec3 position_I_m;

  /// Keys LidarLayout, NumberOfBeams, MinimumSpeed, MaximumSpeed, StuckScans, and for the Guo
  /// layout BeamAzimuth, BeamElevation, GateRanges, LidarPosition.
  static LidarReaderParams read(InputFile& in);
};

/// Takes new measurements out of the array and says which samples may be used. A sample is valid
/// if its flag says so, it is finite, plausible, none of the error values of the field (-99 and
/// below -90, 999) and its beam is not stuck. Every other value leaves it marked invalid.
class LidarReader {
 public:
  struct State {
    double last_time_s = -1.0e30;
    std::vector<float> last_speed;  // beams x kMaxGates
    std::vector<int> repeats;       // per beam
    std::vector<double> wind_at_change_mps;
    std::vector<unsigned char> stuck;  // per beam
    bool layout_reported = false;
    void visit(StateArchive& a) {
      a(last_time_s), a(last_speed), a(repeats), a(wind_at_change_mps), a(stuck);
      a(layout_reported);
    }
  };

  explicit LidarReader(LidarReaderParams params);

  /// Checks at the first call that the array can carry the layout; throws lac::Error.
  void require(const SwapReader& swap) const;
  State initial_state() const;

  /// True if this call brings a measurement; it then is in `m`, valid flags settled. `time_s` is
  /// the present time; a native measurement counts as new if its flag is up and its time has
  /// changed. Reports once per change: no block, wrong beam id, stuck and free again.
  bool read(SwapView swap, double time_s, State& state, LidarMeasurement& m,
            Notice& notice) const noexcept;

  const LidarReaderParams& params() const { return params_; }

 private:
  bool fetch(SwapView swap, double time_s, State& state, LidarMeasurement& m,
             Notice& notice) const noexcept;
  void judge_samples(LidarMeasurement& m) const noexcept;
  void judge_repeats(SwapView swap, State& state, LidarMeasurement& m,
                     Notice& notice) const noexcept;

  LidarReaderParams params_;
};

}  // namespace lac
