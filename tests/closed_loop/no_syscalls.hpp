// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lac::test {

/// From here on the kernel ends this process (SIGSYS) at any system call but exit.
inline bool forbid_system_calls() {
  sock_filter program[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
  };
  const sock_fprog filter{sizeof program / sizeof program[0], program};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

inline constexpr int kNoFilter = 200;  // the kernel refused

/// Runs `code`, which gives an int, in a child process that may make no system call. Gives what
/// waitpid() gives: the int << 8 if the code returned, kNoFilter << 8 if it could not be tried, a
/// signal if it was ended.
template <typename Code>
int wait_status_without_system_calls(const Code& code) {
  const pid_t child = fork();
  if (child == 0) {
    if (!forbid_system_calls()) _exit(kNoFilter);
    syscall(SYS_exit, code());
  }
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

}  // namespace lac::test
