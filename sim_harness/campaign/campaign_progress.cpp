// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/campaign_progress.hpp"

#include <ostream>
#include <utility>

namespace lac::sim {
namespace {

constexpr double kRedrawEvery_s = 1.0;
constexpr std::size_t kLinesInAll = 10;
constexpr double kLineNotBefore_s = 2.0;
constexpr std::size_t kMostFailuresShown = 20;

}  // namespace

CampaignProgress::CampaignProgress(std::string name, std::size_t cases, ProgressStyle style,
                                   std::ostream& out, Clock clock)
    : name_(std::move(name)),
      cases_(cases),
      style_(style),
      out_(out),
      clock_(std::move(clock)),
      start_s_(clock_()),
      shown_s_(start_s_) {}

CampaignProgress::~CampaignProgress() {
  end_line();
}

void CampaignProgress::end_line() {
  if (line_open_) out_ << '\n' << std::flush;
  line_open_ = false;
}

std::string CampaignProgress::line(double now_s) const {
  const std::size_t ended = done_ + failed_;
  std::string text = name_ + ": " + std::to_string(ended) + " of " + std::to_string(cases_) +
                     " cases, " + std::to_string(failed_) + " failed";
  if (ended == 0) return text;
  const double each_s = (now_s - start_s_) / static_cast<double>(ended);
  return text + ", " + duration_text(each_s * static_cast<double>(cases_ - ended)) + " left";
}

void CampaignProgress::show(bool wanted) {
  if (!wanted) return;
  shown_s_ = clock_();
  shown_cases_ = done_ + failed_;
  const std::string text = line(shown_s_);
  if (style_.terminal) {
    out_ << '\r' << text.substr(0, static_cast<std::size_t>(style_.columns - 1)) << "\033[K";
    line_open_ = true;
  } else {
    out_ << text << '\n';
  }
  out_ << std::flush;
}

void CampaignProgress::tick() {
  const double since_s = clock_() - shown_s_;
  const std::size_t ended = done_ + failed_ - shown_cases_;
  show(style_.terminal ? since_s >= kRedrawEvery_s
                       : since_s >= kLineNotBefore_s && ended * kLinesInAll >= cases_);
}

void CampaignProgress::case_done() {
  ++done_;
  style_.terminal ? show(true) : tick();
}

void CampaignProgress::case_failed(const std::string& name, const std::string& reason) {
  ++failed_;
  if (failed_ <= kMostFailuresShown) {
    if (style_.terminal) out_ << "\r\033[K";
    line_open_ = false;
    out_ << "failed: " << name << ": " << reason << '\n' << std::flush;
  }
  if (failed_ == kMostFailuresShown) out_ << "(later failures are counted only)\n";
  style_.terminal ? show(true) : tick();
}

}  // namespace lac::sim
