// SPDX-License-Identifier: Apache-2.0
// Processes of a campaign: how they begin, and what their end means.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>

namespace lac::sim {

/// Runs `work` in a copy of this process, which ends behind it with the exit code that `work`
/// gives, or with 1 if it throws. The copy ends at once if this process ends in any way, and lets a
/// Ctrl-C be this process' business. This process must have no other thread. Throws lac::Error.
pid_t start_copy(const std::function<int()>& work);

/// Waits for its end; the status of waitpid().
int wait_for(pid_t process);

/// "ended by signal 11 (Segmentation fault)", "ended with exit code 3".
std::string describe_end(int status);

/// Standard output and error go to the end of this file from now on, input comes from nowhere.
void redirect_to(const std::filesystem::path& log);

}  // namespace lac::sim
