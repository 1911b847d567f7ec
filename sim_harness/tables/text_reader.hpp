// SPDX-License-Identifier: Apache-2.0
// Time series in text files: OpenFAST's .out and comma-separated values.
#pragma once

#include <filesystem>

#include "sim_harness/output/recording.hpp"

namespace lac::sim {

enum class MissingRows {
  kRefused,     // an error with file and line
  kNotNumbers,  // rows of NaN in their place, as of a measurement that paused
};

/// OpenFAST's text output: lines of any text, a line of names that begins with Time, a line of
/// units in brackets, rows of as many numbers in blanks or tabs. Empty lines are passed over, and
/// so is text behind one, which ends the rows. A channel that stands twice is equal there, and the
/// first is found. Throws lac::Error with file, line, column, found and expected.
Recording read_out(const std::filesystem::path& file, MissingRows missing = MissingRows::kRefused);

/// Comma-separated values: a line of names ("Time [s]" or "Time (s)", units optional), possibly a
/// line of units, rows of numbers. The first column is the time in seconds, its name begins with
/// "time" in any case, or is "t". The separator is a semicolon, tab or comma, the first of these in
/// the line of names; with a semicolon a comma is a decimal point. Lines that begin with # and
/// empty lines are passed over, an empty cell is NaN. Throws lac::Error as above, or for a name
/// that stands twice.
Recording read_csv(const std::filesystem::path& file, MissingRows missing = MissingRows::kRefused);

}  // namespace lac::sim
