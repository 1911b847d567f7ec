// SPDX-License-Identifier: Apache-2.0
// Proof that code takes no lock: counts what a thread locks. Include in one source file of a test
// executable only (linked with exported symbols): it stands before the C library's functions,
// also for the libraries that the executable opens. Needs glibc; not for sanitizer builds, whose
// runtime does the same.
#pragma once

#include <dlfcn.h>
#include <pthread.h>

#include <cstdint>

namespace lac::test {

/// Mutexes and read-write locks this thread has asked for since its start.
inline thread_local std::uint64_t locks_of_thread = 0;

template <typename Lock>
int count_and_lock(Lock* lock, const char* name) {
  ++locks_of_thread;
  return reinterpret_cast<int (*)(Lock*)>(dlsym(RTLD_NEXT, name))(lock);
}

}  // namespace lac::test

#define LAC_TEST_COUNTED(name, Lock)                                                      \
  extern "C" __attribute__((visibility("default"), used)) int name(Lock* lock) noexcept { \
    return lac::test::count_and_lock(lock, #name);                                        \
  }
LAC_TEST_COUNTED(pthread_mutex_lock, pthread_mutex_t)
LAC_TEST_COUNTED(pthread_mutex_trylock, pthread_mutex_t)
LAC_TEST_COUNTED(pthread_rwlock_rdlock, pthread_rwlock_t)
LAC_TEST_COUNTED(pthread_rwlock_wrlock, pthread_rwlock_t)
#undef LAC_TEST_COUNTED
