// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/wind/bladed_summary.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "core/part_file.hpp"

namespace lac::sim {
namespace {

/// The lines of a summary in upper case, one after the other.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& file) : file_(file), stream_(file) {
    if (!stream_) {
      throw Error(file.string() +
                  ": cannot be opened for reading; a Bladed .wnd file needs its summary beside it");
    }
  }

  bool next() {
    if (!std::getline(stream_, line_)) return false;
    ++number_;
    std::transform(line_.begin(), line_.end(), line_.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return true;
  }
  bool has(std::string_view phrase) const { return line_.find(phrase) != std::string::npos; }
  std::string_view text() const { return line_; }

  double number(std::string_view from, const char* name, double least, double most) const {
    const std::size_t begin = std::min(from.find_first_not_of(" \t="), from.size());
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(from.data() + begin, from.data() + from.size(), value);
    if (error != std::errc() || !(value >= least && value <= most)) {
      char range[80];
      std::snprintf(range, sizeof range, "a number from %g to %g", least, most);
      fail(name, "found '" + std::string(from) + "', expected " + range);
    }
    return value;
  }
  double number_behind_equals(const char* name, double least, double most) const {
    const std::size_t equals = line_.find('=');
    if (equals == std::string::npos) fail(name, "found no '=', expected '= number'");
    return number(std::string_view(line_).substr(equals + 1), name, least, most);
  }

  [[noreturn]] void fail(const std::string& name, const std::string& problem) const {
    throw Error(file_.string() + ":" + std::to_string(number_) + ": " + name + ": " + problem);
  }

 private:
  std::filesystem::path file_;
  std::ifstream stream_;
  std::string line_;
  int number_ = 0;
};

bool is_true(const Lines& in) {
  const std::string_view text = in.text();
  const std::size_t begin = text.find_first_not_of(" \t.");
  const char letter = begin == std::string_view::npos ? ' ' : text[begin];
  if (letter == 'T' || letter == 'Y') return true;
  if (letter != 'F' && letter != 'N') in.fail("clockwise", "expected T or F before it");
  return false;
}

void read_hub_height(Lines& in, BladedSummary& summary) {
  while (in.next()) {
    if (in.has("CLOCKWISE")) summary.clockwise = is_true(in);
    if (!in.has("HUB HEIGHT") && !in.has("ZHUB")) continue;
    summary.hub_height_m = in.number(in.text(), "hub height [m]", 1e-3, 1e4);
    return;
  }
  in.fail("hub height", "found the end of the file, expected '<number> ... hub height'");
}

void read_scaling(Lines& in, BladedSummary& summary) {
  while (in.next()) {
    if (!in.has("UBAR")) continue;
    summary.mean_speed_mps = in.number_behind_equals("UBar [m/s]", 1e-3, 1e3);
    for (double& intensity : summary.intensity) {
      if (!in.next()) in.fail("TI", "found the end of the file, expected '= <number> %'");
      intensity = 0.01 * in.number_behind_equals("TI [%]", 0.0, 1e6);
    }
    return;
  }
  in.fail("UBar", "found the end of the file, expected 'UBar = <number>'");
}

}  // namespace

BladedSummary read_bladed_summary(const std::filesystem::path& file) {
  Lines in(file);
  BladedSummary summary;
  read_hub_height(in, summary);
  read_scaling(in, summary);
  while (in.next()) {
    if (in.has("HEIGHT OFFSET"))
      summary.height_offset_m = in.number_behind_equals("height offset [m]", -1e4, 1e4);
    if (in.has("PERIODIC")) summary.periodic = true;
    if (in.has("BLADED LEFT-HAND RULE")) summary.left_handed = true;
  }
  return summary;
}

void write_bladed_summary(const std::filesystem::path& file, const BladedSummary& s) {
  char text[1024];
  const int size = std::snprintf(
      text, sizeof text,
      "\nTurbSim-style summary of a Bladed-style wind file, written by LAC Chain\n\n"
      "%10s  Clockwise rotation when looking downwind?\n%10.4f  Hub height [m]\n\n"
      "BLADED-style binary scaling parameters:\n\n  UBar  = %.8f m/s\n  TI(u) = %.8f %%\n"
      "  TI(v) = %.8f %%\n  TI(w) = %.8f %%\n\n  Height offset = %.6f m\n\n%s%s",
      s.clockwise ? "T" : "F", s.hub_height_m, s.mean_speed_mps, 100.0 * s.intensity[0],
      100.0 * s.intensity[1], 100.0 * s.intensity[2], s.height_offset_m,
      s.periodic ? "Creating a PERIODIC output file.\n" : "",
      s.left_handed ? "Creating a BLADED LEFT-HAND RULE output file.\n" : "");
  PartFile out(file);
  out.write(text, static_cast<std::size_t>(size));
  out.commit();
}

}  // namespace lac::sim
