// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <variant>
#include <vector>

#include "core/guo_lidar.hpp"
#include "core/native_lidar.hpp"
#include "core/openfast_lidar.hpp"

namespace lac {

/// What LDP and TI estimator both need to know about the lidar.
struct LidarReaderParams {
  LidarLayout layout = LidarLayout::Native;
  int number_of_beams = 4;  // OpenFAST's block: 1
  // Plausible line-of-sight speeds; outside of them a sample is invalid.
  double min_speed_mps = -5.0;
  double max_speed_mps = 60.0;
  // Carrier-to-noise ratio outside of which a sample is invalid: below, the lidar sees noise;
  // above, something hard. Native layout alone carries it.
  double min_cnr_db = -std::numeric_limits<double>::infinity();
  double max_cnr_db = std::numeric_limits<double>::infinity();
  // Distance from the lidar along the beam outside of which a sample is invalid.
  double min_range_m = 0.0;
  double max_range_m = std::numeric_limits<double>::infinity();
  // A beam that repeats itself this often, to the last bit, while record 27 (nacelle anemometer)
  // moved by more than stuck_wind_change_mps since its last fresh value, is stuck until it gives a
  // fresh one. 0: no check.
  int stuck_scans = 3;
  double stuck_wind_change_mps = 0.5;
  // Of the layout in use.
  GuoLidarParams guo;
  OpenFastLidarParams openfast;

  /// Keys LidarLayout, NumberOfBeams (not for OpenFAST's block), MinimumSpeed, MaximumSpeed,
  /// MinimumCnr, MaximumCnr (native alone), MinimumRange, MaximumRange, StuckScans, and those of
  /// the layout.
  static LidarReaderParams read(InputFile& in);
  /// ScanTime [s], which the measurement interval of OpenFAST's block stands in for if missing.
  double read_scan_time(InputFile& in, Range range) const;
  bool in_range(double range_m) const { return range_m >= min_range_m && range_m <= max_range_m; }
};

/// Takes new measurements out of the array and says which samples may be used. A sample is valid
/// if its flag says so, it is finite, plausible, none of the error values of the field (-99 and
/// below -90, 999), its carrier-to-noise ratio and its range are within limits, it is not from the
/// future (kFuture_s) and its beam is not stuck. Every other value leaves it marked invalid.
class LidarReader {
 public:
  /// How far the time stamp of a measurement may be ahead of the call that brings it: clocks and
  /// single precision differ a little.
  static constexpr double kFuture_s = 0.1;

  struct State {
    std::variant<NativeLidar::State, GuoLidar::State, OpenFastLidar::State> source;
    std::vector<float> last_speed;  // beams x kMaxGates
    std::vector<int> repeats;       // per beam
    std::vector<double> wind_at_change_mps;
    std::vector<unsigned char> stuck;  // per beam
    bool beam_reported = false;
    bool future = false;  // the last time stamp was ahead
    void visit(StateArchive& a) {
      std::visit([&a](auto& s) { a(s); }, source);
      a(last_speed), a(repeats), a(wind_at_change_mps), a(stuck), a(beam_reported);
      a(future);
    }
  };

  explicit LidarReader(LidarReaderParams params);

  /// Checks at the first call of a run (not of a restart) that the array carries what the layout
  /// needs; throws lac::Error.
  void require(const SwapReader& swap, double time_step_s, Notice& notice) const;
  State initial_state() const;

  /// True if this call brings a measurement; it then is in `m`, valid flags settled. `time_s` is
  /// the present time. To be called at every step. Reports once per change: no block, wrong beam
  /// id, stuck and free again.
  bool read(SwapView swap, double time_s, State& state, LidarMeasurement& m,
            Notice& notice) const noexcept;

  const LidarReaderParams& params() const { return params_; }

 private:
  void judge_samples(LidarMeasurement& m) const noexcept;
  void judge_time(double time_s, State& state, LidarMeasurement& m, Notice& notice) const noexcept;
  void judge_repeats(SwapView swap, State& state, LidarMeasurement& m,
                     Notice& notice) const noexcept;

  LidarReaderParams params_;
  std::variant<NativeLidar, GuoLidar, OpenFastLidar> source_;
};

}  // namespace lac
