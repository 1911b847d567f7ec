// SPDX-License-Identifier: Apache-2.0
// Records <-> TiEstimator. Reads the host's lidar block, records 24 and 27 and what ldp and monitor
// have written, writes the Turbulence* and PowerLevel* records of the chain block.
#include "core/chain_block.hpp"
#include "core/discon_module.hpp"
#include "ti_estimator/ti_estimator.hpp"

namespace lac {
namespace {

class TiEstimatorModule final : public DisconModule {
 public:
  TiEstimatorModule(const TiEstimatorParams& params, double time_step_s)
      : params_(params),
        reader_(params.reader),
        estimator_(params, time_step_s),
        state_(estimator_.initial_state()),
        reader_state_(reader_.initial_state()) {}

  const LidarReader& reader() const { return reader_; }

  void step(SwapView swap, double time_s, Notice& notice) noexcept override {
    TiEstimator::Inputs in = inputs(swap);
    in.time_s = time_s;
    if (reader_.read(swap, time_s, reader_state_, measurement_, notice)) {
      in.measurement = &measurement_;
    }
    const TiEstimator::Outputs out = estimator_.step(in, state_);
    report(out, notice);
    report_absence(out, time_s, notice);
    write(out, swap);
  }

  void visit_state(StateArchive& a) override { a(state_), a(reader_state_), a(reported_); }

 private:
  struct Reported {
    bool gates = false, direction = false, room = false;  // once per run
    bool valid = false, outside = false, source = false;  // at each change
    bool absence = false;                                 // once per run, or nothing was absent
    void visit(StateArchive& a) {
      a(gates), a(direction), a(room), a(valid), a(outside), a(source), a(absence);
    }
  };

  void report(const TiEstimator::Outputs& out, Notice& notice) noexcept {
    if (out.too_many_gates && !reported_.gates) {
      notice.warn("lidar sends %d gates, only the first %d are used (NumberOfGates)",
                  measurement_.gate_count, params_.number_of_gates);
    }
    if (out.other_direction && !reported_.direction) {
      notice.warn(
          "beam %d looks more than 2 deg away from its BeamAzimuth and BeamElevation: "
          "c_TI is that of another beam",
          measurement_.beam_id);
    }
    if (out.no_room && !reported_.room) {
      notice.warn("lidar measures much faster than ScanTime says: some samples are not used");
    }
    if (out.outside_table && !reported_.outside) {
      notice.warn("mean wind (%.1f m/s) or yaw error outside the c_TI table: no estimate",
                  out.mean_speed_mps);
    } else if (reported_.valid && !out.valid()) {
      notice.warn("turbulence intensity lost: %d volumes have enough samples%s%s",
                  out.filled_series,
                  out.ldp_missing ? ", ldp gives no mean wind speed or yaw error" : "",
                  by_lidar() ? "; the power level goes back to 1" : "");
    }
    const bool source_valid = estimate(params_.power_level_source, out).valid();
    if (!by_lidar() && reported_.source && !source_valid) {
      notice.warn(
          "turbulence intensity that PowerLevelSource asks for lost; the power level goes "
          "back to 1");
    }
    reported_ = {reported_.gates || out.too_many_gates,
                 reported_.direction || out.other_direction,
                 reported_.room || out.no_room,
                 out.valid(),
                 out.outside_table,
                 source_valid,
                 reported_.absence};
  }

  /// What has never come although it should have by now.
  void report_absence(const TiEstimator::Outputs& out, double time_s, Notice& notice) noexcept {
    const bool source_valid = estimate(params_.power_level_source, out).valid();
    reported_.absence = reported_.absence || (source_valid && out.valid());
    if (reported_.absence || time_s < params_.averaging_time_s + kPatience_s) return;
    reported_.absence = true;
    if (out.ldp_missing) {
      notice.warn("no turbulence intensity so far: ldp gives no mean wind speed or yaw error");
    } else if (!by_lidar() && !source_valid) {
      notice.warn(
          "the power level rests: PowerLevelSource has given no turbulence intensity so far");
    }
  }

  /// What the parameters ask for, and no other record.
  TiEstimator::Inputs inputs(const SwapView& swap) const noexcept {
    TiEstimator::Inputs in;
    if (params_.use_yaw_error) in.yaw_error_rad = yaw_error_rad(swap);
    // 0 where no ldp writes.
    if (params_.mean_speed_of_ldp && swap.get(Rec::LidarMeanSpeed) > 0.0) {
      in.ldp_mean_speed_mps = swap.get(Rec::LidarMeanSpeed);
    }
    if (params_.has(IntensitySource::Anemometer)) in.anemometer_mps = swap.get(Rec::HubWindSpeed);
    if (params_.has(IntensitySource::Turbine) && swap.get(Rec::TurbineRewsValid) == 1.0) {
      in.turbine_rews_mps = swap.get(Rec::TurbineRews);
    }
    return in;
  }

  /// Not a number where no ldp reconstructs the wind.
  double yaw_error_rad(const SwapView& swap) const noexcept {
    if (!params_.yaw_error_of_ldp) return swap.get(Rec::YawError);
    return swap.get(Rec::LidarReconstruction) > 0.0 ? swap.get(Rec::LidarYawError)
                                                    : std::numeric_limits<double>::quiet_NaN();
  }
  bool by_lidar() const { return params_.power_level_source == IntensitySource::Lidar; }
  static const IntensityEstimate& estimate(IntensitySource source,
                                           const TiEstimator::Outputs& out) {
    return out.estimates[static_cast<std::size_t>(source)];
  }

  void write(const TiEstimator::Outputs& out, SwapView& swap) const noexcept {
    swap.set(Rec::TurbulenceIntensity, out.intensity);
    swap.set(Rec::TurbulenceValid, out.valid() ? 1.0 : 0.0);
    write_other(IntensitySource::Uncorrected, Rec::TurbulenceUncorrected, out, swap);
    write_other(IntensitySource::Anemometer, Rec::TurbulenceAnemometer, out, swap);
    write_other(IntensitySource::Turbine, Rec::TurbulenceTurbine, out, swap);
    swap.set(Rec::PowerLevel, out.power_level);
    swap.set(Rec::PowerLevelValid, out.power_level_valid ? 1.0 : 0.0);
  }

  void write_other(IntensitySource source, Rec record, const TiEstimator::Outputs& out,
                   SwapView& swap) const noexcept {
    if (params_.has(source)) swap.set(record, estimate(source, out).intensity);
  }

  static constexpr double kPatience_s = 60.0;  // beyond AveragingTime

  TiEstimatorParams params_;
  LidarReader reader_;
  TiEstimator estimator_;
  TiEstimator::State state_;
  LidarReader::State reader_state_;
  LidarMeasurement measurement_;
  Reported reported_;
};

}  // namespace

const char* module_name() {
  return "ti_estimator";
}

std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView swap, Notice& notice) {
  InputFile in = InputFile::load(start.input_file);
  auto module = std::make_unique<TiEstimatorModule>(TiEstimatorParams::read(in), start.time_step_s);
  require_chain_block(swap);
  if (!start.is_restart()) module->reader().require(swap, start.time_step_s, notice);
  return module;
}

}  // namespace lac
