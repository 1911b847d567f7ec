// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace lac::sim {

class StudyNode;

/// One key of the case and its value, as `lac run --set key=value` takes them.
struct StudySetting {
  std::string key;
  std::string value;  // YAML on one line
  int line = 0;       // of the study file, from 1

  std::string text() const { return key + "=" + value; }
};

/// One of the things a range may be: its name and the keys it sets.
struct StudyChoice {
  std::string name;  // letters, digits, '-', '_', '.', '+'
  std::vector<StudySetting> settings;
};

struct StudyRange {
  std::string name;    // a key of the case, or a word of its own if choices are named
  bool named = false;  // the choices have names of their own
  int line = 0;
  std::vector<StudyChoice> choices;  // at least one
};

/// Cases that have one of these choices in every range named here: what is left out.
struct StudyExclusion {
  struct Part {
    std::size_t range;
    std::vector<std::size_t> choices;
  };
  std::vector<Part> parts;

  /// `choices`: one per range of the study.
  bool matches(const std::vector<std::size_t>& choices) const;
};

/// A study file: one case and what varies in it.
struct Study {
  std::filesystem::path file;
  std::string name;  // of the file
  std::filesystem::path base_case;
  std::filesystem::path folder;        // of the results
  double time_limit_s = 0.0;           // of the flights of one case; 0: none
  std::vector<StudySetting> settings;  // of every case
  std::vector<StudyRange> ranges;
  std::vector<StudyExclusion> exclusions;
};

/// Reads a study file; the keys are listed in docs/campaigns.md. Throws lac::Error: file, line,
/// key, found, expected, hint. Whether the case knows the keys is not looked at here.
Study load_study(const std::filesystem::path& file);

/// A range, and a selection of cases, in other files that build on a study. Throw lac::Error alike.
StudyRange read_study_range(const std::string& name, const StudyNode& node);
StudyExclusion read_study_selection(const Study& study, const StudyNode& node);

}  // namespace lac::sim
