// SPDX-License-Identifier: Apache-2.0
// Records <-> Feedback. Behind the master it reads the records of the chain and fills in its own;
// named directly in a host it works on the host's records alone.
#include "core/chain_block.hpp"
#include "core/discon_module.hpp"
#include "feedback/feedback.hpp"

namespace lac {
namespace {

class FeedbackModule final : public DisconModule {
 public:
  FeedbackModule(const FeedbackParams& params, double time_step_s, bool in_chain)
      : feedback_(params, time_step_s),
        in_chain_(in_chain),
        use_feedforward_(params.use_feedforward),
        use_power_level_(params.use_power_level) {}

  void step(SwapView swap, double /*time_s*/, Notice& notice) noexcept override {
    Feedback::Events events;
    const Feedback::Outputs out = feedback_.step(read(swap), state_, events);
    report(events, notice);
    write_demands(out, swap);
    if (in_chain_) write_chain(out, swap);
  }

  void visit_state(StateArchive& a) override { a(state_); }

 private:
  Feedback::Inputs read(const SwapReader& swap) const noexcept {
    Feedback::Inputs in;
    in.generator_speed_radps = swap.get(Rec::GeneratorSpeed);
    in.pitch_rad = swap.get(Rec::PitchBlade1);
    in.generator_torque_Nm = swap.get(Rec::GeneratorTorque);
    in.good = !in_chain_ || swap.get(Rec::ChainInputsGood) != 0.0;
    if (use_feedforward_) in.feedforward_rate_radps = swap.get(Rec::FeedforwardPitchRate);
    if (use_power_level_ && swap.integer(Rec::PowerLevelValid, 0) == 1) {
      in.power_level = swap.get(Rec::PowerLevel);
    }
    return in;
  }

  static void report(const Feedback::Events& events, Notice& notice) noexcept {
    if (events.hold_began) {
      notice.warn("a measured record is not a number: demands hold, the controller waits");
    }
    if (events.recovered_after_steps > 0) {
      notice.warn("measured records are good again: recovered after %d steps",
                  events.recovered_after_steps);
    }
    if (events.feedforward_lost) {
      notice.warn("feedforward pitch rate is not a number: taken as 0 until it is one");
    }
    if (events.power_level_lost) {
      notice.warn("power level is not within 0 and MaximumPowerLevel: taken as 1 until it is");
    }
  }

  static void write_demands(const Feedback::Outputs& out, SwapView& swap) noexcept {
    swap.set(Rec::GeneratorContactor, 1.0);
    for (const Rec pitch :
         {Rec::PitchDemand1, Rec::PitchDemand2, Rec::PitchDemand3, Rec::PitchDemandCollective}) {
      swap.set(pitch, out.pitch_rad);
    }
    swap.set(Rec::TorqueDemand, out.torque_Nm);
    for (const Rec unused :
         {Rec::ShaftBrake, Rec::YawTorqueDemand, Rec::PitchRateDemand, Rec::YawRateDemand,
          Rec::PitchOverride, Rec::TorqueOverride, Rec::StartupResistance, Rec::LoadRequest,
          Rec::SlipCurrentFlag, Rec::SlipCurrentDemand}) {
      swap.set(unused, 0.0);
    }
  }

  static void write_chain(const Feedback::Outputs& out, SwapView& swap) noexcept {
    swap.set(Rec::FeedbackSpeedFiltered, out.speed_filtered_radps);
    swap.set(Rec::FeedbackRegion, region_number(out.region));
    swap.set(Rec::FeedbackPitchIntegral, out.pitch_integral_rad);
    swap.set(Rec::FeedbackSetPointFade, out.set_point_shift_radps);
  }

  Feedback feedback_;
  Feedback::State state_;
  bool in_chain_;
  bool use_feedforward_;
  bool use_power_level_;
};

void require_chain_for(const InputFile& in, const char* key, const SwapReader& swap) {
  try {
    require_chain_block(swap);
  } catch (const Error& error) {
    in.fail(key, std::string("found true, but ") + error.what());
  }
}

}  // namespace

const char* module_name() {
  return "feedback";
}

std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView swap, Notice&) {
  InputFile in = InputFile::load(start.input_file);
  const FeedbackParams params = FeedbackParams::read(in);
  params.check_time_step(in, start.time_step_s);
  if (params.use_feedforward) require_chain_for(in, "UseFeedforward", swap);
  if (params.use_power_level) require_chain_for(in, "UsePowerLevel", swap);
  return std::make_unique<FeedbackModule>(params, start.time_step_s, has_chain_block(swap));
}

}  // namespace lac
