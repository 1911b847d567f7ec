// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/input_file.hpp"

namespace lac::sim {

/// One map of a YAML file, read strictly: each key once, each asked for, none left over.
///
/// Every fault throws lac::Error "<file>:<line>: <key>: found ..., expected ...<hint>"; values
/// that were set from outside have "--set <key>=<value>" in the place of file and line. Ask for
/// all keys, then call finish(), which refuses the ones nobody asked for.
class YamlReader {
 public:
  /// overrides: "key.in.dots=value", the value in YAML, list items by number from 0
  /// ("controllers.1.name=x"). They replace or add what the file says.
  static YamlReader load(const std::filesystem::path& file,
                         const std::vector<std::string>& overrides = {});

  bool has(const std::string& key);

  /// A missing key is an error here ...
  double number(const std::string& key, Range range = Range::any());
  int integer(const std::string& key, Range range = Range::any());  // 20 as well as 20.000
  bool flag(const std::string& key);                                // true/false, yes/no, on/off
  std::string text(const std::string& key);
  std::vector<double> numbers(const std::string& key, Range range = Range::any());
  std::vector<std::string> texts(const std::string& key);
  /// Exactly one of the choices, case ignored; gives its position.
  int choice(const std::string& key, const std::vector<std::string>& choices);
  YamlReader map(const std::string& key);
  std::vector<YamlReader> maps(const std::string& key);  // a list of maps, at least one
  /// Relative ones count from this file's folder.
  std::filesystem::path path(const std::string& key);
  /// The same, of a file that is there and can be read.
  std::filesystem::path existing_file(const std::string& key);

  /// ... and means the default here.
  double number(const std::string& key, double fallback, Range range);
  int integer(const std::string& key, int fallback, Range range);
  bool flag(const std::string& key, bool fallback);
  std::string text(const std::string& key, const std::string& fallback);
  int choice(const std::string& key, int fallback, const std::vector<std::string>& choices);

  /// Refuses keys that nobody asked for. Call after the last reading function.
  void finish() const;
  /// For checks between keys: throws with place and key in front.
  [[noreturn]] void fail(const std::string& key, const std::string& problem) const;

  const std::filesystem::path& file() const { return *file_; }

 private:
  using Overrides = std::vector<std::string>;

  YamlReader(const YAML::Node& node, std::shared_ptr<const std::filesystem::path> file,
             std::shared_ptr<const Overrides> overrides, std::string name);
  YamlReader inner(const YAML::Node& node, const std::string& name) const;
  YAML::Node need(const std::string& key);
  std::string scalar(const YAML::Node& node, const std::string& key, const char* expected) const;
  double to_number(const YAML::Node& node, const std::string& key, Range range) const;
  YAML::Node list(const std::string& key, const char* of_what);
  std::string place(const std::string& key, const YAML::Mark& mark) const;
  [[noreturn]] void fail_at(const std::string& key, const YAML::Mark& mark,
                            const std::string& problem) const;

  YAML::Node node_;
  std::shared_ptr<const std::filesystem::path> file_;
  std::shared_ptr<const Overrides> overrides_;
  std::string name_;  // "" for the whole file, else "wind." or "controllers.0."
  std::vector<std::string> keys_;
  std::vector<std::string> asked_;
};

}  // namespace lac::sim
