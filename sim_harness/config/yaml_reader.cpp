// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/config/yaml_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <utility>

#include "core/error.hpp"
#include "core/plain_number.hpp"
#include "core/suggest.hpp"

namespace lac::sim {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::string kind_of(const YAML::Node& node) {
  if (node.IsMap()) return "a map";
  if (node.IsSequence()) return "a list";
  return "nothing";
}

/// Position in a list if the word is one, else -1.
int list_position(const YAML::Node& node, const std::string& word) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = error == std::errc() && end == word.data() + word.size();
  return whole && value < node.size() ? static_cast<int>(value) : -1;
}

[[noreturn]] void refuse(const std::string& override_text, const std::string& problem) {
  throw Error("--set " + override_text + ": " + problem);
}

YAML::Node child(const YAML::Node& node, const std::string& word,
                 const std::string& override_text) {
  if (node.IsSequence()) {
    const int at = list_position(node, word);
    if (at >= 0) return node[static_cast<std::size_t>(at)];
    refuse(override_text, "'" + word + "' is no position in a list of " +
                              std::to_string(node.size()) + "; expected a number from 0");
  }
  if (node.IsScalar()) {
    refuse(override_text, "there are no keys below a single value; found '" + node.Scalar() +
                              "' where '" + word + "' should be");
  }
  YAML::Node map = node;
  return map[word];
}

/// The node a dotted key points to, made where the file has none.
YAML::Node descend(YAML::Node node, std::string key, const std::string& override_text) {
  while (!key.empty()) {
    const std::size_t dot = std::min(key.find('.'), key.size());
    node.reset(child(node, key.substr(0, dot), override_text));
    key.erase(0, dot + 1);
  }
  return node;
}

void apply_override(const YAML::Node& root, const std::string& override_text) {
  const std::size_t equals = override_text.find('=');
  if (equals == std::string::npos || equals == 0) {
    refuse(override_text, "expected key=value, e.g. time.duration_s=120");
  }
  try {
    YAML::Node target = descend(root, override_text.substr(0, equals), override_text);
    target = YAML::Load(override_text.substr(equals + 1));
  } catch (const YAML::Exception& e) {
    refuse(override_text, "the value is not valid YAML: " + e.msg);
  }
}

}  // namespace

YamlReader YamlReader::load(const std::filesystem::path& file, const Overrides& overrides) {
  std::error_code ec;
  if (std::filesystem::is_directory(file, ec)) {
    throw Error(file.string() + ": is a folder, expected a YAML file");
  }
  YAML::Node root;
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAllFromFile(file.string());
    if (documents.size() > 1) {
      throw Error(file.string() + ": found " + std::to_string(documents.size()) +
                  " YAML documents (lines '---'), expected one");
    }
    if (!documents.empty()) root = documents.front();
  } catch (const YAML::BadFile&) {
    const bool exists = std::filesystem::exists(file, ec);
    throw Error(file.string() + ": cannot be read: " + (exists ? "no permission" : "no such file") +
                "; expected a YAML file");
  } catch (const YAML::Exception& e) {
    throw Error(file.string() + ":" + std::to_string(e.mark.line + 1) +
                ": not valid YAML: " + e.msg);
  }
  for (const std::string& text : overrides) apply_override(root, text);
  return {root, std::make_shared<const std::filesystem::path>(file),
          std::make_shared<const Overrides>(overrides), ""};
}

YamlReader::YamlReader(const YAML::Node& node, std::shared_ptr<const std::filesystem::path> file,
                       std::shared_ptr<const Overrides> overrides, std::string name)
    : node_(node),
      file_(std::move(file)),
      overrides_(std::move(overrides)),
      name_(std::move(name)) {
  if (!node_.IsMap()) {
    std::string what = node_.IsScalar() ? "'" + node_.Scalar() + "'" : kind_of(node_);
    const std::string in = name_.empty() ? "" : name_.substr(0, name_.size() - 1) + ": ";
    throw Error(place("", node_.Mark()) + in + "found " + what + ", expected lines 'key: value'");
  }
  for (const auto& entry : node_) {
    const std::string& key = entry.first.Scalar();
    if (contains(keys_, key)) fail_at(key, entry.first.Mark(), "the key is there twice");
    keys_.push_back(key);
  }
}

YamlReader YamlReader::inner(const YAML::Node& node, const std::string& name) const {
  return {node, file_, overrides_, name_ + name + "."};
}

std::string YamlReader::place(const std::string& key, const YAML::Mark& mark) const {
  const std::string full = name_ + key;
  for (auto it = overrides_->rbegin(); it != overrides_->rend(); ++it) {
    const std::string set_key = it->substr(0, it->find('='));
    if (full == set_key || full.starts_with(set_key + ".") || set_key.starts_with(full + ".")) {
      if (mark.line <= 0) return "--set " + *it + ": ";
    }
  }
  return file_->string() + ":" + std::to_string(std::max(mark.line, 0) + 1) + ": ";
}

void YamlReader::fail_at(const std::string& key, const YAML::Mark& mark,
                         const std::string& problem) const {
  throw Error(place(key, mark) + name_ + key + ": " + problem);
}

void YamlReader::fail(const std::string& key, const std::string& problem) const {
  const bool there = contains(keys_, key);
  fail_at(key, there ? node_[key].Mark() : node_.Mark(), problem);
}

