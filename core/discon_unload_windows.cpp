// SPDX-License-Identifier: Apache-2.0
// What a library built with MinGW-w64 gives back when a host on Windows unloads it. The thread
// runtime inside it (winpthreads) takes at the first exception one of the 1088 thread-local slots
// of the process, two handles and some memory, and leaves them behind: a host that loads a library
// anew for each run would end after a thousand runs. This ends the part of the unloading thread, as
// when a thread ends, and frees the slot. Where winpthreads is another than versions 10 to 12 and
// lacks these names, nothing is done.
#include <pthread.h>
#include <windows.h>

#include <cstdlib>

extern "C" {
extern PIMAGE_TLS_CALLBACK __xl_f __attribute__((weak));
extern void* __pth_gpointer_locked(pthread_t) __attribute__((weak));
extern void (**_pthread_key_dest)(void*) __attribute__((weak));
}

namespace {

constexpr DWORD kSlots = 1088;

bool unloading = false;

DWORD slot_with(const void* value) {
  DWORD slot = 0;
  while (slot < kSlots && TlsGetValue(slot) != value) ++slot;
  return slot;
}

// After all destructors of C++.
__attribute__((destructor(101))) void leave_thread_runtime() {
  const bool known = &__xl_f != nullptr && &__pth_gpointer_locked != nullptr;
  if (!unloading || !known) return;
  void* const own = __pth_gpointer_locked(pthread_self());
  const DWORD slot = slot_with(own);
  __xl_f(nullptr, DLL_THREAD_DETACH, nullptr);
  if (slot < kSlots) TlsFree(slot);
  std::free(own);
  if (&_pthread_key_dest != nullptr) std::free(reinterpret_cast<void*>(_pthread_key_dest));
}

}  // namespace

// Comes first. At the end of the process there is a third argument, and nothing to give back.
extern "C" BOOL WINAPI DllMain(HINSTANCE, DWORD reason, LPVOID process_ends) {
  unloading = reason == DLL_PROCESS_DETACH && process_ends == nullptr;
  return TRUE;
}
