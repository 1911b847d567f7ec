// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/lidar_block.hpp"
#include "sim_harness/config/yaml_reader.hpp"
#include "sim_harness/lidar/random_stream.hpp"

namespace lac::sim {

struct OutageParams {
  double share = 0.0;           // of measurements, or of gates, lost independently of each other
  bool per_gate = false;        // what `share` counts
  double burst_share = 0.0;     // of measurements, lost in bursts
  double burst_length_s = 0.0;  // mean length of a burst, at least one measurement

  bool enabled() const { return share > 0.0 || burst_share > 0.0; }
};

/// Map `outages`: share (0), of (measurements; gates), burst_share (0), burst_length_s. Throws
/// lac::Error.
OutageParams read_outages(YamlReader& in);

/// Measurements that come without a valid gate, at random.
///
/// Bursts are a chain of two states with one step per measurement: a burst ends with probability
/// e = interval / mean length and begins with b = e share / (1 - share), so that its length is
/// geometric with the given mean and the share of lost measurements is the given one; the
/// correlation between measurements k apart is (1 - b - e)^k. It starts in its steady state.
class Outages {
 public:
  /// interval_s: from one measurement to the next. Throws lac::Error if bursts are shorter than
  /// that, or so frequent that they would have to begin again before they end.
  Outages(const OutageParams& params, double interval_s, std::uint64_t seed);

  /// Takes away the validity of what is lost. To be called once per measurement, in order.
  void strike(LidarMeasurement& measurement) noexcept;

 private:
  bool next_is_in_burst() noexcept;

  OutageParams params_;
  double ends_;
  double begins_;
  RandomStream single_;
  RandomStream chain_;
  bool in_burst_;
};

}  // namespace lac::sim