bool YamlReader::has(const std::string& key) {
  if (!contains(asked_, key)) asked_.push_back(key);
  return contains(keys_, key);
}

YAML::Node YamlReader::need(const std::string& key) {
  if (has(key)) return node_[key];
  std::vector<std::string> unread;
  std::copy_if(keys_.begin(), keys_.end(), std::back_inserter(unread),
               [&](const std::string& k) { return !contains(asked_, k); });
  const std::string near = closest(key, unread);
  fail(key, "the key is missing" + (near.empty() ? "" : "; is '" + near + "' meant to be it?"));
}

std::string YamlReader::scalar(const YAML::Node& node, const std::string& key,
                               const char* expected) const {
  if (!node.IsScalar()) {
    fail_at(key, node.Mark(), "found " + kind_of(node) + ", expected " + expected);
  }
  return node.Scalar();
}

double YamlReader::to_number(const YAML::Node& node, const std::string& key, Range range) const {
  const std::string word = scalar(node, key, "a number");
  const std::optional<double> value = plain_number(without_plus(word));
  if (!value || !std::isfinite(*value)) {
    fail_at(key, node.Mark(), "found '" + word + "', expected a number");
  }
  if (!range.contains(*value)) {
    fail_at(key, node.Mark(), "found " + word + ", expected " + range.text());
  }
  return *value;
}

double YamlReader::number(const std::string& key, Range range) {
  return to_number(need(key), key, range);
}

int YamlReader::integer(const std::string& key, Range range) {
  const double value = number(key, range);
  if (value != std::round(value) || std::abs(value) > 2147483647.0) {
    fail(key, "found " + node_[key].Scalar() + ", expected a whole number");
  }
  return static_cast<int>(value);
}

bool YamlReader::flag(const std::string& key) {
  const YAML::Node node = need(key);
  const std::string word = scalar(node, key, "true or false");
  bool value = false;
  if (!YAML::convert<bool>::decode(node, value)) {
    fail(key, "found '" + word + "', expected true or false");
  }
  return value;
}

std::string YamlReader::text(const std::string& key) {
  return scalar(need(key), key, "text");
}

YAML::Node YamlReader::list(const std::string& key, const char* of_what) {
  const YAML::Node node = need(key);
  if (!node.IsSequence() || node.size() == 0) {
    const std::string found = node.IsScalar() ? "'" + node.Scalar() + "'" : kind_of(node);
    fail(key, "found " + (node.IsSequence() ? "an empty list" : found) + ", expected a list of " +
                  of_what);
  }
  return node;
}

std::vector<double> YamlReader::numbers(const std::string& key, Range range) {
  std::vector<double> values;
  for (const YAML::Node& item : list(key, "numbers")) {
    values.push_back(to_number(item, key, range));
  }
  return values;
}

std::vector<std::string> YamlReader::texts(const std::string& key) {
  std::vector<std::string> values;
  for (const YAML::Node& item : list(key, "words")) values.push_back(scalar(item, key, "a word"));
  return values;
}

int YamlReader::choice(const std::string& key, const std::vector<std::string>& choices) {
  const std::string word = text(key);
  std::string all;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (equal_ignoring_case(word, choices[i])) return static_cast<int>(i);
    all += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + choices[i];
  }
  fail(key, "found '" + word + "', expected " + all + did_you_mean(word, choices));
}

YamlReader YamlReader::map(const std::string& key) {
  return inner(need(key), key);
}

std::vector<YamlReader> YamlReader::maps(const std::string& key) {
  std::vector<YamlReader> readers;
  for (const YAML::Node& item : list(key, "maps, each beginning with '-'")) {
    readers.push_back(inner(item, key + "." + std::to_string(readers.size())));
  }
  return readers;
}

std::filesystem::path YamlReader::path(const std::string& key) {
  const std::string word = text(key);
  if (word.empty()) fail(key, "found nothing, expected a path");
  return (file_->parent_path() / word).lexically_normal();
}

std::filesystem::path YamlReader::existing_file(const std::string& key) {
  std::filesystem::path file = path(key);
  std::error_code ec;
  if (std::filesystem::is_directory(file, ec)) {
    fail(key, "found the folder " + file.string() + ", expected a file");
  }
  if (!std::ifstream(file)) {
    const bool exists = std::filesystem::exists(file, ec);
    fail(key, file.string() + " cannot be read: " + (exists ? "no permission" : "no such file"));
  }
  return file;
}

double YamlReader::number(const std::string& key, double fallback, Range range) {
  return has(key) ? number(key, range) : fallback;
}
int YamlReader::integer(const std::string& key, int fallback, Range range) {
  return has(key) ? integer(key, range) : fallback;
}
bool YamlReader::flag(const std::string& key, bool fallback) {
  return has(key) ? flag(key) : fallback;
}
std::string YamlReader::text(const std::string& key, const std::string& fallback) {
  return has(key) ? text(key) : fallback;
}
int YamlReader::choice(const std::string& key, int fallback,
                       const std::vector<std::string>& choices) {
  return has(key) ? choice(key, choices) : fallback;
}

void YamlReader::finish() const {
  for (const auto& entry : node_) {
    const std::string& key = entry.first.Scalar();
    if (!contains(asked_, key)) {
      fail_at(key, entry.first.Mark(), "unknown key" + did_you_mean(key, asked_));
    }
  }
}

}  // namespace lac::sim
