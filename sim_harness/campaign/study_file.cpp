// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/study_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/plain_number.hpp"
#include "core/suggest.hpp"
#include "sim_harness/campaign/study_node.hpp"
#include "sim_harness/config/yaml_reader.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr char kNameCharacters[] =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.+";
constexpr char kRangeForms[] =
    "a list of values, {from: , to: , step: }, or names with the keys that each sets";
constexpr double kMostValues = 100000.0;

/// Two ways to write one number count as the same.
bool same_name(const std::string& a, const std::string& b) {
  const std::optional<double> x = plain_number(a);
  const std::optional<double> y = plain_number(b);
  return a == b || (x && y && *x == *y);
}

StudySetting setting(const std::string& key, const StudyNode& value) {
  return {key, value.flow_text(), value.line()};
}

void check_name(const StudyRange& range, const std::string& name, const StudyNode& at) {
  const bool twice = std::ranges::any_of(
      range.choices, [&](const StudyChoice& c) { return same_name(c.name, name); });
  if (twice) at.fail("found '" + name + "' twice, expected different ones");
  if (name.empty() || name.find_first_not_of(kNameCharacters) != std::string::npos) {
    at.fail("found '" + name +
            "', expected letters, digits and '-', '_', '.', '+' alone: folders bear this name; "
            "other values need a name: {name: {" +
            range.name + ": value}}");
  }
}

void read_list(const StudyNode& node, StudyRange& range) {
  for (const StudyNode& item : node.items("a list of values")) {
    if (!item.is_scalar())
      item.fail("found a list or a map, expected single values; give the others names: {name: {" +
                range.name + ": value}}");
    check_name(range, item.yaml().Scalar(), item);
    range.choices.push_back({item.yaml().Scalar(), {setting(range.name, item)}});
  }
}

std::string number_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g", value);
  return text.data();
}

void read_interval(const StudyNode& node, StudyRange& range) {
  double from = 0.0, to = 0.0, step = 0.0;
  int known = 0;
  for (const auto& [key, value] : node.entries(kRangeForms)) {
    double* target = key == "from" ? &from : key == "to" ? &to : key == "step" ? &step : nullptr;
    if (target == nullptr)
      value.fail("unknown key, expected from, to, step" +
                 did_you_mean(key, {"from", "to", "step"}));
    *target = value.number();
    ++known;
  }
  if (known != 3) node.fail("expected all of from, to and step");
  const double steps = (to - from) / step;
  if (!(steps >= 0.0 && steps < kMostValues) || std::abs(steps - std::round(steps)) > 1e-6)
    node.fail("found from " + number_text(from) + " to " + number_text(to) + " by " +
              number_text(step) + ", expected a whole number of steps that lead there");
  for (int i = 0; i <= static_cast<int>(std::lround(steps)); ++i) {
    const std::string value = number_text(from + i * step);
    range.choices.push_back({value, {{range.name, value, node.line()}}});
  }
}

void read_named(const StudyNode& node, StudyRange& range) {
  range.named = true;
  for (const auto& [name, keys] : node.entries(kRangeForms)) {
    check_name(range, name, keys);
    StudyChoice choice{name, {}};
    const bool nothing = keys.yaml().IsMap() && keys.yaml().size() == 0;
    if (!nothing) {
      for (const auto& [key, value] : keys.entries("the keys it sets, or {} for the case as it is"))
        choice.settings.push_back(setting(key, value));
    }
    range.choices.push_back(std::move(choice));
  }
}

std::size_t find_range(const Study& study, const std::string& name, const StudyNode& at) {
  std::vector<std::string> names;
  for (const StudyRange& r : study.ranges) names.push_back(r.name);
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) at.fail("this is no range of the study" + did_you_mean(name, names));
  return static_cast<std::size_t>(found - names.begin());
}

std::size_t find_choice(const StudyRange& range, const StudyNode& word) {
  if (!word.is_scalar()) word.fail("found a list or a map, expected one or more of the range");
  std::vector<std::string> names;
  for (const StudyChoice& c : range.choices) names.push_back(c.name);
  const std::string& name = word.yaml().Scalar();
  const auto found =
      std::ranges::find_if(names, [&](const std::string& n) { return same_name(n, name); });
  if (found == names.end())
    word.fail("found '" + name + "', which is not in the range" + did_you_mean(name, names));
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

StudyRange read_study_range(const std::string& name, const StudyNode& node) {
  StudyRange range{name, false, node.line(), {}};
  const YAML::Node& yaml = node.yaml();
  if (yaml.IsSequence()) {
    read_list(node, range);
  } else if (yaml.IsMap() && std::any_of(yaml.begin(), yaml.end(), [](const auto& entry) {
               return entry.second.IsScalar();
             })) {
    read_interval(node, range);
  } else {
    read_named(node, range);
  }
  return range;
}

StudyExclusion read_study_selection(const Study& study, const StudyNode& node) {
  StudyExclusion exclusion;
  for (const auto& [name, value] : node.entries("ranges with what to leave out")) {
    StudyExclusion::Part part{find_range(study, name, value), {}};
    const StudyRange& range = study.ranges[part.range];
    if (value.yaml().IsSequence()) {
      for (const StudyNode& item : value.items("one or more of the range"))
        part.choices.push_back(find_choice(range, item));
    } else {
      part.choices.push_back(find_choice(range, value));
    }
    exclusion.parts.push_back(std::move(part));
  }
  return exclusion;
}

bool StudyExclusion::matches(const std::vector<std::size_t>& choices) const {
  return std::ranges::all_of(parts, [&](const Part& part) {
    return std::ranges::find(part.choices, choices[part.range]) != part.choices.end();
  });
}

Study load_study(const fs::path& file) {
  YamlReader in = YamlReader::load(file);
  Study study;
  study.file = file;
  study.name = file.stem().string();
  study.base_case = in.existing_file("case");
  study.folder = in.has("folder") ? in.path("folder") : fs::path("results") / study.name;
  study.time_limit_s = in.number("time_limit_s", 0.0, Range::not_negative());
  const YAML::Node root = YAML::LoadFile(file.string());
  const auto part = [&](const char* key) { return StudyNode(study.file, root[key], key); };
  if (in.has("set")) {
    for (const auto& [key, value] : part("set").entries("keys of the case"))
      study.settings.push_back(setting(key, value));
  }
  in.map("ranges");  // has to be there
  for (const auto& [name, node] : part("ranges").entries("ranges"))
    study.ranges.push_back(read_study_range(name, node));
  if (in.has("exclude")) {
    for (const StudyNode& node : part("exclude").items("a list of what to leave out"))
      study.exclusions.push_back(read_study_selection(study, node));
  }
  in.finish();
  return study;
}

}  // namespace lac::sim
