// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/tuning/tuning_file.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <set>

#include "core/plain_number.hpp"
#include "core/suggest.hpp"
#include "sim_harness/analysis/channel_figures.hpp"
#include "sim_harness/campaign/study_file.hpp"
#include "sim_harness/campaign/study_node.hpp"
#include "sim_harness/comparison/life_table.hpp"
#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/run/case_file.hpp"
#include "sim_harness/run/flight.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

using Kind = TuningTarget::Kind;

/// Every figure a flight has, with a load of this exponent.
std::vector<std::string> figures_of_flights(double exponent) {
  Recording two_rows(flight_channels(), 0.0, 1.0, 2);
  const std::vector<float> zeros(flight_channels().size(), 0.0F);
  for (int i = 0; i < 2; ++i) two_rows.append(zeros.data());
  FigureOptions options;
  options.woehler_exponents = {exponent};
  std::vector<std::string> names;
  for (const NamedFigure& f : named_figures(channel_figures(two_rows, options), options))
    names.push_back(f.name);
  return names;
}

void read_figure(const StudyNode& node, TuningTarget& target) {
  target.figure = node.is_scalar() ? node.yaml().Scalar() : "";
  const double exponent = is_load(target.figure) ? exponent_of(target.figure) : 4.0;
  const std::vector<std::string> known = figures_of_flights(exponent);
  if (std::ranges::find(known, target.figure) == known.end())
    node.fail("found '" + target.figure +
              "', expected a figure of a channel as in the table of a campaign, such as "
              "TwrBsMyt_max" +
              did_you_mean(target.figure, known));
}

class TargetReader {
 public:
  TargetReader(const Study& study, const std::vector<StudyCase>& cases)
      : study_(study), cases_(cases) {}

  TuningTarget objective(const StudyNode& node, Kind kind) const {
    return read(node, kind, {"figure", "where"});
  }
  TuningTarget condition(const StudyNode& node) const {
    TuningTarget t =
        read(node, Kind::kAtLeast, {"figure", "where", "at_least_percent", "at_most_percent"});
    int limits = 0;
    for (const auto& [key, value] : node.entries("a condition")) {
      if (key != "at_least_percent" && key != "at_most_percent") continue;
      t.kind = key == "at_least_percent" ? Kind::kAtLeast : Kind::kAtMost;
      t.limit = 0.01 * value.number();
      ++limits;
    }
    if (limits != 1) node.fail("expected either at_least_percent or at_most_percent");
    return t;
  }

 private:
  TuningTarget read(const StudyNode& node, Kind kind, const std::vector<std::string>& keys) const {
    TuningTarget t;
    t.kind = kind;
    StudyExclusion where;
    for (const auto& [key, value] : node.entries("figure and where")) {
      if (std::ranges::find(keys, key) == keys.end())
        value.fail("unknown key" + did_you_mean(key, keys));
      if (key == "figure") read_figure(value, t);
      if (key != "where") continue;
      where = read_study_selection(study_, value);
      for (const auto& [range, choice] : value.entries("ranges"))
        t.where += (t.where.empty() ? "" : ", ") + range + " " + choice.flow_text();
    }
    if (t.figure.empty()) node.fail("has no figure");
    for (std::size_t i = 0; i < cases_.size(); ++i)
      if (where.matches(cases_[i].choices)) t.cases.push_back(i);
    if (t.cases.empty()) node.fail("where: none of the cases of the study is like this");
    return t;
  }

  const Study& study_;
  const std::vector<StudyCase>& cases_;
};

TuningParameter read_parameter(const std::string& key, const StudyNode& node) {
  const StudyRange range = read_study_range(key, node);
  if (range.named) node.fail("expected numbers, found names");
  std::set<double> values;
  for (const StudyChoice& c : range.choices) {
    const std::optional<double> value = plain_number(c.settings.front().value);
    if (!value) node.fail("found '" + c.settings.front().value + "', expected numbers");
    values.insert(four_digits(*value));
  }
  return {key, {values.begin(), values.end()}};
}

void check_controllers(const YamlReader& in, const Tuning& t) {
  for (const StudyCase& c : t.cases) {
    const Case loaded = load_case(t.base_case, c.overrides);
    std::vector<std::string> names;
    for (const CaseController& controller : loaded.controllers) names.push_back(controller.name);
    const auto need = [&](const char* key, const std::string& name) {
      if (std::ranges::find(names, name) == names.end())
        in.fail(key, "found '" + name + "', which is no controller of case " + c.name +
                         did_you_mean(name, names));
    };
    need("baseline", t.baseline);
    need("controller", t.controller);
  }
}

}  // namespace

double four_digits(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", v);
  return *plain_number(text);
}

Tuning load_tuning(const fs::path& file, const std::vector<std::string>& overrides) {
  YamlReader in = YamlReader::load(file);
  const YAML::Node root = YAML::LoadFile(file.string());
  const auto part = [&](const char* key) { return StudyNode(file, root[key], key); };
  Tuning t;
  t.file = file;
  t.name = file.stem().string();
  const Study study = load_study(in.existing_file("study"));
  t.base_case = study.base_case;
  t.baseline = in.text("baseline");
  t.controller = in.text("controller");
  t.secondary = in.text("secondary");
  t.refinements = in.integer("refinements", 0, Range::between(0, 10000));

  std::vector<std::string> settings;
  if (in.has("set")) {
    for (const auto& [key, value] : part("set").entries("keys of the case"))
      settings.push_back(key + "=" + value.flow_text());
  }
  settings.insert(settings.end(), overrides.begin(), overrides.end());
  t.cases = study_cases(study);
  for (StudyCase& c : t.cases)
    c.overrides.insert(c.overrides.end(), settings.begin(), settings.end());
  check_cases(study, t.cases);

  in.map("parameters");  // has to be there
  for (const auto& [key, node] : part("parameters").entries("keys of the input file"))
    t.parameters.push_back(read_parameter(key, node));
  const TargetReader targets(study, t.cases);
  const bool less = in.has("minimise");
  if (less == in.has("maximise")) in.fail("minimise", "expected either minimise or maximise");
  t.targets.push_back(targets.objective(part(less ? "minimise" : "maximise"),
                                        less ? Kind::kMinimise : Kind::kMaximise));
  if (in.has("conditions")) {
    for (const StudyNode& node : part("conditions").items("a list of conditions"))
      t.targets.push_back(targets.condition(node));
  }
  in.finish();
  check_controllers(in, t);
  return t;
}

}  // namespace lac::sim
