// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>

#include "sim_harness/output/progress.hpp"

namespace lac::sim {

/// "speeds: 37 of 252 cases, 1 failed, 2 min 03 s left". On a terminal one line that redraws
/// itself; elsewhere a line every tenth of the way, but not sooner than two seconds after the last
/// one.
class CampaignProgress {
 public:
  using Clock = std::function<double()>;  // seconds, rising

  /// `cases`: that are to be flown now. The stream must outlive this object.
  CampaignProgress(std::string name, std::size_t cases, ProgressStyle style, std::ostream& out,
                   Clock clock);
  /// Leaves the line, so that what follows starts on its own.
  ~CampaignProgress();
  CampaignProgress(const CampaignProgress&) = delete;
  CampaignProgress& operator=(const CampaignProgress&) = delete;

  void case_done();
  /// Says which one and why, on a line of its own; of many failures the first few.
  void case_failed(const std::string& name, const std::string& reason);
  /// To be called now and then: redraws on a terminal.
  void tick();

 private:
  std::string line(double now_s) const;
  void show(bool wanted);
  void end_line();

  std::string name_;
  std::size_t cases_;
  ProgressStyle style_;
  std::ostream& out_;
  Clock clock_;
  double start_s_;
  double shown_s_;
  std::size_t shown_cases_ = 0;
  std::size_t done_ = 0;
  std::size_t failed_ = 0;
  bool line_open_ = false;
};

}  // namespace lac::sim
