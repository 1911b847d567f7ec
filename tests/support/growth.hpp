// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <iostream>

#include "support/process_state.hpp"

#if defined(__linux__)
#include <malloc.h>
#include <unistd.h>

#include <fstream>
#include <string>
#endif

namespace lac::test {

/// What a process holds, or by how much that has grown. Sanitizers keep memory of their own, which
/// is then left out: 0.
struct Holdings {
  int libraries = 0;  // see loaded_libraries()
  int files = 0;
  int mappings = 0;  // of any kind, where the system tells
  long resident_kib = 0;
  double heap_kib = 0.0;  // allocated and not freed

  static Holdings now() {
    Holdings h{loaded_libraries(), open_files()};
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) ++h.mappings;
    long pages = 0;
    std::ifstream("/proc/self/statm") >> pages >> pages;
    h.resident_kib = pages * (sysconf(_SC_PAGESIZE) / 1024);
    h.heap_kib = static_cast<double>(mallinfo2().uordblks) / 1024.0;
#endif
    return h;
  }
};

/// Growth over so many repetitions, after some that the memory allocator learns from. A tenth of
/// them under sanitizers, which are slow.
template <class Action>
Holdings growth_of(int repetitions, Action&& action) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  repetitions /= 10;
#endif
  for (int i = 0; i < repetitions / 10; ++i) action();
  const Holdings before = Holdings::now();
  for (int i = 0; i < repetitions; ++i) action();
  const Holdings after = Holdings::now();
  return {after.libraries - before.libraries, after.files - before.files,
          after.mappings - before.mappings, after.resident_kib - before.resident_kib,
          after.heap_kib - before.heap_kib};
}

/// Resident memory may move by a few pages with the allocator's mood; 1000 leaks of 300 bytes
/// would be seen.
inline void expect_no_growth(const Holdings& grown) {
  std::cout << "resident memory grew by " << grown.resident_kib << " KiB\n";
  EXPECT_EQ(grown.libraries, 0);
  EXPECT_EQ(grown.files, 0);
  EXPECT_LE(grown.mappings, 0);
  EXPECT_LE(grown.resident_kib, 256);
}

}  // namespace lac::test
