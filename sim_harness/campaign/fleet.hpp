// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "sim_harness/campaign/campaign_progress.hpp"
#include "sim_harness/campaign/wind_worker.hpp"
#include "sim_harness/run/interruption.hpp"

namespace lac::sim {

/// Keeps as many workers flying as there are jobs, the orders in their order.
class Fleet {
 public:
  Fleet(std::vector<WindOrder> orders, int jobs, CampaignProgress& progress)
      : orders_(std::move(orders)), jobs_(static_cast<std::size_t>(jobs)), progress_(progress) {}

  /// Until all is flown or somebody asks to stop; then what flies is given up. Throws lac::Error if
  /// no process can be started.
  void fly(const Interruption& interruption);

 private:
  void wait();
  void tell(const std::vector<MarkedCase>& ended);

  std::vector<WindOrder> orders_;
  std::size_t jobs_;
  CampaignProgress& progress_;
  std::size_t next_ = 0;
  std::vector<std::unique_ptr<WindWorker>> workers_;
};

}  // namespace lac::sim
