// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace lac {

/// Ten significant digits at most, for messages: 0.0125, 1e-09.
std::string shortest(double v);

/// What a number must satisfy; the text stands in the error message.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_itself_allowed = true;

  static constexpr Range any() { return {}; }
  static constexpr Range positive() {
    return {0.0, std::numeric_limits<double>::infinity(), false};
  }
  static constexpr Range not_negative() { return {0.0}; }
  static constexpr Range between(double lo, double hi) { return {lo, hi}; }

  bool contains(double v) const { return (min_itself_allowed ? v >= min : v > min) && v <= max; }
  std::string text() const;
};

/// Controller input file in the field's form, one line per key:
///
///   value [value ...]   ! Key - description [unit]
///
/// Keys in any order, upper and lower case alike; lines that begin with `!` or `#`, and blank
/// lines, are comments. Strings may be quoted ("a b" or 'a b'). Separators are blanks, tabs and
/// commas. 20.000 is an integer, 1.5D-3 a number, true/false/1/0 a flag. Line ends of any system
/// and a byte-order mark pass; a file with zero bytes (binary, UTF-16) does not.
///
/// Every reading function marks its key as known; finish() refuses the ones nobody asked for.
/// All errors are lac::Error: "<file>:<line>: <key>: found ..., expected ...<hint>".
class InputFile {
 public:
  static InputFile load(const std::filesystem::path& file);
  static InputFile parse(std::string_view text, std::filesystem::path file);

  /// A missing key is an error here ...
  double number(const std::string& key, Range range = Range::any());
  int integer(const std::string& key, Range range = Range::any());
  bool flag(const std::string& key);
  std::string text(const std::string& key);
  std::vector<double> numbers(const std::string& key, Range range = Range::any());
  std::vector<std::string> texts(const std::string& key);
  /// Exactly one of the choices, case ignored; gives its position.
  int choice(const std::string& key, const std::vector<std::string>& choices);

  /// ... and means the default here.
  double number(const std::string& key, double fallback, Range range);
  int integer(const std::string& key, int fallback, Range range);
  bool flag(const std::string& key, bool fallback);
  std::string text(const std::string& key, const std::string& fallback);
  int choice(const std::string& key, int fallback, const std::vector<std::string>& choices);

  /// A row that must have as many entries as another key asks for.
  std::vector<double> numbers(const std::string& key, std::size_t count,
                              const std::string& counted_by, Range range = Range::any());

  bool has(const std::string& key);
  /// Refuses keys that nobody asked for. Call after the last reading function.
  void finish() const;
  /// "<file>:<line>: <key>", what errors begin with; without the line if the key is missing.
  std::string where(const std::string& key) const;
  /// For checks between keys: throws with file, line and key in front.
  [[noreturn]] void fail(const std::string& key, const std::string& problem) const;

  const std::filesystem::path& path() const { return file_; }
  /// A path written in this file: relative ones count from this file's folder.
  std::filesystem::path resolve(const std::string& path_in_file) const;

 private:
  struct Entry {
    std::string key;
    std::vector<std::string> values;
    int line = 0;
    bool used = false;
  };

  void parse_line(std::string_view line, int number);
  Entry* find(const std::string& key);
  Entry& need(const std::string& key);
  const std::string& single(const Entry& entry) const;
  double to_number(const Entry& entry, const std::string& word, Range range) const;
  [[noreturn]] void fail_at(const Entry& entry, const std::string& problem) const;

  std::filesystem::path file_;
  std::vector<Entry> entries_;
  std::vector<std::string> asked_;
};

}  // namespace lac
