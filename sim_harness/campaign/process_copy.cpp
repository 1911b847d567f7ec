// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/process_copy.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "core/error.hpp"
#include "core/system_reason.hpp"

namespace lac::sim {
namespace {

void flush_all() {
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
}

/// Ends with its parent, and does not stop by itself when the user asks the parent to.
void attach_to(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it ended before we asked
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
}

}  // namespace

pid_t start_copy(const std::function<int()>& work) {
  flush_all();
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process < 0) throw Error("no process can be started: " + system_reason(errno));
  if (process > 0) return process;
  int code = 1;
  try {
    attach_to(parent);
    code = work();
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
  } catch (...) {
    std::cerr << "an exception of unknown type\n";
  }
  flush_all();
  ::_exit(code);
}

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string describe_end(int status) {
  if (!WIFSIGNALED(status)) return "ended with exit code " + std::to_string(WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  return "ended by signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")";
}

void redirect_to(const std::filesystem::path& log) {
  flush_all();
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (nothing < 0 || file < 0)
    throw Error(log.string() + ": cannot be opened: " + system_reason(errno));
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(file, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  ::close(nothing);
  ::close(file);
}

}  // namespace lac::sim
