// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/swap_view.hpp"
#include "ffp/ffp.hpp"

namespace lac {

/// The Feedforward* records of the chain block.
inline void write_feedforward(const Ffp::Outputs& out, SwapView& swap) {
  swap.set(Rec::FeedforwardPitchRate, out.rate_radps);
  swap.set(Rec::FeedforwardPitch, out.pitch_rad);
  swap.set(Rec::FeedforwardActive, out.active);
  swap.set(Rec::FeedforwardReason, static_cast<int>(out.reason));
  swap.set(Rec::RewsFiltered, out.filtered_mps);
  swap.set(Rec::RewsBuffered, out.buffered_mps);
  swap.set(Rec::FeedforwardBufferTime, out.buffer_time_s);
  swap.set(Rec::FeedforwardCutOff, out.cutoff_hz);
  swap.set(Rec::FeedforwardLeadNeeded, out.lead_needed_s);
  swap.set(Rec::FeedforwardAuthority, out.active * out.allowed);
}

}  // namespace lac
