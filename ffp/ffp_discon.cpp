// SPDX-License-Identifier: Apache-2.0
// Records <-> Ffp. Reads the Lidar* records of the chain block, writes the Feedforward* ones.
#include "core/chain_block.hpp"
#include "core/discon_module.hpp"
#include "ffp/ffp_records.hpp"
#include "ffp/guo_ffp_discon.hpp"

namespace lac {
namespace {

class FfpModule final : public DisconModule {
 public:
  FfpModule(FfpParams params, double time_step_s)
      : by_monitor_(params.use_monitor),
        by_turbulence_(!params.turbulence_factor.empty()),
        by_power_level_(!params.reduced_pitch_rad.empty()),
        ffp_(std::move(params), time_step_s),
        state_(ffp_.initial_state()) {}

  void step(SwapView swap, double time_s, Notice& notice) noexcept override {
    const Ffp::Inputs in = inputs(swap);
    const Ffp::Outputs out = ffp_.step(in, state_);
    report(in, out, notice);
    if (by_monitor_) look_for_monitor(swap, time_s, notice);
    write_feedforward(out, swap);
  }

  void visit_state(StateArchive& a) override {
    a(state_), a(last_), a(was_on_), a(monitor_told_), a(monitor_seen_);
  }

 private:
  /// What the parameters ask for, and no other record.
  Ffp::Inputs inputs(const SwapView& swap) const noexcept {
    Ffp::Inputs in;
    in.rews_mps = swap.get(Rec::LidarRews);
    in.valid = swap.integer(Rec::LidarRewsValid, 0) == 1;
    in.lead_s = swap.get(Rec::LidarRewsLead);
    in.window_s = swap.get(Rec::LidarScanWindow);
    in.mean_speed_mps = swap.get(Rec::LidarMeanSpeed);
    if (by_monitor_) {
      in.monitor_authority = swap.get(Rec::MonitorAuthority);
      in.monitor_trim_s = swap.get(Rec::MonitorBufferTrim);
    }
    if (by_turbulence_ && swap.integer(Rec::TurbulenceValid, 0) == 1) {
      in.turbulence_intensity = swap.get(Rec::TurbulenceIntensity);
    }
    if (by_power_level_ && swap.integer(Rec::PowerLevelValid, 0) == 1) {
      in.power_level = swap.get(Rec::PowerLevel);
    }
    return in;
  }

  /// Passing the threshold, filling the buffer and a monitor that takes authority away (it says so
  /// itself) are daily life; the rest is told, an invalid monitor once.
  void report(const Ffp::Inputs& in, const Ffp::Outputs& out, Notice& notice) noexcept {
    if (out.reason == last_) return;
    last_ = out.reason;
    if (out.reason == FfpReason::LeadTooShort) {
      notice.warn("feedforward off: %s: %.2f s, needed %.2f s", text_of(out.reason), in.lead_s,
                  out.lead_needed_s);
    } else if (out.reason == FfpReason::BufferTooLong || out.reason == FfpReason::OutsideCurve ||
               (out.reason == FfpReason::NoWind && was_on_)) {
      notice.warn("feedforward off: %s", text_of(out.reason));
    } else if (out.reason == FfpReason::RateLimited || out.reason == FfpReason::PitchLimited) {
      notice.warn("feedforward: %s", text_of(out.reason));
    } else if (out.reason == FfpReason::MonitorInvalid && !monitor_told_) {
      notice.warn("feedforward off: %s: %g, %g s", text_of(out.reason), in.monitor_authority,
                  in.monitor_trim_s);
      monitor_told_ = true;
    }
    was_on_ = was_on_ || out.active > 0.0;
  }

  /// One that allows nothing gives a reason; where nobody writes, both records stay 0.
  void look_for_monitor(const SwapView& swap, double time_s, Notice& notice) noexcept {
    if (monitor_seen_) return;
    monitor_seen_ = swap.get(Rec::MonitorAuthority) != 0.0 || swap.get(Rec::MonitorReason) != 0.0;
    if (monitor_seen_ || time_s < kMonitorWait_s) return;
    notice.warn("feedforward off: UseMonitor is set, but no monitor in the chain writes its share");
    monitor_seen_ = true;
  }

  static constexpr double kMonitorWait_s = 1.0;

  bool by_monitor_;
  bool by_turbulence_;
  bool by_power_level_;
  Ffp ffp_;
  Ffp::State state_;
  FfpReason last_ = FfpReason::None;
  bool was_on_ = false;
  bool monitor_told_ = false;
  bool monitor_seen_ = false;  // or missed, and told so
};

}  // namespace

const char* module_name() {
  return "ffp";
}

std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView swap, Notice& notice) {
  if (auto guo = make_guo_ffp(start, swap, notice)) return guo;
  InputFile in = InputFile::load(start.input_file);
  FfpParams params = FfpParams::read(in);
  params.check_time_step(in, start.time_step_s);
  require_chain_block(swap);
  return std::make_unique<FfpModule>(std::move(params), start.time_step_s);
}

}  // namespace lac
