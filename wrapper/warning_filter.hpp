// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "core/hash.hpp"
#include "core/state_archive.hpp"

namespace lac {

/// Which warnings of one source reach the host. Hosts print every warning they get, in every
/// step, so:
///   - a text is shown once, and again only after a step without it;
///   - a source may show kBurst texts at once and then one every kSecondsPerText;
///   - what was not shown for the second reason is counted, for a word at the end of the run, and
///     shown late if it still stands then.
/// [real time]
class WarningFilter {
 public:
  static constexpr double kBurst = 5.0;
  static constexpr double kSecondsPerText = 10.0;

  /// A step with this warning; true if it is to be shown.
  bool admit(std::string_view text, double time_s) noexcept {
    const std::uint64_t hash = hash_of_text(text);
    if (standing_ && hash == shown_) return false;
    credit_ = std::min(kBurst, credit_ + (time_s - time_s_) / kSecondsPerText);
    time_s_ = time_s;
    if (credit_ < 1.0) {
      ++hidden_;
      return false;
    }
    credit_ -= 1.0;
    standing_ = true;
    shown_ = hash;
    return true;
  }

  /// A step without a warning.
  void quiet() noexcept { standing_ = false; }

  std::int64_t hidden() const { return hidden_; }

  void visit(StateArchive& a) { a(standing_), a(shown_), a(credit_), a(time_s_), a(hidden_); }

 private:
  bool standing_ = false;
  std::uint64_t shown_ = 0;
  double credit_ = kBurst;
  double time_s_ = 0.0;
  std::int64_t hidden_ = 0;
};

}  // namespace lac
