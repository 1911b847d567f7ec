// SPDX-License-Identifier: Apache-2.0
// Records <-> GuoFfp. Reads the REWS of the chain block where an LDP of ours writes it, else the
// one behind Guo's lidar block; writes its results to both places as far as they are there.
#include "ffp/guo_ffp_discon.hpp"

#include "core/chain_block.hpp"
#include "core/guo_block.hpp"
#include "core/lidar_reader.hpp"
#include "ffp/ffp_records.hpp"
#include "ffp/guo_ffp.hpp"
#include "ffp/guo_ffp_legacy.hpp"

namespace lac {
namespace {

const LidarReaderParams kPlausible;  // bounds of a wind speed

struct Rews {
  double speed_mps = kGuoNoValue;
  bool valid = false;
};

/// A record that nobody has written yet is 0; theirs says 999 where it has none, and takes -99 into
/// its mean.
Rews rews_of_block(const SwapReader& swap, GuoBlock block) {
  const double v_mps = guo_result(swap, block, guo_lidar::kRews);
  return {v_mps,
          v_mps != 0.0 && v_mps >= kPlausible.min_speed_mps && v_mps <= kPlausible.max_speed_mps};
}

/// Our LDP writes a number or "not a number" from its first call on, never 0.
bool ldp_of_ours_writes(const SwapReader& swap) {
  return swap.get(Rec::LidarRews) != 0.0;
}
Rews rews_of_chain(const SwapReader& swap) {
  const bool valid = swap.integer(Rec::LidarRewsValid, 0) == 1;
  return {valid ? swap.get(Rec::LidarRews) : kGuoNoValue, valid};
}

class GuoFfpModule final : public DisconModule {
 public:
  GuoFfpModule(const GuoFfpParams& params, double time_step_s, bool in_chain)
      : legacy_timing_(params.legacy_timing),
        ffp_(params, time_step_s),
        legacy_(params, static_cast<float>(time_step_s)),
        state_(ffp_.initial_state()),
        legacy_state_(legacy_.initial_state()),
        in_chain_(in_chain) {}

  void step(SwapView swap, double /*time_s*/, Notice& notice) noexcept override {
    const GuoBlock block = find_guo_results(swap);
    const Rews rews = find_rews(swap, block, notice);
    const Ffp::Outputs out = legacy_timing_ ? legacy_.step(rews.speed_mps, legacy_state_)
                                            : ffp_.step(rews.speed_mps, rews.valid, state_);
    report(out.reason, notice);
    if (block.first != 0) {
      put_guo_result(swap, block, guo_lidar::kRewsBuffered, out.buffered_mps);
      put_guo_result(swap, block, guo_lidar::kPitchRate, out.rate_radps);
      put_guo_result(swap, block, guo_lidar::kRewsFiltered, out.filtered_mps);
    }
    if (in_chain_) write_feedforward(out, swap);
  }

  void visit_state(StateArchive& a) override {
    a(state_), a(legacy_state_), a(no_rews_reported_), a(was_on_), a(limit_reported_);
  }

 private:
  Rews find_rews(const SwapReader& swap, GuoBlock block, Notice& notice) noexcept {
    const bool chain = in_chain_ && ldp_of_ours_writes(swap);
    if (block.first != 0 && (legacy_timing_ || !chain)) return rews_of_block(swap, block);
    if (chain) return rews_of_chain(swap);
    if (!no_rews_reported_) {
      notice.warn(
          "no wind speed to read: no LDP of ours has been called before, and record 63 (%g) is not "
          "the start of a lidar block of Guo's layout (behind the LAC wrapper: its keys "
          "LidarLayout, GuoSecondaries)",
          swap.get(Rec::LogStart));
    }
    no_rews_reported_ = true;
    return {};
  }

  void report(FfpReason reason, Notice& notice) noexcept {
    if (reason == FfpReason::NoWind) {
      if (was_on_) notice.warn("feedforward off: %s", text_of(reason));
      was_on_ = false;
    } else if (reason != FfpReason::Filling) {
      was_on_ = true;
    }
    if (reason != FfpReason::RateLimited || limit_reported_) return;
    notice.warn(
        "feedforward: the wind speed moves faster than the pitch may, which follows at %.3g rad/s "
        "(told once)",
        FfpParams{}.max_rate_radps);
    limit_reported_ = true;
  }

  bool legacy_timing_;
  GuoFfp ffp_;
  GuoFfpLegacy legacy_;
  GuoFfp::State state_;
  GuoFfpLegacy::State legacy_state_;
  bool in_chain_;
  bool no_rews_reported_ = false;
  bool was_on_ = false;
  bool limit_reported_ = false;
};

}  // namespace

std::unique_ptr<DisconModule> make_guo_ffp(const StartInfo& start, SwapView swap, Notice& notice) {
  const GuoInputFile file = GuoInputFile::load(start.input_file);
  if (!file.is_theirs(guo_ffp_marks())) return nullptr;
  const GuoFfpParams params = GuoFfpParams::read(file, start.time_step_s);
  if (!start.is_restart())
    notice.warn(
        "input file read as %s of Guo's chain%s; differences: docs/hosts/guo.md",
        GuoFfpParams::form_of(file).name.c_str(),
        params.legacy_timing ? ", with LegacyTiming: values as theirs, defects included" : "");
  return std::make_unique<GuoFfpModule>(params, start.time_step_s, has_chain_block(swap));
}

}  // namespace lac
