// SPDX-License-Identifier: Apache-2.0
// Proof that code does not allocate. Include in one source file of a test executable only: it
// replaces malloc and its relatives there, and with them operator new, also for libraries the
// executable opens (their malloc resolves to the executable's, even when they carry their own
// C++ runtime).
//
//   NoAllocGuard guard;
//   step();
//   EXPECT_EQ(guard.allocations(), 0U);
//
// Under address and thread sanitizer malloc belongs to the sanitizer, and where there is no glibc
// (Windows) it cannot be replaced: kCountsAllocations is false, the count stays 0 and says nothing.
// A test of the guard itself skips on it.
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define LAC_MALLOC_IS_OUT_OF_REACH 1
#else
#define LAC_MALLOC_IS_OUT_OF_REACH 0
#endif

namespace lac::test {

inline constexpr bool kCountsAllocations = LAC_MALLOC_IS_OUT_OF_REACH == 0;

/// Allocations of this thread since its start; reallocation counts, freeing does not.
inline thread_local std::uint64_t allocations_of_thread = 0;

class NoAllocGuard {
 public:
  /// Allocations of this thread since the guard was made.
  std::uint64_t allocations() const { return allocations_of_thread - at_start_; }

 private:
  std::uint64_t at_start_ = allocations_of_thread;
};

}  // namespace lac::test

#if !LAC_MALLOC_IS_OUT_OF_REACH
#define LAC_TEST_EXPORT __attribute__((visibility("default"), used))

extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

LAC_TEST_EXPORT void* malloc(std::size_t size) {
  ++lac::test::allocations_of_thread;
  return __libc_malloc(size);
}
LAC_TEST_EXPORT void* calloc(std::size_t count, std::size_t size) {
  ++lac::test::allocations_of_thread;
  return __libc_calloc(count, size);
}
LAC_TEST_EXPORT void* realloc(void* block, std::size_t size) {
  ++lac::test::allocations_of_thread;
  return __libc_realloc(block, size);
}
LAC_TEST_EXPORT void* memalign(std::size_t alignment, std::size_t size) {
  ++lac::test::allocations_of_thread;
  return __libc_memalign(alignment, size);
}
LAC_TEST_EXPORT void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++lac::test::allocations_of_thread;
  return __libc_memalign(alignment, size);
}
LAC_TEST_EXPORT int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  ++lac::test::allocations_of_thread;
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}

}  // extern "C"

#undef LAC_TEST_EXPORT
#endif
