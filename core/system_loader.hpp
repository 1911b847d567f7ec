// SPDX-License-Identifier: Apache-2.0
// What the operating system does with library files; one implementation per system.
#pragma once

#include <filesystem>
#include <string>

namespace lac::loader {

/// ".so", ".dll", ".dylib".
extern const char* const kSuffix;

/// May the file of a loaded library be removed? Not on Windows.
extern const bool kFileMayGo;

/// Loads a library, all its symbols resolved and none shown to others; nullptr and the system's
/// reason if it refuses. A library whose start-up code crashes, aborts or throws ends the process
/// (an exception does not come through the loader); on Linux its name is written to the standard
/// error then, and the host's handlers of signals follow.
void* load(const std::filesystem::path& file, std::string& reason);
void* symbol(void* handle, const char* name) noexcept;
void unload(void* handle) noexcept;

/// The file that holds this code or constant; empty if unknown.
std::filesystem::path file_of(const void* address);

/// A new, empty folder that nobody else can enter: <parent>/<prefix><process id>_<letters>. Empty
/// and the system's reason if it refuses.
std::filesystem::path make_own_folder(const std::filesystem::path& parent,
                                      const std::string& prefix, std::string& reason);

/// False if the process with this id has certainly ended.
bool process_runs(long id);

}  // namespace lac::loader
