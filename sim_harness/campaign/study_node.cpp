// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/study_node.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/plain_number.hpp"

namespace lac::sim {
namespace {

std::string found(const YAML::Node& node) {
  if (node.IsScalar()) return "'" + node.Scalar() + "'";
  if (node.IsMap()) return node.size() == 0 ? "an empty map" : "a map";
  if (node.IsSequence()) return node.size() == 0 ? "an empty list" : "a list";
  return "nothing";
}

}  // namespace

void StudyNode::fail(const std::string& problem) const {
  throw Error(file_->string() + ":" + std::to_string(line()) + ": " + name_ + ": " + problem);
}

std::vector<std::pair<std::string, StudyNode>> StudyNode::entries(const char* expected) const {
  if (!node_.IsMap() || node_.size() == 0) {
    fail("found " + found(node_) + ", expected " + expected);
  }
  std::vector<std::pair<std::string, StudyNode>> all;
  for (const auto& entry : node_) {
    const StudyNode key(*file_, entry.first, name_);
    if (!entry.first.IsScalar()) key.fail("found " + found(entry.first) + " as a key");
    const std::string& word = entry.first.Scalar();
    const StudyNode named(*file_, entry.first, name_ + "." + word);
    const bool twice = std::ranges::any_of(all, [&](const auto& e) { return e.first == word; });
    if (twice) named.fail("the key is there twice");
    all.emplace_back(word, StudyNode(*file_, entry.second, named.name()));
  }
  return all;
}

std::vector<StudyNode> StudyNode::items(const char* expected) const {
  if (!node_.IsSequence() || node_.size() == 0) {
    fail("found " + found(node_) + ", expected " + expected);
  }
  std::vector<StudyNode> all;
  for (const YAML::Node& item : node_) all.emplace_back(*file_, item, name_);
  return all;
}

double StudyNode::number() const {
  const std::string word = node_.IsScalar() ? node_.Scalar() : "";
  const std::optional<double> value = plain_number(word);
  if (!value || !std::isfinite(*value)) fail("found " + found(node_) + ", expected a number");
  return *value;
}

std::string StudyNode::flow_text() const {
  YAML::Node copy = YAML::Clone(node_);
  copy.SetStyle(YAML::EmitterStyle::Flow);
  YAML::Emitter out;
  out << copy;
  return out.c_str();
}

}  // namespace lac::sim
