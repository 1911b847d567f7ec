// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/case_marker.hpp"

#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "core/error.hpp"

namespace lac::sim {
namespace fs = std::filesystem;
namespace {

constexpr char kDone[] = "done";
constexpr char kFailed[] = "failed";
constexpr char kFingerprint[] = "fingerprint ";
constexpr char kEnd[] = "end\n";  // a marker without it was cut off
constexpr char kTab = '\t';

std::string joined(const std::string& first, const std::vector<std::string>& cells) {
  std::string line = first;
  for (const std::string& cell : cells) line += kTab + cell;
  return line + '\n';
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == kTab) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// The text between the two fixed lines; empty if the file is not there or not complete.
std::optional<std::string> body(const fs::path& file, std::string& fingerprint) {
  std::ifstream in(file, std::ios::binary);
  std::string first;
  if (!std::getline(in, first) || !first.starts_with(kFingerprint)) return {};
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!text.ends_with(kEnd)) return {};
  fingerprint = first.substr(sizeof kFingerprint - 1);
  return text.substr(0, text.size() - (sizeof kEnd - 1));
}

bool read_figures(const std::string& text, CaseFigures& figures) {
  std::istringstream in(text);
  std::string line;
  if (!std::getline(in, line)) return false;
  figures.columns = cells_of(line);
  figures.columns.erase(figures.columns.begin());
  while (std::getline(in, line)) {
    std::vector<std::string> row = cells_of(line);
    if (row.size() != figures.columns.size() + 1) return false;
    figures.controllers.push_back(row.front());
    row.erase(row.begin());
    figures.rows.push_back(std::move(row));
  }
  return !figures.rows.empty();
}

void write_text(PartFile& file, const std::string& text) {
  file.write(text.data(), text.size());
  file.commit();
}

fs::path made(const fs::path& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) throw Error(folder.string() + ": cannot be created: " + problem.message());
  return folder;
}

}  // namespace

const char* word(CaseState state) {
  return state == CaseState::kDone ? kDone : state == CaseState::kFailed ? kFailed : "open";
}

CaseMarker read_marker(const fs::path& folder) {
  CaseMarker marker;
  if (const auto text = body(folder / kDone, marker.fingerprint)) {
    if (read_figures(*text, marker.figures)) marker.state = CaseState::kDone;
  } else if (const auto reason = body(folder / kFailed, marker.fingerprint)) {
    marker.state = CaseState::kFailed;
    marker.reason = reason->substr(0, reason->find_last_not_of('\n') + 1);
  }
  return marker;
}

MarkerWriter::MarkerWriter(const fs::path& folder, std::string fingerprint)
    : folder_(made(folder)), fingerprint_(std::move(fingerprint)), done_(folder_ / kDone) {
  remove_older();
}

void MarkerWriter::remove_older() const {
  for (const char* name : {kDone, kFailed}) {
    std::error_code problem;
    fs::remove(folder_ / name, problem);
    if (problem)
      throw Error((folder_ / name).string() + ": cannot be removed: " + problem.message());
  }
}

void MarkerWriter::done(const CaseFigures& figures) {
  std::string text = kFingerprint + fingerprint_ + '\n' + joined("controller", figures.columns);
  for (std::size_t i = 0; i < figures.rows.size(); ++i)
    text += joined(figures.controllers[i], figures.rows[i]);
  write_text(done_, text + kEnd);
}

void MarkerWriter::failed(const std::string& reason) {
  PartFile file(folder_ / kFailed);
  write_text(file, kFingerprint + fingerprint_ + '\n' + reason + '\n' + kEnd);
}

}  // namespace lac::sim
