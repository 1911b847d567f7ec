// SPDX-License-Identifier: Apache-2.0
#include "core/input_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "core/native_path.hpp"
#include "core/plain_number.hpp"
#include "core/suggest.hpp"

namespace lac {
namespace {

bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',';
}

/// Splits the part in front of `!`; quotes keep blanks and `!` together. `rest` is what follows
/// the `!`. Returns false if a quote is not closed.
bool split_values(std::string_view line, std::vector<std::string>& words, std::string_view& rest) {
  std::size_t i = 0;
  while (i < line.size()) {
    const char c = line[i];
    if (is_separator(c)) {
      ++i;
    } else if (c == '!') {
      rest = line.substr(i + 1);
      return true;
    } else if (c == '"' || c == '\'') {
      const std::size_t end = line.find(c, i + 1);
      if (end == std::string_view::npos) return false;
      words.emplace_back(line.substr(i + 1, end - i - 1));
      i = end + 1;
    } else {
      const std::size_t begin = i;
      while (i < line.size() && !is_separator(line[i]) && line[i] != '!') ++i;
      words.emplace_back(line.substr(begin, i - begin));
    }
  }
  rest = {};
  return true;
}

/// A word of the file as it can stand in a message: short, on one line.
std::string quotable(std::string_view word) {
  constexpr std::size_t kLongest = 60;
  std::string text(word.substr(0, kLongest));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return word.size() > kLongest ? text + "..." : text;
}

std::string_view first_word(std::string_view s) {
  const std::size_t begin = s.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return s.substr(begin, s.find_first_of(" \t", begin) - begin);
}

bool parse_number(std::string word, double& value) {
  for (char& c : word) {
    if (c == 'd' || c == 'D') c = 'e';  // Fortran exponents
  }
  const std::optional<double> number = plain_number(without_plus(word));
  value = number.value_or(value);
  return number && std::isfinite(value);
}

}  // namespace

std::string shortest(double v) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, v, std::chars_format::general, 10);
  return {text, end.ptr};
}

std::string Range::text() const {
  const bool low = std::isfinite(min), high = std::isfinite(max);
  if (low && high && min_itself_allowed) {
    return "a number from " + shortest(min) + " to " + shortest(max);
  }
  if (low && high) return "a number above " + shortest(min) + " up to " + shortest(max);
  if (low && min_itself_allowed) return "a number of at least " + shortest(min);
  if (low) return "a number above " + shortest(min);
  if (high) return "a number of at most " + shortest(max);
  return "a number";
}

InputFile InputFile::load(const std::filesystem::path& file) {
  std::error_code ec;
  if (std::filesystem::is_directory(file, ec)) {
    throw Error(file.string() + ": is a folder, expected an input file");
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    const bool exists = std::filesystem::exists(file, ec);
    throw Error(file.string() + ": cannot open the input file: " +
                (exists ? "no permission to read it" : "no such file") + " (working folder " +
                std::filesystem::current_path(ec).string() + ")");
  }
  std::ostringstream text;
  text << in.rdbuf();
  return parse(text.str(), file);
}

InputFile InputFile::parse(std::string_view text, std::filesystem::path file) {
  InputFile result;
  result.file_ = std::move(file);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte-order mark
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    throw Error(result.file_.string() + ": byte " + std::to_string(zero + 1) +
                " is zero: found a binary or UTF-16 file, expected plain text (UTF-8)");
  }
  int line = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const bool windows = text.substr(end).starts_with("\r\n");
    result.parse_line(text.substr(0, end), ++line);
    text.remove_prefix(std::min(end + (windows ? 2 : 1), text.size()));
  }
  return result;
}

void InputFile::parse_line(std::string_view line, int number) {
  const std::string_view start = first_word(line);
  if (start.empty() || start.front() == '!' || start.front() == '#') return;
  Entry entry;
  entry.line = number;
  std::string_view rest;
  const auto here = [&] { return file_.string() + ":" + std::to_string(number) + ": "; };
  if (!split_values(line, entry.values, rest)) throw Error(here() + "a quote is not closed");
  entry.key = std::string(first_word(rest));
  if (entry.key.empty()) {
    throw Error(here() + "found '" + quotable(line) +
                "', expected 'value ! Key - description' (a comment line begins with !)");
  }
  if (entry.values.empty()) {
    throw Error(here() + quotable(entry.key) + ": no value in front of the '!'");
  }
  for (const Entry& other : entries_) {
    if (equal_ignoring_case(other.key, entry.key)) {
      throw Error(here() + quotable(entry.key) + ": stands twice, first in line " +
                  std::to_string(other.line));
    }
  }
  entries_.push_back(std::move(entry));
}

InputFile::Entry* InputFile::find(const std::string& key) {
  if (std::ranges::find(asked_, key) == asked_.end()) asked_.push_back(key);
  for (Entry& e : entries_) {
    if (equal_ignoring_case(e.key, key)) {
      e.used = true;
      return &e;
    }
  }
  return nullptr;
}

