// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "core/filters.hpp"
#include "ldp/arrival_bins.hpp"
#include "ldp/availability.hpp"
#include "ldp/ldp_params.hpp"

namespace lac {

/// Lidar data processing: line-of-sight speeds -> rotor-effective wind speed and its preview.
///
/// Each valid sample gives a longitudinal wind speed (methods sections 0, 8)
///   u = (v_los - n . V_lidar) / (-n_x),          n: beam from the lidar, frame I
/// that arrives at the rotor at  t_meas + d/U,    d: distance of the gate up-wind of the rotor,
/// U: slow mean of u. The estimate is the mean of all samples, of all gates, that arrive within
/// one scan time before  t + T_lead, where T_lead is the lead of the nearest gate in use: fresh
/// samples of that gate are averaged with older ones of farther gates that saw the same wind
/// (GUO eq. 28 with aligned gates; methods section 7). Mean delay against t + T_lead: half a scan.
/// A measurement that comes some steps after its time has lost as much of its lead.
///
/// On demand: spikes are left out (spike_filter.hpp); u is that of the wind without the rotor
/// (induction_correction.hpp); lateral wind and shear, known as slow means, are taken out of each
/// sample (wind_reconstruction.hpp), so that u stays that of the rotor axis when beams are missing.
/// u is the component along x of frame I whatever the wind direction, for that is what a rotor
/// that faces x can use.
class Ldp {
 public:
  struct Inputs {
    const LidarMeasurement* measurement = nullptr;  // nullptr: nothing new in this step
    double time_s = 0.0;                            // a whole number of time steps
    double lead_needed_s = 0.0;  // by what comes behind; not a number counts as 0
    double turbine_rews_mps = std::numeric_limits<double>::quiet_NaN();  // of TravelSpeed turbine
  };
  struct Outputs {
    double rews_mps = std::numeric_limits<double>::quiet_NaN();
    double lead_s = 0.0;  // T_lead
    int samples = 0;
    bool valid = false;
    double mean_speed_mps = std::numeric_limits<double>::quiet_NaN();  // U
    double data_age_s = 0.0;   // since the last valid sample
    double scan_time_s = 0.0;  // shortest time between two measurements of one beam; 0: unknown
    double availability = std::numeric_limits<double>::quiet_NaN();
    WindReconstruction::Estimate wind;
    bool bridged = false;  // rews_mps is the last valid one, held
    bool turbine_sets_travel = false;
  };
  struct State {
    ArrivalBins bins;
    SlowMean mean_speed;
    double nearest_gate_m = 0.0;  // distance of the nearest gate that all beams have in use
    std::vector<double> nearest_of_beam_m;
    std::vector<double> last_of_beam_s;  // not a number before the first one
    double scan_time_s = 0.0;
    double last_sample_s = -1.0e30;
    double last_measurement_s = 0.0;
    double latency_s = 0.0;  // of the last measurement, in whole steps
    Availability availability;
    WindReconstruction::State wind;
    InductionCorrection::State induction;
    SpikeFilter::State spikes;
    SlowMean turbine_speed;
    double turbine_seen_s = -1.0e30;
    double held_rews_mps = 0.0;  // of the last valid estimate
    double held_since_s = -1.0e30;
    void visit(StateArchive& a) {
      a(bins), a(mean_speed), a(nearest_gate_m), a(nearest_of_beam_m), a(last_of_beam_s);
      a(scan_time_s), a(last_sample_s), a(last_measurement_s), a(latency_s);
      a(availability), a(wind), a(induction), a(spikes), a(turbine_speed), a(turbine_seen_s);
      a(held_rews_mps), a(held_since_s);
    }
  };

  Ldp(LdpParams params, double time_step_s);
  State initial_state() const;
  Outputs step(const Inputs& in, State& state) const noexcept;

  /// From line of sight to longitudinal wind for one beam: u = (v_los - own motion)/(-n_x).
  struct Projection {
    Vec3 beam_dir_I{-1.0, 0.0, 0.0};
    double own_motion_mps = 0.0;  // n . V_lidar
    double per_los = 1.0;         // 1/(-n_x)
    double longitudinal_mps(double los_mps) const { return (los_mps - own_motion_mps) * per_los; }
  };
  Projection projection(const LidarMeasurement& m) const noexcept;

 private:
  /// By gate; not a number where there is none.
  using Winds = std::array<double, native_lidar::kMaxGates>;

  void take_in(const Inputs& in, State& state) const noexcept;
  void project(const LidarMeasurement& m, const Projection& p, Winds& wind_mps,
               State& state) const noexcept;
  /// Its induction is not a number if the gate has no place.
  WindReconstruction::Sample sample(const LidarMeasurement& m, std::size_t gate,
                                    const Projection& p, State& state) const noexcept;
  void correct(const LidarMeasurement& m, const Projection& p, Winds& wind_mps,
               State& state) const noexcept;
  double nearest_allowed_m(const Inputs& in, const State& state) const noexcept;
  void note_scan(const LidarMeasurement& m, State& state) const noexcept;
  bool settled(const State& state) const noexcept;
  void note_turbine(const Inputs& in, State& state) const noexcept;
  bool turbine_sets_travel(double time_s, const State& state) const noexcept;
  double travel_mps(double time_s, const State& state) const noexcept;
  void update_mean_speed(const LidarMeasurement& m, const Winds& wind_mps,
                         State& state) const noexcept;
  void estimate(const Inputs& in, State& state, Outputs& out) const noexcept;
  void bridge(const Inputs& in, State& state, Outputs& out) const noexcept;

  LdpParams params_;
  double time_step_s_;
  std::int64_t window_steps_;
  double share_s_;  // of the scan, for one measurement
  Availability::Params expected_;
  WindReconstruction reconstruction_;
  InductionCorrection induction_;
  SpikeFilter spikes_;
};

}  // namespace lac
