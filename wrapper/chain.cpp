// SPDX-License-Identifier: Apache-2.0
#include "wrapper/chain.hpp"

#include "core/discon_abi.h"
#include "core/error.hpp"

namespace lac {
namespace {

int length_of(std::string_view text) {
  return static_cast<int>(text.size());
}

void tell_failure(const Secondary& s, Notice& notice) noexcept {
  notice.fail("%s: %.*s", s.label().c_str(), length_of(s.message()), s.message().data());
}

}  // namespace

Chain::Chain(WrapperParams params, const StartInfo& start, SwapView host,
             const std::filesystem::path& wrapper_folder)
    : params_(std::move(params)), link_(params_.lidar, params_.extended_demands) {
  link_.require(host);
  link_.start(host, array_, link_state_);
  array_.view().set(Rec::ChainVersion, kChainLayoutVersion);
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
    output.replace_filename(output.stem().string() + "." + std::to_string(step_) +
                            output.extension().string());
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
  if (doubts.level() == 0) {
    input_filter_.quiet();
  } else if (input_filter_.admit(doubts.text(), time_s)) {
    notice.warn("%.*s", length_of(doubts.text()), doubts.text().data());
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
    s->call(array_, status, link_state_.log_start, link_.logging());
    if (!judge(*s, time_s, notice)) return false;
    if (status == LAC_STATUS_FIRST) {
      s->started = true;
      s->member = view.integer(Rec::ChainMember, 0) == 1;
    }
  }
  return true;
}

bool Chain::judge(Secondary& s, double time_s, Notice& notice) noexcept {
  if (s.fail() < 0) {
    tell_failure(s, notice);
    return false;
  }
  if (s.fail() == 0) {
    s.filter.quiet();
  } else if (s.filter.admit(s.message(), time_s)) {
    notice.warn("%s: %.*s", s.label().c_str(), length_of(s.message()), s.message().data());
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

void Chain::finish(SwapView /*host*/, Notice& notice) {
  end_all(notice);
  secondaries_.clear();
  if (log_ != nullptr) log_->finish();
}

void Chain::end_all(Notice& notice) noexcept {
  for (const auto& s : secondaries_) {
    if (!s->started) continue;
    s->started = false;
    s->call(array_, LAC_STATUS_LAST, link_state_.log_start, link_.logging());
    if (s->fail() < 0) tell_failure(*s, notice);
    if (s->fail() > 0) {
      notice.warn("%s: %.*s", s->label().c_str(), length_of(s->message()), s->message().data());
    }
    if (s->filter.hidden() > 0) {
      notice.warn("%s: %lld more warnings were not shown", s->label().c_str(),
                  static_cast<long long>(s->filter.hidden()));
    }
  }
}

void Chain::visit_state(StateArchive& archive) {
  archive(array_), archive(link_state_), archive(input_filter_), archive(step_);
  for (const auto& s : secondaries_) archive(s->filter);
}

std::filesystem::path Chain::checkpoint_of(std::size_t index,
                                           const std::filesystem::path& file) const {
  return file.string() + "." + std::to_string(index + 1) + "." + secondaries_[index]->name();
}

void Chain::checkpoint(const std::filesystem::path& file, SwapView /*host*/, Notice& notice) {
  for (std::size_t i = 0; i < secondaries_.size(); ++i) {
    Secondary& s = *secondaries_[i];
    s.call_with_file(array_, LAC_STATUS_CHECKPOINT, checkpoint_of(i, file), link_state_.log_start,
                     link_.logging());
    if (s.fail() < 0) tell_failure(s, notice);
  }
  // Some controllers run a control step at this status.
  link_.hold_demands(array_, link_state_);
}

// The array is as it was at -8 by now: some controllers look for their file by time and step.
void Chain::restart(const std::filesystem::path& file, SwapView /*host*/, Notice& notice) {
  SwapView view = array_.view();
  first_call_ = false;
  for (std::size_t i = 0; i < secondaries_.size(); ++i) {
    Secondary& s = *secondaries_[i];
    view.set(Rec::ChainMember, 0.0);
    s.call_with_file(array_, LAC_STATUS_RESTART, checkpoint_of(i, file), link_state_.log_start,
                     link_.logging());
    if (s.fail() < 0) return tell_failure(s, notice);
    s.started = true;
    s.member = view.integer(Rec::ChainMember, 0) == 1;
  }
  link_.hold_demands(array_, link_state_);
}

void Chain::store_or_restore(int status, SwapView /*host*/, Notice& notice) {
  for (const auto& s : secondaries_) {
    if (s->member) {
      s->call(array_, status, link_state_.log_start, link_.logging());
      if (s->fail() < 0) tell_failure(*s, notice);
    } else if (!store_reported_) {
      notice.warn("%s does not know statuses -11 and -10 (store, restore): it is left out",
                  s->label().c_str());
    }
  }
  store_reported_ = true;
}

}  // namespace lac
