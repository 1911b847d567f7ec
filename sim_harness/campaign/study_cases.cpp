// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/study_cases.hpp"

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "sim_harness/run/case_file.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostCases = 100000;
constexpr char kPlainCharacters[] =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.,/=+:@%";

[[noreturn]] void fail(const Study& study, int line, const std::string& key,
                       const std::string& problem) {
  throw Error(study.file.string() + ":" + std::to_string(line) + ": " + key + ": " + problem);
}

/// Is `upper` the key itself, or a map that holds it?
bool holds(const std::string& upper, const std::string& key) {
  return key == upper || key.starts_with(upper + ".");
}

/// A later setting must not wipe out what an earlier one has set.
class KeysSet {
 public:
  explicit KeysSet(const Study& study) : study_(study) {}

  void add(const std::vector<StudySetting>& together, const std::string& where) {
    for (const StudySetting& s : together) {
      if (holds(s.key, "outputs.folder"))
        fail(study_, s.line, where + s.key,
             "a campaign gives each case a folder of its own; found " + s.value);
      const auto earlier = std::ranges::find_if(
          earlier_, [&](const StudySetting& e) { return holds(s.key, e.key); });
      if (earlier != earlier_.end())
        fail(study_, s.line, where + s.key,
             "would replace " + earlier->key + ", which line " + std::to_string(earlier->line) +
                 " sets; expected each key in one place");
    }
  }
  void keep(const std::vector<StudySetting>& settings) {
    earlier_.insert(earlier_.end(), settings.begin(), settings.end());
  }

 private:
  const Study& study_;
  std::vector<StudySetting> earlier_;
};

void check_keys(const Study& study) {
  KeysSet keys(study);
  keys.add(study.settings, "set.");
  keys.keep(study.settings);
  for (const StudyRange& range : study.ranges) {
    const std::string where = "ranges." + (range.named ? range.name + "." : "");
    for (const StudyChoice& choice : range.choices) keys.add(choice.settings, where);
    for (const StudyChoice& choice : range.choices) keys.keep(choice.settings);
  }
}

std::string name_part(const StudyRange& range, const StudyChoice& choice) {
  if (range.named) return choice.name;
  return range.name.substr(range.name.rfind('.') + 1) + "-" + choice.name;
}

StudyCase make_case(const Study& study, const std::vector<std::size_t>& choices) {
  StudyCase c;
  c.choices = choices;
  for (const StudySetting& s : study.settings) c.overrides.push_back(s.text());
  for (std::size_t r = 0; r < choices.size(); ++r) {
    const StudyChoice& choice = study.ranges[r].choices[choices[r]];
    if (r > 0) c.name += '_';
    c.name += name_part(study.ranges[r], choice);
    for (const StudySetting& s : choice.settings) c.overrides.push_back(s.text());
  }
  c.folder = study.folder / "cases" / c.name;
  return c;
}

bool is_excluded(const Study& study, const std::vector<std::size_t>& choices) {
  return std::ranges::any_of(study.exclusions,
                             [&](const StudyExclusion& e) { return e.matches(choices); });
}

/// Counts on to the next combination, the last range fastest; false after the last one.
bool count_on(const Study& study, std::vector<std::size_t>& choices) {
  for (std::size_t r = choices.size(); r-- > 0;) {
    if (++choices[r] < study.ranges[r].choices.size()) return true;
    choices[r] = 0;
  }
  return false;
}

std::size_t combinations(const Study& study) {
  std::size_t count = 1;
  for (const StudyRange& range : study.ranges) {
    count *= range.choices.size();
    if (count > kMostCases)
      throw Error(study.file.string() + ": ranges: found more than " + std::to_string(kMostCases) +
                  " cases, expected fewer");
  }
  return count;
}

/// The setting of the study that an error of a case speaks of, or null.
const StudySetting* blamed(const Study& study, const StudyCase& c, const std::string& text) {
  const auto in = [&](const std::vector<StudySetting>& settings) -> const StudySetting* {
    const auto found = std::ranges::find_if(settings, [&](const StudySetting& s) {
      return text.starts_with("--set " + s.text() + ": ");
    });
    return found == settings.end() ? nullptr : &*found;
  };
  for (std::size_t r = 0; r < c.choices.size(); ++r)
    if (const StudySetting* s = in(study.ranges[r].choices[c.choices[r]].settings)) return s;
  return in(study.settings);
}

/// The overrides that the wind comes from; of evolving wind only what the lidar needs is kept.
std::string wind_settings(const StudyCase& c, bool depends_on_lidar) {
  std::string all;
  for (const std::string& o : c.overrides) {
    const std::string key = o.substr(0, o.find('='));
    const bool of_lidar = holds("lidar", key) && !holds("lidar.fault", key);
    const bool counts = holds("wind", key) || holds("seed", key) || holds("turbine", key) ||
                        key == "time" || key == "time.duration_s" || (of_lidar && depends_on_lidar);
    if (counts) all += o + '\n';
  }
  return all;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && word.find_first_not_of(kPlainCharacters) == std::string::npos) return word;
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? "'\\''" : std::string(1, letter);
  return text + "'";
}

}  // namespace

std::vector<StudyCase> study_cases(const Study& study) {
  check_keys(study);
  combinations(study);
  std::vector<StudyCase> cases;
  std::set<std::string> names;
  std::vector<std::size_t> choices(study.ranges.size(), 0);
  do {
    if (is_excluded(study, choices)) continue;
    cases.push_back(make_case(study, choices));
    if (!names.insert(cases.back().name).second)
      throw Error(study.file.string() + ": two cases are named '" + cases.back().name +
                  "', expected names that differ");
  } while (count_on(study, choices));
  if (cases.empty())
    throw Error(study.file.string() + ": exclude: leaves out every case, expected some to fly");
  return cases;
}

void check_cases(const Study& study, std::vector<StudyCase>& cases) {
  for (StudyCase& c : cases) {
    try {
      c.wind = wind_settings(c, evolves(load_case(study.base_case, c.overrides).wind));
    } catch (const Error& e) {
      const std::string text = e.what();
      if (const StudySetting* s = blamed(study, c, text)) {
        const std::size_t after = ("--set " + s->text() + ": ").size();
        throw Error(study.file.string() + ":" + std::to_string(s->line) + ": " +
                    text.substr(after) + " (case " + c.name + ")");
      }
      throw Error(text + " (case " + c.name + " of " + study.file.string() + ")");
    }
  }
}

std::string command_line(const Study& study, const StudyCase& c, const fs::path& program) {
  std::string line = quoted(program.string()) + " run " +
                     quoted(fs::absolute(study.base_case).lexically_normal().string());
  for (const std::string& o : c.overrides) line += " --set " + quoted(o);
  return line + " --output " + quoted(fs::absolute(c.folder).lexically_normal().string()) +
         " --mark";
}

}  // namespace lac::sim
