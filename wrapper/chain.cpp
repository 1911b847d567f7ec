// SPDX-License-Identifier: Apache-2.0
#include "wrapper/chain.hpp"

#include <algorithm>

#include "core/discon_abi.h"
#include "core/error.hpp"

namespace lac {
Chain::Chain(WrapperParams params, const StartInfo& start, SwapView host,
             const std::filesystem::path& wrapper_folder)
    : link_(params.lidar, params.extended_demands), params_(std::move(params)) {
  link_.require(host);
  link_.start(host, array_, link_state_);
  array_.view().set(Rec::ChainVersion, kChainLayoutVersion);
  if (std::ranges::any_of(params_.secondaries, &SecondaryParams::guo)) {
    guo_ = std::make_unique<GuoLink>(params_);
    guo_state_ = guo_->initial_state();
    if (!start.is_restart()) guo_->require(host, start.time_step_s, start_warning_);
  }
  for (const SecondaryParams& s : params_.secondaries) {
    secondaries_.push_back(std::make_unique<Secondary>(params_, s, wrapper_folder, start.out_name));
  }
  std::filesystem::path output = params_.output.path(start.out_name);
  if (params_.output.enabled && params_.output.file.empty() && start.out_name.empty()) {
    throw Error(params_.file.string() +
                ": OutputFile: missing, and the host passed no root name (record 51) that the "
                "output file could be named after");
  }
  if (start.is_restart()) {
    step_ = start.steps + 1;
    std::filesystem::path name = output.stem() += ".";
    name += std::to_string(step_);
    output.replace_filename(name += output.extension());
  }
  if (params_.output.enabled) {
    log_ = std::make_unique<SignalLog>(params_.output, output, start.time_step_s, step_);
  }
}

Chain::~Chain() {
  Notice nobody_listens;
  end_all(nobody_listens);
}

void Chain::step(SwapView host, double time_s, Notice& notice) noexcept {
  if (first_call_ && start_warning_.level() != 0) {
    notice.warn("%s", std::string(start_warning_.text()).c_str());
  }
  const bool inputs_good = take_inputs(host, time_s, notice);
  const bool all_went_well =
      call_all(first_call_ ? LAC_STATUS_FIRST : LAC_STATUS_STEP, time_s, notice);
  if (first_call_ && !all_went_well) return;  // the destructor ends those that started
  first_call_ = false;
  if (inputs_good && all_went_well) {
    link_.keep_demands(array_, link_state_);
  } else {
    link_.hold_demands(array_, link_state_);
  }
  link_.give_demands(array_, host, inputs_good && all_went_well);
  record_signals(notice);
  ++step_;
}

bool Chain::take_inputs(SwapView host, double time_s, Notice& notice) noexcept {
  Notice doubts;
  link_.take_inputs(host, array_, link_state_, doubts);
  if (guo_) guo_->fill(array_, link_state_.log_start, time_s, guo_state_, notice);
  if (doubts.level() == 0) {
    input_filter_.quiet();
  } else if (input_filter_.admit(doubts.text(), time_s)) {
    notice.warn("%.*s", static_cast<int>(doubts.text().size()), doubts.text().data());
  }
  SwapView view = array_.view();
  view.set(Rec::ChainVersion, kChainLayoutVersion);
  view.set(Rec::ChainInputsGood, link_state_.holding ? 0.0 : 1.0);
  return !link_state_.holding;
}

bool Chain::call_all(int status, double time_s, Notice& notice) noexcept {
  SwapView view = array_.view();
  for (const auto& s : secondaries_) {
    if (status == LAC_STATUS_FIRST) view.set(Rec::ChainMember, 0.0);
    call(*s, status);
    if (!judge(*s, time_s, notice)) return false;
    if (status == LAC_STATUS_FIRST) {
      s->started = true;
      s->member = view.integer(Rec::ChainMember, 0) == 1;
    }
    if (s->guo() && !s->member) guo_->give(array_, guo_state_);
  }
  return true;
}

void Chain::call(Secondary& s, int status) noexcept {
  if (s.guo()) {
    guo_->take(array_, guo_state_);
    s.call(array_, status, kPrivateGuoBlock.first, false);
  } else {
    s.call(array_, status, link_state_.log_start, link_.logging());
  }
}

bool Chain::judge(Secondary& s, double time_s, Notice& notice) noexcept {
  if (s.fail() < 0) {
    s.tell_failure(notice);
    return false;
  }
  if (s.fail() == 0) {
    s.filter.quiet();
  } else if (s.filter.admit(s.message(), time_s)) {
    s.tell_warning(notice);
  }
  const int bad = HostLink::bad_demand(array_);
  if (bad == 0) return true;
  notice.fail("%s: demand in record %d (%s) is not finite; demands are held", s.label().c_str(),
              bad, find_record(bad)->name.data());
  link_.hold_demands(array_, link_state_);
  return false;
}

void Chain::record_signals(Notice& notice) noexcept {
  if (log_ == nullptr || log_refused_ || log_->take(array_, step_)) return;
  log_refused_ = true;
  notice.warn("OutputFile: the disk refused to take more; the file will not be written");
}

}  // namespace lac
