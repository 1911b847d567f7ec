// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/input_file.hpp"
#include "core/turbine_rews.hpp"
#include "monitor/authority.hpp"

namespace lac {

enum class DelayMethod { Correlation, Moddemeijer };

struct MonitorParams {
  TurbineRewsParams turbine;
  // Lidar and rotor are compared at this interval, on means over it: nothing above the cut-off of
  // a feedforward matters, and the cost is spread.
  double update_interval_s = 0.2;
  double memory_s = 200.0;   // time constant of forgetting, once that long has been compared
  double learning_s = 60.0;  // compared for less: no judgement
  double detrend_s = 10.0;   // slower than this is not compared, but for the means
  DelayMethod delay_method = DelayMethod::Correlation;
  double lag_range_s = 6.0;          // of the delay, either way of the expected one
  double sample_spacing_s = 1.0;     // Moddemeijer: between the samples of past and future
  double minimum_correlation = 0.4;  // of a delay that counts
  std::vector<double> band_hz{0.02, 0.035, 0.05};
  double band_width_hz = 0.01;  // -3 dB point beside the centre
  double longest_lead_s = 60.0;
  double actuator_delay_s = 0.22;    // of all behind the feedforward; 1 Hz, damping 0.7
  double delay_frequency_hz = 0.08;  // at which the feedforward makes up for its filter
  int filter_order = 1;              // of the feedforward's low-pass; 2: with this damping
  double filter_damping = 0.7;
  double maximum_trim_s = 0.0;  // 0: none
  double trim_time_s = 100.0;   // the trim takes away the delay with this time constant
  AuthorityParams authority = {};

  /// Reads all keys and refuses unknown ones. Throws lac::Error with file, line and key.
  static MonitorParams read(InputFile& in);
  /// Refuses what makes no sense at this time step. Throws lac::Error with file, line and key.
  void check_time_step(const InputFile& in, double time_step_s) const;
};

}  // namespace lac
