// SPDX-License-Identifier: Apache-2.0
// Records <-> Monitor. Reads what the turbine measures, the Lidar* records and two of the
// Feedforward* ones, writes TurbineRews* and Monitor*.
#include "core/chain_block.hpp"
#include "core/discon_module.hpp"
#include "monitor/monitor.hpp"

namespace lac {
namespace {

class MonitorModule final : public DisconModule {
 public:
  MonitorModule(const MonitorParams& params, double time_step_s)
      : monitor_(params, time_step_s), state_(monitor_.initial_state()) {}

  void step(SwapView swap, double /*time_s*/, Notice& notice) noexcept override {
    const Monitor::Outputs out = monitor_.step(inputs(swap), state_);
    report(out, notice);
    swap.set(Rec::TurbineRews, out.turbine_mps);
    swap.set(Rec::TurbineRewsValid, std::isfinite(out.turbine_mps) ? 1.0 : 0.0);
    swap.set(Rec::MonitorAuthority, out.authority);
    swap.set(Rec::MonitorBufferTrim, out.trim_s);
    swap.set(Rec::MonitorDelay, out.delay_s);
    swap.set(Rec::MonitorCoherence, out.coherence);
    swap.set(Rec::MonitorGain, out.gain);
    swap.set(Rec::MonitorReason, static_cast<int>(out.reason));
  }

  void visit_state(StateArchive& a) override { a(state_), a(reduced_); }

 private:
  // Told when the authority has fallen below, and when it is back above.
  static constexpr double kReduced = 0.8, kBack = 0.95;

  static Monitor::Inputs inputs(const SwapReader& swap) noexcept {
    Monitor::Inputs in;
    in.turbine.generator_speed_radps = swap.get(Rec::GeneratorSpeed);
    in.turbine.generator_torque_Nm = swap.get(Rec::GeneratorTorque);
    in.turbine.pitch_rad = swap.get(Rec::PitchBlade1);
    in.turbine.usable =
        swap.integer(Rec::ChainInputsGood, 0) == 1 && swap.integer(Rec::GeneratorContactor, 0) == 1;
    in.lidar_mps = swap.get(Rec::LidarRews);
    in.lidar_valid = swap.integer(Rec::LidarRewsValid, 0) == 1;
    in.lead_s = swap.get(Rec::LidarRewsLead);
    in.window_s = swap.get(Rec::LidarScanWindow);
    // A record that nobody writes is 0.
    const double cutoff_hz = swap.get(Rec::FeedforwardCutOff);
    if (cutoff_hz > 0.0) {
      in.cutoff_hz = cutoff_hz;
      in.buffer_time_s = swap.get(Rec::FeedforwardBufferTime);
      in.buffered_mps = swap.get(Rec::RewsBuffered);
    }
    return in;
  }

  /// What was found out by comparing; a lidar without valid wind is told by those who read it.
  void report(const Monitor::Outputs& out, Notice& notice) noexcept {
    const bool compared = out.reason >= MonitorReason::LowCoherence;
    if (!reduced_ && compared && out.authority < kReduced) {
      notice.warn(
          "feedforward authority below %g: %s (coherence %.2f, gain %.2f, late by %.1f s, rotor "
          "over lidar %.2f)",
          kReduced, text_of(out.reason), out.coherence, out.gain, out.late_s, out.mean_ratio);
      reduced_ = true;
    } else if (reduced_ && out.authority > kBack) {
      notice.warn("feedforward authority back above %g: %s", kBack, text_of(out.reason));
      reduced_ = false;
    }
  }

  Monitor monitor_;
  Monitor::State state_;
  bool reduced_ = false;
};

}  // namespace

const char* module_name() {
  return "monitor";
}

std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView swap, Notice&) {
  InputFile in = InputFile::load(start.input_file);
  const MonitorParams params = MonitorParams::read(in);
  params.check_time_step(in, start.time_step_s);
  require_chain_block(swap);
  return std::make_unique<MonitorModule>(params, start.time_step_s);
}

}  // namespace lac
