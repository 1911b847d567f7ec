// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/record_map.hpp"

#include <algorithm>

#include "wrapper/host_records.hpp"

namespace lac::sim {
namespace {

using Touched = std::vector<bool> ObservedArray::Accesses::*;
constexpr Touched kRead = &ObservedArray::Accesses::read;
constexpr Touched kWritten = &ObservedArray::Accesses::written;

std::vector<std::string> users(const std::vector<SecondaryAccess>& all, int first, int last,
                               Touched how) {
  std::vector<std::string> names;
  for (const SecondaryAccess& s : all) {
    const auto from = (s.accesses.*how).begin() + first;
    if (std::find(from, from + (last - first + 1), true) != from + (last - first + 1)) {
      names.push_back(s.name);
    }
  }
  return names;
}

std::string name_of(const WrapperParams& chain, int record) {
  if (const RecordInfo* info = find_record(record)) return std::string(info->name);
  for (const NamedSignal& s : chain.signals) {
    if (s.record == record) return s.name;
  }
  return "-";
}

/// A block that is shown as one, or nullptr.
const RecordBlock* block_at(int record) {
  for (const RecordBlock* b : {&kNativeLidarBlock, &kOpenFastLidarBlock, &kPrivateGuoBlock}) {
    if (record == b->first) return b;
  }
  return nullptr;
}

/// Who fills it before the first secondary is called: "host", "master" or nobody (empty).
std::string filled_by(const WrapperParams& chain, int record) {
  const auto in = [record](const RecordBlock& b) {
    return record >= b.first && record <= b.last();
  };
  if (const RecordInfo* info = find_record(record)) {
    return info->writer == "host" ? "host" : info->writer == "wrapper" ? "master" : "";
  }
  const bool from_host = record <= kPlatformBlock.last() ||
                         (in(kNativeLidarBlock) && chain.lidar == HostLidar::Native) ||
                         (in(kOpenFastLidarBlock) && chain.lidar == HostLidar::OpenFast) ||
                         (in(kPrivateGuoBlock) && chain.lidar != HostLidar::None) ||
                         (in(kExtendedDemands) && chain.extended_demands);
  return from_host ? "host" : "";
}

bool is_shared(const WrapperParams& chain, int record) {
  return std::ranges::find(chain.shared_records, record) != chain.shared_records.end();
}

/// The record with its name: "45 (PitchDemandCollective)".
std::string titled(const WrapperParams& chain, int record) {
  const std::string name = name_of(chain, record);
  return std::to_string(record) + (name == "-" ? "" : " (" + name + ")");
}

/// As the key SharedRecords takes it.
std::string word_for(const WrapperParams& chain, int record) {
  const std::string name = name_of(chain, record);
  return name == "-" ? "rec" + std::to_string(record) : name;
}

/// A record without name and writer beside one that is read: loads of several records at once
/// take such ones along.
bool is_taken_along(const RecordUse& use, const std::vector<SecondaryAccess>& all) {
  if (use.name != "-" || !use.writers.empty()) return false;
  const int before = std::max(use.first - 1, 1);
  const int behind = std::min(use.last + 1, kPrivateArraySize);
  return !users(all, before, before, kRead).empty() || !users(all, behind, behind, kRead).empty();
}

void doubt_lidar(const WrapperParams& chain, const std::vector<SecondaryAccess>& all,
                 std::vector<std::string>& lines) {
  constexpr const char* kNames[] = {"none", "native", "guo", "openfast"};
  const std::pair<const RecordBlock&, HostLidar> blocks[] = {
      {kNativeLidarBlock, HostLidar::Native}, {kOpenFastLidarBlock, HostLidar::OpenFast}};
  for (const auto& [block, layout] : blocks) {
    const std::string readers = joined(users(all, block.first, block.last(), kRead));
    if (readers.empty() || chain.lidar == layout) continue;
    lines.push_back(chain.file.string() + ": LidarLayout is " +
                    kNames[static_cast<int>(chain.lidar)] + ", but " + readers + " reads the " +
                    std::string(block.name) + " block (" + std::to_string(block.first) + "-" +
                    std::to_string(block.last()) + "), which stays empty; expected LidarLayout " +
                    kNames[static_cast<int>(layout)]);
  }
}

}  // namespace

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<RecordUse> record_map(const WrapperParams& chain,
                                  const std::vector<SecondaryAccess>& all) {
  std::vector<RecordUse> map;
  for (int record = 1; record <= kPrivateArraySize;) {
    const RecordBlock* block = block_at(record);
    RecordUse use;
    use.first = record;
    use.last = block != nullptr ? block->last() : record;
    use.name = block != nullptr ? std::string(block->name) : name_of(chain, record);
    use.writers = users(all, use.first, use.last, kWritten);
    use.readers = users(all, use.first, use.last, kRead);
    record = use.last + 1;
    if (use.writers.empty() && use.readers.empty()) continue;
    const std::string before = filled_by(chain, use.first);
    if (!before.empty()) use.writers.insert(use.writers.begin(), before);
    if (!is_taken_along(use, all)) map.push_back(std::move(use));
  }
  return map;
}

std::string writers_in_conflict(const WrapperParams& chain,
                                const std::vector<SecondaryAccess>& all) {
  std::string text, words;
  for (int record = 1; record <= kPrivateArraySize; ++record) {
    const bool logged = record >= kPrivateLogBlock.first && record <= kPrivateLogBlock.last();
    const std::vector<std::string> writers = users(all, record, record, kWritten);
    if (writers.size() < 2 || logged || is_shared(chain, record)) continue;
    text += "\n  record " + titled(chain, record) + ": " + joined(writers);
    words += word_for(chain, record) + " ";
  }
  if (text.empty()) return text;
  return chain.file.string() +
         ": records written by more than one secondary, in the order of calls:" + text +
         "\nThe last one wins. If that is meant (it adds to or limits what the others wrote), say "
         "so "
         "in this file:\n  " +
         words +
         "! SharedRecords - two secondaries may write these\nElse let one of them write to a "
         "record of its own (" +
         std::to_string(kSignalBlock.first) + "-" + std::to_string(kSignalBlock.last()) +
         ", named by Signal_n), or leave one of them out.";
}

std::vector<std::string> doubts(const WrapperParams& chain,
                                const std::vector<SecondaryAccess>& all) {
  std::vector<std::string> lines;
  for (const RecordUse& use : record_map(chain, all)) {
    const bool lidar = block_at(use.first) != nullptr;
    if (!use.writers.empty() || use.readers.empty() || lidar) continue;
    lines.push_back("record " + titled(chain, use.first) + " is read by " + joined(use.readers) +
                    ", but written by nobody");
  }
  for (const NamedSignal& s : chain.signals) {
    if (users(all, s.record, s.record, kWritten).empty()) {
      lines.push_back("signal " + s.name + " (record " + std::to_string(s.record) +
                      ") is written by nobody");
    }
  }
  for (const int record : chain.shared_records) {
    if (users(all, record, record, kWritten).size() > 1) continue;
    lines.push_back("SharedRecords names " + word_for(chain, record) +
                    ", which no two secondaries write");
  }
  doubt_lidar(chain, all, lines);
  return lines;
}

}  // namespace lac::sim
