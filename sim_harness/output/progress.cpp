// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <utility>

namespace lac::sim {
namespace {

constexpr double kLookEvery = 0.001;  // of the way
constexpr double kRedrawEvery_s = 0.1;
constexpr double kLineEvery = 0.1;  // of the way
constexpr double kLineNotBefore_s = 2.0;
constexpr int kBarMin = 10;
constexpr int kBarMax = 40;

double steady_seconds() {
  using std::chrono::duration;
  return duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

std::string percent_text(double fraction) {
  char text[16];
  std::snprintf(text, sizeof text, "%3d %%", static_cast<int>(100.0 * fraction));
  return text;
}

}  // namespace

ProgressStyle progress_style_of_stderr() {
  ProgressStyle style;
  const char* term = std::getenv("TERM");
  style.terminal = ::isatty(STDERR_FILENO) == 1 && (!term || std::string_view(term) != "dumb");
  style.colour = style.terminal && !is_set("NO_COLOR");
  winsize size{};
  if (style.terminal && ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    style.columns = size.ws_col;
  }
  return style;
}

Progress::Progress(std::string label, ProgressStyle style, std::ostream& out, Clock clock)
    : label_(std::move(label)),
      style_(style),
      out_(out),
      clock_(std::move(clock)),
      start_s_(clock_()),
      last_shown_s_(start_s_) {}

Progress::Progress(std::string label)
    : Progress(std::move(label), progress_style_of_stderr(), std::cerr, steady_seconds) {}

Progress::~Progress() {
  if (bar_open_ && !finished_) out_ << '\n' << std::flush;
}

void Progress::look(double fraction_done) {
  const double fraction = std::clamp(fraction_done, 0.0, 1.0);
  next_look_ = fraction + kLookEvery;
  const double now_s = clock_();
  const double since_s = now_s - last_shown_s_;
  const double left_s = fraction > 0.0 ? (now_s - start_s_) * (1.0 - fraction) / fraction : -1.0;
  const bool due =
      style_.terminal ? since_s >= kRedrawEvery_s
                      : since_s >= kLineNotBefore_s && fraction >= last_line_fraction_ + kLineEvery;
  if (!due || finished_) return;
  last_shown_s_ = now_s;
  last_line_fraction_ = fraction;
  style_.terminal ? draw_bar(fraction, left_s) : write_line(fraction, left_s);
}

void Progress::draw_bar(double fraction, double left_s) {
  const std::string tail = "  " + percent_text(fraction) + "  " + duration_text(left_s) + " left";
  const int room = style_.columns - static_cast<int>(label_.size() + tail.size()) - 5;
  const int width = std::min(room, kBarMax);
  bar_open_ = true;
  out_ << '\r' << label_;
  if (width >= kBarMin) {
    const int full = static_cast<int>(fraction * width);
    out_ << "  [" << (style_.colour ? "\033[36m" : "")
         << std::string(static_cast<std::size_t>(full), '=') << (full < width ? ">" : "")
         << (style_.colour ? "\033[0m" : "")
         << std::string(static_cast<std::size_t>(std::max(0, width - full - 1)), ' ') << ']';
  }
  out_ << tail << "\033[K" << std::flush;
}

void Progress::write_line(double fraction, double left_s) {
  out_ << label_ << ": " << static_cast<int>(100.0 * fraction) << " % done, "
       << duration_text(left_s) << " left\n"
       << std::flush;
}

void Progress::finish() {
  if (finished_) return;
  finished_ = true;
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.1f s", clock_() - start_s_);
  out_ << (style_.terminal ? "\r" : "") << label_ << ": done in " << seconds
       << (style_.terminal ? "\033[K\n" : "\n") << std::flush;
}

std::string duration_text(double duration_s) {
  const long seconds = std::lround(std::max(duration_s, 0.0));
  char text[48];
  if (seconds < 60) {
    std::snprintf(text, sizeof text, "%ld s", seconds);
  } else if (seconds < 3600) {
    std::snprintf(text, sizeof text, "%ld min %02ld s", seconds / 60, seconds % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld h %02ld min", seconds / 3600, seconds / 60 % 60);
  }
  return text;
}

}  // namespace lac::sim
