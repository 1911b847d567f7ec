// SPDX-License-Identifier: Apache-2.0
// Records <-> Bridge. Reads the Feedforward* and PowerLevel* records of the chain block and the
// pitch demands; writes, each only with its route, tower accelerations, pitch demands, hub wind.
#include <array>

#include "bridge/bridge.hpp"
#include "core/chain_block.hpp"
#include "core/discon_module.hpp"

namespace lac {
namespace {

constexpr std::array kDemandRecords = {Rec::PitchDemand1, Rec::PitchDemand2, Rec::PitchDemand3,
                                       Rec::PitchDemandCollective};

class BridgeModule final : public DisconModule {
 public:
  BridgeModule(const BridgeParams& params, double time_step_s)
      : feedforward_(params.feedforward),
        derating_(params.derating),
        bridge_(params, time_step_s) {}

  void step(SwapView swap, double /*time_s*/, Notice& notice) noexcept override {
    Bridge::Events events;
    const Bridge::Outputs out = bridge_.step(read(swap), state_, events);
    report(events, notice);
    report_missing_sources(swap, notice);
    if (feedforward_ != FeedforwardRoute::None) write_feedforward(out, swap);
    if (derating_ != DeratingRoute::None) {
      swap.set(Rec::HubWindSpeed, out.hub_wind_mps);
      swap.set(Rec::BridgeWindSpeed, out.hub_wind_mps);
    }
  }

  void visit_state(StateArchive& a) override { a(state_), a(sources_checked_); }

 private:
  static Bridge::Inputs read(const SwapReader& swap) noexcept {
    Bridge::Inputs in;
    in.rate_radps = swap.get(Rec::FeedforwardPitchRate);
    in.active = swap.get(Rec::FeedforwardActive);
    in.good = swap.get(Rec::ChainInputsGood) != 0.0;
    in.nacelle_direction_rad = swap.get(Rec::NacelleDirection);
    in.pitch_rad = swap.get(Rec::PitchBlade1);
    for (std::size_t i = 0; i < kDemandRecords.size(); ++i) {
      in.demands[i] = static_cast<float>(swap.get(kDemandRecords[i]));
    }
    if (swap.integer(Rec::PowerLevelValid, 0) == 1) in.power_level = swap.get(Rec::PowerLevel);
    in.yaw_error_rad = swap.get(Rec::YawError);
    return in;
  }

  static void report(const Bridge::Events& events, Notice& notice) noexcept {
    if (events.rate_lost) {
      notice.warn("feedforward pitch rate is not a number: taken as off until it is one");
    }
    if (events.nobody_writes) {
      notice.warn(
          "nobody has written a pitch demand since the last call of this library: with "
          "FeedforwardRoute added it stands behind the controller that writes it");
    }
    if (events.nobody_follows) {
      notice.warn(
          "the measured pitch (record 4) does not show what is added to the demands: with "
          "FeedforwardRoute added this library stands last, behind the controller that writes "
          "the demands");
    }
    if (events.level_lost) {
      notice.warn("power level is not within 0 and MaximumPowerLevel: taken as 1 until it is");
    }
  }

  /// Looked at in the first call. ffp and ti_estimator leave no zeros: off has a reason, an unknown
  /// power level is 1.
  void report_missing_sources(const SwapReader& swap, Notice& notice) noexcept {
    if (sources_checked_) return;
    sources_checked_ = true;
    const auto check = [&](Rec a, Rec b, const char* what, const char* writer) {
      if (swap.get(a) != 0.0 || swap.get(b) != 0.0) return;
      notice.warn("no library in front of this one has written a %s: is %s missing, or behind it?",
                  what, writer);
    };
    if (feedforward_ != FeedforwardRoute::None) {
      check(Rec::FeedforwardActive, Rec::FeedforwardReason, "feedforward", "ffp");
    }
    if (derating_ != DeratingRoute::None) {
      check(Rec::PowerLevel, Rec::PowerLevelValid, "power level", "ti_estimator");
    }
  }

  void write_feedforward(const Bridge::Outputs& out, SwapView& swap) const noexcept {
    swap.set(Rec::BridgePitchIncrement, out.increment_rad);
    swap.set(Rec::BridgeLimited, out.limited ? 1.0 : 0.0);
    if (feedforward_ == FeedforwardRoute::TowerDamper) {
      swap.set(Rec::TowerForeAftAcceleration, static_cast<double>(out.tower.fore_aft_mps2));
      swap.set(Rec::TowerSideSideAcceleration, static_cast<double>(out.tower.side_side_mps2));
      return;
    }
    for (std::size_t i = 0; i < kDemandRecords.size(); ++i) {
      swap.set(kDemandRecords[i], static_cast<double>(out.demands[i]));
    }
  }

  FeedforwardRoute feedforward_;
  DeratingRoute derating_;
  Bridge bridge_;
  Bridge::State state_;
  bool sources_checked_ = false;
};

}  // namespace

const char* module_name() {
  return "bridge";
}

std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView swap, Notice&) {
  InputFile in = InputFile::load(start.input_file);
  const BridgeParams params = BridgeParams::read(in);
  params.check_time_step(in, start.time_step_s);
  require_chain_block(swap);
  return std::make_unique<BridgeModule>(params, start.time_step_s);
}

}  // namespace lac
