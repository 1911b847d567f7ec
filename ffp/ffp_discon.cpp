// SPDX-License-Identifier: Apache-2.0
// Records <-> Ffp. Reads the Lidar* records of the chain block, writes the Feedforward* ones.
#include "core/chain_block.hpp"
#include "core/discon_module.hpp"
#include "ffp/ffp.hpp"

namespace lac {
namespace {

class FfpModule final : public DisconModule {
 public:
  FfpModule(FfpParams params, double time_step_s)
      : ffp_(std::move(params), time_step_s), state_(ffp_.initial_state()) {}

  void step(SwapView swap, double /*time_s*/, Notice& notice) noexcept override {
    Ffp::Inputs in;
    in.rews_mps = swap.get(Rec::LidarRews);
    in.valid = swap.integer(Rec::LidarRewsValid, 0) == 1;
    in.lead_s = swap.get(Rec::LidarRewsLead);
    in.window_s = swap.get(Rec::LidarScanWindow);
    in.mean_speed_mps = swap.get(Rec::LidarMeanSpeed);
    const Ffp::Outputs out = ffp_.step(in, state_);
    report(out.reason, notice);
    write(out, swap);
  }

  void visit_state(StateArchive& a) override { a(state_), a(last_), a(was_on_); }

 private:
  /// Passing below the threshold and filling the buffer are daily life; the rest is told.
  void report(FfpReason reason, Notice& notice) noexcept {
    if (reason == last_) return;
    last_ = reason;
    const bool worth_telling = reason == FfpReason::LeadTooShort ||
                               reason == FfpReason::BufferTooLong ||
                               (reason == FfpReason::NoWind && was_on_);
    if (worth_telling) notice.warn("feedforward off: %s", text_of(reason));
    if (reason == FfpReason::RateLimited) notice.warn("feedforward: %s", text_of(reason));
    was_on_ = was_on_ || reason == FfpReason::None;
  }

  static void write(const Ffp::Outputs& out, SwapView& swap) noexcept {
    swap.set(Rec::FeedforwardPitchRate, out.rate_radps);
    swap.set(Rec::FeedforwardPitch, out.pitch_rad);
    swap.set(Rec::FeedforwardActive, out.active);
    swap.set(Rec::FeedforwardReason, static_cast<int>(out.reason));
    swap.set(Rec::RewsFiltered, out.filtered_mps);
    swap.set(Rec::RewsBuffered, out.buffered_mps);
    swap.set(Rec::FeedforwardBufferTime, out.buffer_time_s);
    swap.set(Rec::FeedforwardCutOff, out.cutoff_hz);
  }

  Ffp ffp_;
  Ffp::State state_;
  FfpReason last_ = FfpReason::None;
  bool was_on_ = false;
};

}  // namespace

const char* module_name() {
  return "ffp";
}

std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView swap, Notice&) {
  InputFile in = InputFile::load(start.input_file);
  auto module = std::make_unique<FfpModule>(FfpParams::read(in), start.time_step_s);
  require_chain_block(swap);
  return module;
}

}  // namespace lac
