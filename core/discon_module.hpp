// SPDX-License-Identifier: Apache-2.0
// What a controller library of ours is made of. The order of calls, the strings, statuses,
// messages and exceptions are the business of discon_entry.cpp; a module fills the slots below.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/notice.hpp"
#include "core/state_archive.hpp"
#include "core/swap_view.hpp"

namespace lac {

/// What a module is built from: the first call of a run or of a restart.
struct StartInfo {
  std::filesystem::path input_file;  // accINFILE
  std::string out_name;              // avcOUTNAME, root of output files
  double time_step_s = 0.0;          // record 3, read once; positive
  std::filesystem::path checkpoint;  // empty at a fresh start
  std::int64_t steps = 0;            // done before the checkpoint; 0 at a fresh start
  bool is_restart() const { return !checkpoint.empty(); }
};

/// One controller of one turbine.
class DisconModule {
 public:
  DisconModule() = default;
  DisconModule(const DisconModule&) = delete;
  DisconModule& operator=(const DisconModule&) = delete;
  virtual ~DisconModule() = default;

  /// Statuses 0 and 1: read records, advance by one step, write records.
  /// `time_s` is the number of steps since status 0 times the time step, exact over long runs.
  /// [real time: no allocation, file access, lock or throw]
  virtual void step(SwapView swap, double time_s, Notice& notice) noexcept = 0;

  /// Status -1: last call; the module is destroyed afterwards. [may use files, may throw]
  virtual void finish(SwapView /*swap*/, Notice& /*notice*/) {}

  /// The complete and exact state, for checkpoints (-8, -9) and sub-steps (-11, -10).
  virtual void visit_state(StateArchive& archive) = 0;

  /// -8, called after the state was saved to `file`: a place for what is not the module's own,
  /// such as the secondaries of the master. [may use files, may throw]
  virtual void checkpoint(const std::filesystem::path& /*file*/, SwapView /*swap*/,
                          Notice& /*notice*/) {}
  /// -9, called after the state was loaded from `file`. [may use files, may throw]
  virtual void restart(const std::filesystem::path& /*file*/, SwapView /*swap*/,
                       Notice& /*notice*/) {}
  /// -11 and -10, called after the own state was kept or brought back.
  virtual void store_or_restore(int /*status*/, SwapView /*swap*/, Notice& /*notice*/) {}
};

// Each library defines these two.

/// Name in front of every message.
const char* module_name();

/// Builds the module of one turbine: reads its input file, checks the array, allocates all.
/// Throws lac::Error; `notice` takes warnings. [may allocate, read files, throw]
std::unique_ptr<DisconModule> make_module(const StartInfo& start, SwapView swap, Notice& notice);

}  // namespace lac
