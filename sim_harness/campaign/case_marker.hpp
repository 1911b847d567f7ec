// SPDX-License-Identifier: Apache-2.0
// What a case leaves in its folder when it has ended: a file `done` or `failed`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/part_file.hpp"

namespace lac::sim {

/// A table of texts: one row of figures per controller that was flown.
struct CaseFigures {
  std::vector<std::string> columns;
  std::vector<std::string> controllers;
  std::vector<std::vector<std::string>> rows;  // one per controller, one text per column

  bool operator==(const CaseFigures&) const = default;
};

enum class CaseState { kOpen, kDone, kFailed };

/// "open", "done", "failed".
const char* word(CaseState state);

struct CaseMarker {
  CaseState state = CaseState::kOpen;  // neither marker is there, or it is not complete
  std::string fingerprint;             // of what flew
  CaseFigures figures;                 // of a case that is done
  std::string reason;                  // why it failed
};

/// Of the case that has this folder for its results.
CaseMarker read_marker(const std::filesystem::path& folder);

/// Holds the folder for one process from before the flight until the marker is written; the marker
/// appears complete, under its own name, in one step, or never. What an earlier flight left is
/// removed at the start.
class MarkerWriter {
 public:
  /// Throws lac::Error if the folder cannot be made or another process flies this case.
  MarkerWriter(const std::filesystem::path& folder, std::string fingerprint);

  /// Throws lac::Error if the disk refuses it.
  void done(const CaseFigures& figures);
  void failed(const std::string& reason);

 private:
  void remove_older() const;

  std::filesystem::path folder_;
  std::string fingerprint_;
  PartFile done_;
};

}  // namespace lac::sim