InputFile::Entry& InputFile::need(const std::string& key) {
  if (Entry* e = find(key)) return *e;
  std::vector<std::string> unused;
  for (const Entry& e : entries_) {
    if (!e.used) unused.push_back(e.key);
  }
  const std::string similar = closest(key, unused);
  throw Error(file_.string() + ": " + key + ": missing, expected a line 'value ! " + key +
              " - ...'" + (similar.empty() ? "" : " (is '" + similar + "' meant to be it?)"));
}

std::string InputFile::where(const std::string& key) const {
  for (const Entry& e : entries_) {
    if (equal_ignoring_case(e.key, key)) {
      return file_.string() + ":" + std::to_string(e.line) + ": " + quotable(e.key);
    }
  }
  return file_.string() + ": " + key;
}

void InputFile::fail_at(const Entry& entry, const std::string& problem) const {
  fail(entry.key, problem);
}

void InputFile::fail(const std::string& key, const std::string& problem) const {
  throw Error(where(key) + ": " + problem);
}

const std::string& InputFile::single(const Entry& entry) const {
  if (entry.values.size() != 1) {
    fail_at(entry, "found " + std::to_string(entry.values.size()) + " values, expected one");
  }
  return entry.values.front();
}

double InputFile::to_number(const Entry& entry, const std::string& word, Range range) const {
  double value = 0.0;
  if (!parse_number(word, value)) {
    fail_at(entry, "found '" + quotable(word) + "', expected " + range.text());
  }
  if (!range.contains(value)) {
    fail_at(entry, "found " + quotable(word) + ", expected " + range.text());
  }
  return value;
}

double InputFile::number(const std::string& key, Range range) {
  const Entry& e = need(key);
  return to_number(e, single(e), range);
}

int InputFile::integer(const std::string& key, Range range) {
  const Entry& e = need(key);
  const double value = to_number(e, single(e), range);
  if (value != std::round(value) || std::abs(value) > 2.0e9) {
    fail_at(e, "found " + quotable(single(e)) + ", expected a whole number");
  }
  return static_cast<int>(value);
}

bool InputFile::flag(const std::string& key) {
  const Entry& e = need(key);
  const std::string& word = single(e);
  for (const char* yes : {"true", "t", ".true.", "1", "yes", "on"}) {
    if (equal_ignoring_case(word, yes)) return true;
  }
  for (const char* no : {"false", "f", ".false.", "0", "no", "off"}) {
    if (equal_ignoring_case(word, no)) return false;
  }
  fail_at(e, "found '" + quotable(word) + "', expected true or false");
}

std::string InputFile::text(const std::string& key) {
  return single(need(key));
}

std::vector<double> InputFile::numbers(const std::string& key, Range range) {
  const Entry& e = need(key);
  std::vector<double> result;
  for (const std::string& word : e.values) result.push_back(to_number(e, word, range));
  return result;
}

std::vector<double> InputFile::numbers(const std::string& key, std::size_t count,
                                       const std::string& counted_by, Range range) {
  std::vector<double> result = numbers(key, range);
  if (result.size() != count) {
    fail_at(need(key), "found " + std::to_string(result.size()) + " values, expected " +
                           std::to_string(count) + " as " + counted_by + " says");
  }
  return result;
}

std::vector<std::string> InputFile::texts(const std::string& key) {
  return need(key).values;
}

int InputFile::choice(const std::string& key, const std::vector<std::string>& choices) {
  const Entry& e = need(key);
  const std::string& word = single(e);
  std::string all;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (equal_ignoring_case(word, choices[i])) return static_cast<int>(i);
    all += (i == 0 ? "" : ", ") + choices[i];
  }
  fail_at(e,
          "found '" + quotable(word) + "', expected one of " + all + did_you_mean(word, choices));
}

double InputFile::number(const std::string& key, double fallback, Range range) {
  return has(key) ? number(key, range) : fallback;
}
int InputFile::integer(const std::string& key, int fallback, Range range) {
  return has(key) ? integer(key, range) : fallback;
}
bool InputFile::flag(const std::string& key, bool fallback) {
  return has(key) ? flag(key) : fallback;
}
std::string InputFile::text(const std::string& key, const std::string& fallback) {
  return has(key) ? text(key) : fallback;
}
int InputFile::choice(const std::string& key, int fallback,
                      const std::vector<std::string>& choices) {
  return has(key) ? choice(key, choices) : fallback;
}

bool InputFile::has(const std::string& key) {
  return find(key) != nullptr;
}

void InputFile::finish() const {
  for (const Entry& e : entries_) {
    if (!e.used) fail_at(e, "unknown key" + did_you_mean(e.key, asked_));
  }
}

std::filesystem::path InputFile::resolve(const std::string& path_in_file) const {
  const std::filesystem::path p = path_from_bytes(path_in_file);
  return p.is_absolute() ? p : file_.parent_path() / p;
}

}  // namespace lac
