// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <future>
#include <vector>

namespace lac::sim {

/// Spreads count jobs over threads; each thread makes its own worker (with its work space). Which
/// thread does which job is open, so the jobs must not depend on it. Rethrows what a job throws;
/// jobs that have not begun by then are left undone.
template <class MakeWorker>
void for_each_job(int count, int threads, const MakeWorker& make_worker) {
  std::atomic<int> next{0};
  const auto run = [&] {
    try {
      auto worker = make_worker();
      for (int job = next++; job < count; job = next++) worker(job);
    } catch (...) {
      next = count;
      throw;
    }
  };
  std::vector<std::future<void>> others;
  for (int i = 1; i < threads; ++i) others.push_back(std::async(std::launch::async, run));
  run();
  for (auto& other : others) other.get();
}

}  // namespace lac::sim
