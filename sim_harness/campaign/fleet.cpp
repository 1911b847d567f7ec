// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/campaign/fleet.hpp"

#include <poll.h>

namespace lac::sim {
namespace {

constexpr int kLookEvery_ms = 200;  // for a request to stop, and for the line of progress

}  // namespace

void Fleet::fly(const Interruption& interruption) {
  while (!interruption.requested()) {
    while (workers_.size() < jobs_ && next_ < orders_.size())
      workers_.push_back(std::make_unique<WindWorker>(std::move(orders_[next_++])));
    if (workers_.empty()) return;
    wait();
    progress_.tick();
  }
  workers_.clear();
}

void Fleet::wait() {
  std::vector<pollfd> descriptors;
  for (const auto& worker : workers_) descriptors.push_back({worker->descriptor(), POLLIN, 0});
  if (::poll(descriptors.data(), descriptors.size(), kLookEvery_ms) <= 0) return;
  for (std::size_t i = 0; i < descriptors.size(); ++i)
    if (descriptors[i].revents != 0) tell(workers_[i]->take_reports());
  std::erase_if(workers_, [](const auto& worker) { return worker->ended(); });
}

void Fleet::tell(const std::vector<MarkedCase>& ended) {
  for (const MarkedCase& c : ended) {
    const CaseMarker marker = read_marker(c.folder);
    if (marker.state == CaseState::kDone) {
      progress_.case_done();
    } else {
      progress_.case_failed(c.folder.filename().string(), marker.reason);
    }
  }
}

}  // namespace lac::sim
