// SPDX-License-Identifier: Apache-2.0
// Records <-> Ldp. Reads the host's lidar block, writes the Lidar* records of the chain block.
#include "core/chain_block.hpp"
#include "core/discon_module.hpp"
#include "ldp/guo_ldp_discon.hpp"
#include "ldp/ldp_records.hpp"
#include "ldp/ldp_reports.hpp"

namespace lac {
namespace {

class LdpModule final : public DisconModule {
 public:
  LdpModule(const LdpParams& params, double time_step_s)
      : scan_time_s_(params.scan_time_s),
        travel_by_turbine_(params.travel == TravelSpeed::Turbine),
        reports_(params),
        reader_(params.reader),
        ldp_(params, time_step_s),
        state_(ldp_.initial_state()),
        reader_state_(reader_.initial_state()) {}

  const LidarReader& reader() const { return reader_; }

  void step(SwapView swap, double time_s, Notice& notice) noexcept override {
    Ldp::Inputs in;
    in.time_s = time_s;
    in.lead_needed_s = swap.get(Rec::FeedforwardLeadNeeded);  // written in the step before
    if (travel_by_turbine_ && swap.get(Rec::TurbineRewsValid) == 1.0)
      in.turbine_rews_mps = swap.get(Rec::TurbineRews);
    if (reader_.read(swap, time_s, reader_state_, measurement_, notice)) {
      in.measurement = &measurement_;
    }
    const Ldp::Outputs out = ldp_.step(in, state_);
    reports_.report(out, time_s, notice);
    write_lidar_rews(out, scan_time_s_, swap);
  }

  void visit_state(StateArchive& a) override { a(state_), a(reader_state_), a(reports_); }

 private:
  double scan_time_s_;
  bool travel_by_turbine_;
  LdpReports reports_;
  LidarReader reader_;
  Ldp ldp_;
  Ldp::State state_;
  LidarReader::State reader_state_;
  LidarMeasurement measurement_;
};

}  // namespace

const char* module_name() {
  return "ldp";
}

std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView swap, Notice& notice) {
  if (auto guo = make_guo_ldp(start, swap, notice)) return guo;
  InputFile in = InputFile::load(start.input_file);
  const LdpParams params = LdpParams::read(in);
  params.check_time_step(in, start.time_step_s);
  auto module = std::make_unique<LdpModule>(params, start.time_step_s);
  require_chain_block(swap);
  if (!start.is_restart()) module->reader().require(swap, start.time_step_s, notice);
  return module;
}

}  // namespace lac
