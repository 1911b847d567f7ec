// SPDX-License-Identifier: Apache-2.0
// Input files of the Fortran baseline chain (F. Guo, D. Schlipf) and of its successor (IEA Wind
// Task 52), which libraries of this project read unchanged. docs/hosts/guo.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/input_file.hpp"

namespace lac {

/// Keys by which the files of one kind of library are told apart. A key counts where it stands as
/// a key, not in a comment line; upper and lower case alike.
struct GuoMarks {
  std::string kind;                 // "LDP", for messages
  std::vector<std::string> theirs;  // only Guo's files have them; the first names the form
  std::vector<std::string> ours;    // only files of our own form have them
  std::vector<std::string> shared;  // both have them
};

const GuoMarks& guo_ldp_marks();
const GuoMarks& guo_ffp_marks();
const GuoMarks& guo_wrapper_marks();

/// One of their forms: what stands in which line.
struct GuoForm {
  std::string name;                 // "LDP_v1", for messages
  std::vector<std::string> lines;   // keys from the fourth line on; empty: a line that is skipped
  std::vector<std::string> extras;  // keys in our own grammar that may stand behind them, where
                                    // their parser does not look
};

/// A file in their grammar: three header lines, then one `value(s) ! Key - text` a line, in fixed
/// order without blank or comment lines between. Words end at space, tab , ! ; ' and ", so that
/// `!` is only a separator. The key is compared in its first 20 characters, case ignored. Lines
/// behind the last key are not looked at, but for `extras`.
class GuoInputFile {
 public:
  struct Line {
    int number = 0;  // counted from 1
    std::string key;
    std::vector<std::string> values;
  };
  /// A line in our own grammar.
  struct OurLine {
    int number = 0;
    std::string text;
  };

  /// A file that cannot be opened has no lines: InputFile::load then says why.
  static GuoInputFile load(const std::filesystem::path& file);
  static GuoInputFile parse(std::string_view text, std::filesystem::path file);

  /// Number of the first line with this key, counted from 1, or 0.
  int line_of(std::string_view key) const;

  /// Is it one of theirs? Throws lac::Error that names both forms if it has keys of both, or none
  /// but shared ones.
  bool is_theirs(const GuoMarks& marks) const;

  /// The lines of a form. Throws lac::Error with file and line where one does not fit.
  std::vector<Line> sequence(const GuoForm& form) const;

  /// The same as a file with keys, in which each line keeps its number: all checks of values and
  /// their messages are those of InputFile. Includes the extras.
  InputFile read(const GuoForm& form) const;

  /// The lines of the extras, as they stand.
  std::vector<OurLine> extras(const GuoForm& form) const;

  /// A file of our own form with these lines, which rise in number; all others are blank.
  InputFile as_ours(const std::vector<OurLine>& lines) const;

  bool empty() const { return lines_.empty(); }
  const std::filesystem::path& path() const { return file_; }

 private:
  [[noreturn]] void fail(int line, const std::string& problem, const GuoForm& form) const;

  std::filesystem::path file_;
  std::vector<std::string> lines_;
};

}  // namespace lac
