// SPDX-License-Identifier: Apache-2.0
// The calls of a chain that are not steps.
#include "core/discon_abi.h"
#include "wrapper/chain.hpp"

namespace lac {

void Chain::finish(SwapView /*host*/, Notice& notice) {
  end_all(notice);
  secondaries_.clear();
  if (log_ != nullptr) log_->finish();
}

void Chain::end_all(Notice& notice) noexcept {
  for (const auto& s : secondaries_) {
    if (!s->started) continue;
    s->started = false;
    call(*s, LAC_STATUS_LAST);
    if (s->fail() < 0) s->tell_failure(notice);
    if (s->fail() > 0) s->tell_warning(notice);
    if (s->filter.hidden() > 0) {
      notice.warn("%s: %lld more warnings were not shown", s->label().c_str(),
                  static_cast<long long>(s->filter.hidden()));
    }
  }
}

void Chain::visit_state(StateArchive& archive) {
  archive(array_), archive(link_state_), archive(input_filter_), archive(step_);
  if (guo_) archive(guo_state_);
  for (const auto& s : secondaries_) archive(s->filter), archive(s->member);
}

std::filesystem::path Chain::checkpoint_of(std::size_t index,
                                           const std::filesystem::path& file) const {
  std::string ending = ".";
  ending.append(std::to_string(index + 1)).append(".").append(secondaries_[index]->name());
  return std::filesystem::path(file) += ending;
}

void Chain::call_with_file(std::size_t index, int status, const std::filesystem::path& file) {
  Secondary& s = *secondaries_[index];
  s.call_with_file(array_, status, checkpoint_of(index, file),
                   s.guo() ? kPrivateGuoBlock.first : link_state_.log_start,
                   !s.guo() && link_.logging());
}

// Guo's libraries take -8 for a step and end the process at -9.
void Chain::checkpoint(const std::filesystem::path& file, SwapView /*host*/, Notice& notice) {
  for (std::size_t i = 0; i < secondaries_.size(); ++i) {
    Secondary& s = *secondaries_[i];
    if (s.guo() && !s.member) {
      notice.warn("%s does not know checkpoints: it will start anew after a restart",
                  s.label().c_str());
      continue;
    }
    call_with_file(i, LAC_STATUS_CHECKPOINT, file);
    if (s.fail() < 0) s.tell_failure(notice);
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
    if (s.guo() && !s.member) {
      notice.warn("%s does not know checkpoints: it starts anew", s.label().c_str());
      call(s, LAC_STATUS_FIRST);
    } else {
      call_with_file(i, LAC_STATUS_RESTART, file);
    }
    if (s.fail() < 0) return s.tell_failure(notice);
    s.started = true;
    s.member = view.integer(Rec::ChainMember, 0) == 1;
  }
  link_.hold_demands(array_, link_state_);
}

void Chain::store_or_restore(int status, SwapView /*host*/, Notice& notice) {
  for (const auto& s : secondaries_) {
    if (s->member) {
      call(*s, status);
      if (s->fail() < 0) s->tell_failure(notice);
    } else if (!store_reported_) {
      notice.warn("%s does not know statuses -11 and -10 (store, restore): it is left out",
                  s->label().c_str());
    }
  }
  store_reported_ = true;
}

}  // namespace lac
