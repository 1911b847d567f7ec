// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace lac::sim {

/// A node of a study file whose keys are the user's own, with its place for messages:
/// "study.yaml:12: ranges.seed: ...".
class StudyNode {
 public:
  StudyNode(const std::filesystem::path& file, YAML::Node node, std::string name)
      : file_(&file), node_(std::move(node)), name_(std::move(name)) {}

  const YAML::Node& yaml() const { return node_; }
  const std::string& name() const { return name_; }
  int line() const { return node_.Mark().line + 1; }
  bool is_scalar() const { return node_.IsScalar(); }

  /// The entries of a map in the order of the file. Throws lac::Error if it is no map or empty,
  /// or a key is there twice.
  std::vector<std::pair<std::string, StudyNode>> entries(const char* expected) const;
  /// The items of a list; throws if it is no list or empty.
  std::vector<StudyNode> items(const char* expected) const;
  double number() const;
  /// The value on one line of YAML.
  std::string flow_text() const;

  [[noreturn]] void fail(const std::string& problem) const;

 private:
  const std::filesystem::path* file_;
  YAML::Node node_;
  std::string name_;
};

}  // namespace lac::sim
