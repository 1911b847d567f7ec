// SPDX-License-Identifier: Apache-2.0
#include <dlfcn.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <mutex>

#include "core/system_loader.hpp"
#include "core/system_reason.hpp"

namespace lac::loader {
namespace fs = std::filesystem;
namespace {

constexpr std::array kCrashes{SIGABRT, SIGSEGV, SIGBUS, SIGILL, SIGFPE};

/// What a handler of signals can reach.
struct LastWords {
  std::array<char, 4096> text;
  std::size_t length = 0;
  std::array<struct sigaction, kCrashes.size()> hosts{};
};
LastWords last_words;

extern "C" void say_last_words(int signal) {
  [[maybe_unused]] const auto ignored =
      write(STDERR_FILENO, last_words.text.data(), last_words.length);
  const auto* at = std::find(kCrashes.begin(), kCrashes.end(), signal);
  sigaction(signal, &last_words.hosts[static_cast<std::size_t>(at - kCrashes.begin())], nullptr);
  if (signal == SIGABRT) raise(signal);  // the others come again when this returns
}

/// While it lives, a crash of this process names the file on the standard error.
class CrashWitness {
 public:
  explicit CrashWitness(const fs::path& file) : alone_(mutex()) {
    const int length = std::snprintf(
        last_words.text.data(), last_words.text.size(),
        "LAC Chain: the process ended while it loaded %s: the start-up code of this library "
        "crashed, aborted or threw an exception\n",
        file.c_str());
    last_words.length =
        std::min(static_cast<std::size_t>(std::max(length, 0)), last_words.text.size() - 1);
    struct sigaction ours {};
    ours.sa_handler = say_last_words;
    for (std::size_t i = 0; i < kCrashes.size(); ++i) {
      sigaction(kCrashes[i], &ours, &last_words.hosts[i]);
    }
  }
  ~CrashWitness() {
    for (std::size_t i = 0; i < kCrashes.size(); ++i) {
      sigaction(kCrashes[i], &last_words.hosts[i], nullptr);
    }
  }
  CrashWitness(const CrashWitness&) = delete;
  CrashWitness& operator=(const CrashWitness&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  std::lock_guard<std::mutex> alone_;
};

}  // namespace

#if defined(__APPLE__)
const char* const kSuffix = ".dylib";
#else
const char* const kSuffix = ".so";
#endif
const bool kFileMayGo = true;

void* load(const fs::path& file, std::string& reason) {
  const CrashWitness witness(file);
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) reason = dlerror();
  return handle;
}

void* symbol(void* handle, const char* name) noexcept {
  return dlsym(handle, name);
}

void unload(void* handle) noexcept {
  dlclose(handle);
}

fs::path file_of(const void* address) {
  Dl_info info{};
  if (dladdr(address, &info) == 0 || info.dli_fname == nullptr) return {};
  return info.dli_fname;
}

fs::path make_own_folder(const fs::path& parent, const std::string& prefix, std::string& reason) {
  std::string name = (parent / (prefix + std::to_string(getpid()) + "_XXXXXX")).string();
  if (mkdtemp(name.data()) != nullptr) return name;  // mode 0700
  reason = system_reason(errno);
  return {};
}

bool process_runs(long id) {
  return kill(static_cast<pid_t>(id), 0) == 0 || errno != ESRCH;
}

}  // namespace lac::loader
