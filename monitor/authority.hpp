// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "core/state_archive.hpp"

namespace lac {

/// Why the authority is what it is. Record MonitorReason.
enum class MonitorReason {
  Agree = 0,         // full
  NoLidar = 1,       // lidar REWS invalid: none; UnknownAuthority before the first comparison
  NoTurbine = 2,     // not yet compared long enough, no wind speed from turbine data: likewise
  Learning = 3,      // not yet compared long enough: likewise
  LowCoherence = 4,  // lidar and rotor have too little in common
  WrongDelay = 5,    // the feedforward acts too early or too late, more than trimming may mend
  WrongGain = 6,     // the rotor does not follow what the feedforward acts on
  WrongMean = 7,     // the means of lidar and rotor differ
};

const char* text_of(MonitorReason reason);

struct AuthorityParams {
  double unknown = 1.0;  // while there is not enough to judge by
  // No authority at the first value and below, full from the second on.
  double coherence_off = 0.15, coherence_on = 0.35;
  double gain_off = 0.3, gain_on = 0.7;
  // Full up to the tolerance, none from twice of it on.
  double delay_tolerance_s = 2.0;
  double mean_tolerance = 0.15;                   // of the logarithm of the ratio of the means
  double hysteresis = 0.1;                        // a target that moves by less is not followed
  double fall_time_s = 10.0, rise_time_s = 15.0;  // from full to none and back
};

/// What lidar and rotor have shown so far. What is not known (not a number) does not count.
struct Evidence {
  bool lidar_valid = false;
  bool turbine_valid = false;
  bool learned = false;
  double coherence = 0.0;
  double gain = 1.0;
  double late_s = std::numeric_limits<double>::quiet_NaN();
  double mean_ratio = 1.0;  // rotor over lidar
};

/// Share of the feedforward that the evidence allows: the least of what coherence, delay, gain and
/// means allow each, with hysteresis, followed at a limited rate.
class Authority {
 public:
  struct State {
    double target = 1.0;
    double value = 1.0;
    MonitorReason reason = MonitorReason::Learning;
    void visit(StateArchive& a) { a(target), a(value), a(reason); }
  };

  explicit Authority(const AuthorityParams& params) : params_(params) {}
  State initial_state() const {
    return {params_.unknown, params_.unknown, MonitorReason::Learning};
  }

  void step(const Evidence& evidence, double elapsed_s, State& state) const noexcept;

 private:
  struct Opinion {
    double share;
    MonitorReason reason;
  };
  Opinion judge(const Evidence& evidence) const noexcept;

  AuthorityParams params_;
};

}  // namespace lac
