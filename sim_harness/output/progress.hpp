// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace lac::sim {

/// How progress is shown; progress_style_of_stderr() looks at the surroundings.
struct ProgressStyle {
  bool terminal = false;  // a bar that redraws itself; else plain lines now and then
  bool colour = false;
  int columns = 80;
};

/// A terminal if stderr is one and TERM is not "dumb"; colour unless NO_COLOR is set.
ProgressStyle progress_style_of_stderr();

/// "feedback-only  [=====>    ]  52 %  4 s left". On a terminal the line is redrawn at most ten
/// times a second; elsewhere a line is written every tenth of the way, but not sooner than two
/// seconds after the last one. update() is made to be called every step: it looks at the clock
/// only when the fraction has grown by a thousandth.
class Progress {
 public:
  using Clock = std::function<double()>;  // seconds, rising

  /// The stream must outlive this object.
  Progress(std::string label, ProgressStyle style, std::ostream& out, Clock clock);
  /// On stderr, as its surroundings ask for, by the steady clock.
  explicit Progress(std::string label);
  /// Given up half-way: leaves the bar's line, so that an error text starts on its own.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// fraction_done in 0 ... 1, not falling.
  void update(double fraction_done) {
    if (fraction_done >= next_look_) look(fraction_done);
  }

  /// The last word: "feedback-only: done in 4.2 s". A second call does nothing.
  void finish();

 private:
  void look(double fraction_done);
  void draw_bar(double fraction_done, double left_s);
  void write_line(double fraction_done, double left_s);

  std::string label_;
  ProgressStyle style_;
  std::ostream& out_;
  Clock clock_;
  double start_s_;
  double last_shown_s_;
  double last_line_fraction_ = 0.0;
  double next_look_ = 0.0;
  bool bar_open_ = false;
  bool finished_ = false;
};

/// "4 s", "3 min 20 s", "1 h 05 min".
std::string duration_text(double duration_s);

}  // namespace lac::sim
