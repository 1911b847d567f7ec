// SPDX-License-Identifier: Apache-2.0
// Records <-> GuoLdp. Reads Guo's lidar block, writes the REWS behind it and, behind our master,
// the Lidar* records of the chain block.
#include "ldp/guo_ldp_discon.hpp"

#include "core/chain_block.hpp"
#include "core/guo_block.hpp"
#include "ldp/guo_ldp.hpp"
#include "ldp/ldp_records.hpp"

namespace lac {
namespace {

class GuoLdpModule final : public DisconModule {
 public:
  GuoLdpModule(GuoLdpParams params, bool in_chain)
      : ldp_(std::move(params)), state_(ldp_.initial_state()), in_chain_(in_chain) {}

  void step(SwapView swap, double time_s, Notice& notice) noexcept override {
    const GuoBlock block = find_guo_results(swap);
    GuoLdp::Inputs in;
    in.time_s = time_s;
    if (block.first == 0) {
      report_no_block(swap, notice);
    } else if (guo_lidar_is_new(swap.data(), block)) {
      read_guo_lidar(swap.data(), block, measurement_);
      if (is_usable(measurement_, notice)) in.measurement = &measurement_;
    }
    const Ldp::Outputs out = ldp_.step(in, state_);
    report(out, notice);
    write(out, block, swap);
  }

  void visit_state(StateArchive& a) override {
    a(state_), a(was_valid_), a(no_block_reported_), a(beam_reported_);
  }

 private:
  void report_no_block(const SwapReader& swap, Notice& notice) noexcept {
    if (no_block_reported_) return;
    no_block_reported_ = true;
    notice.warn(
        "record 63 (%g) is not the start of a lidar block of Guo's layout with at least one gate: "
        "no wind speed until it is (behind the LAC wrapper: its keys LidarLayout, GuoSecondaries)",
        swap.get(Rec::LogStart));
  }

  bool is_usable(const LidarMeasurement& m, Notice& notice) noexcept {
    const GuoLdpParams& p = ldp_.params();
    const int beams = static_cast<int>(p.beam_dir_L.size());
    const bool beam_known = p.one_direction || (m.beam_id >= 0 && m.beam_id < beams);
    const bool gate_there = p.gate <= m.gate_count;
    if (beam_known && gate_there) return true;
    if (!beam_reported_) {
      if (!beam_known) {
        notice.warn(
            "lidar: beam id %d, the input file has directions for 0 to %d; such beams are "
            "not used",
            m.beam_id, beams - 1);
      } else {
        notice.warn("lidar: %d gates, IndexGate is %d: no wind speed", m.gate_count, p.gate);
      }
    }
    beam_reported_ = true;
    return false;
  }

  void report(const Ldp::Outputs& out, Notice& notice) noexcept {
    if (was_valid_ && !out.valid) {
      notice.warn(
          "no valid lidar wind speed: %d of the last %d samples are good, the newest %.1f s "
          "old",
          out.samples, ldp_.params().samples, out.data_age_s);
    }
    was_valid_ = out.valid;
  }

  void write(const Ldp::Outputs& out, GuoBlock block, SwapView& swap) const noexcept {
    const bool as_it_is = out.valid || ldp_.params().legacy_timing;
    if (block.first != 0) {
      put_guo_result(swap, block, guo_lidar::kRews, as_it_is ? out.rews_mps : kGuoNoValue);
    }
    if (in_chain_) write_lidar_rews(out, out.scan_time_s, swap);
  }

  GuoLdp ldp_;
  GuoLdp::State state_;
  LidarMeasurement measurement_;
  bool in_chain_;
  bool was_valid_ = false;
  bool no_block_reported_ = false;
  bool beam_reported_ = false;
};

}  // namespace

std::unique_ptr<DisconModule> make_guo_ldp(const StartInfo& start, SwapView swap, Notice& notice) {
  const GuoInputFile file = GuoInputFile::load(start.input_file);
  if (!file.is_theirs(guo_ldp_marks())) return nullptr;
  GuoLdpParams params = GuoLdpParams::read(file);
  if (!start.is_restart())
    notice.warn(
        "input file read as %s of Guo's chain%s; differences: docs/hosts/guo.md",
        GuoLdpParams::form_of(file).name.c_str(),
        params.legacy_timing ? ", with LegacyTiming: values as theirs, defects included" : "");
  return std::make_unique<GuoLdpModule>(std::move(params), has_chain_block(swap));
}

}  // namespace lac
