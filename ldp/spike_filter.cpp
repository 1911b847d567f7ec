// SPDX-License-Identifier: Apache-2.0
#include "ldp/spike_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lac {
namespace {

constexpr double kPerDeviation = 1.4826;  // MAD of a normal distribution to its standard deviation
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Few values: sorted by insertion.
class Few {
 public:
  void add(double v) noexcept {
    if (std::isnan(v)) return;
    std::size_t i = count_++;
    for (; i > 0 && values_[i - 1] > v; --i) values_[i] = values_[i - 1];
    values_[i] = v;
  }
  std::size_t count() const { return count_; }
  double median() const { return 0.5 * (values_[(count_ - 1) / 2] + values_[count_ / 2]); }
  Few distances_from(double middle) const noexcept {
    Few f;
    for (std::size_t i = 0; i < count_; ++i) f.add(std::abs(values_[i] - middle));
    return f;
  }

 private:
  std::array<double, 2 * SpikeFilter::kPast> values_{};
  std::size_t count_ = 0;
};

}  // namespace

SpikeFilterParams SpikeFilterParams::read(InputFile& in) {
  SpikeFilterParams p;
  p.limit = in.number("SpikeLimit", p.limit, Range::between(0.0, 100.0));
  if (p.limit > 0.0) p.floor_mps = in.number("SpikeFloor", p.floor_mps, Range::positive());
  return p;
}

SpikeFilter::State SpikeFilter::initial_state() const {
  State s;
  if (!active()) return s;
  Past none;
  none.fill(kNone);
  s.past.assign(native_lidar::kMaxGates, none);
  return s;
}

bool SpikeFilter::is_spike(double wind_mps, std::size_t gate, std::size_t gates,
                           const State& state) const noexcept {
  Few around;
  for (const double v : state.past[gate]) around.add(v);
  if (gate + kBehind < gates) {
    for (const double v : state.past[gate + kBehind]) around.add(v);
  }
  if (around.count() < kFewest) return false;
  const double median_mps = around.median();
  const double deviation_mps =
      std::max(kPerDeviation * around.distances_from(median_mps).median(), params_.floor_mps);
  return std::abs(wind_mps - median_mps) > params_.limit * deviation_mps;
}

void SpikeFilter::forget(State& state) const noexcept {
  for (Past& past : state.past) past.fill(kNone);
}

int SpikeFilter::clean(std::span<double> wind_mps, State& state) const noexcept {
  int found = 0;
  for (std::size_t g = 0; g < wind_mps.size(); ++g) {
    const bool spike = !std::isnan(wind_mps[g]) && is_spike(wind_mps[g], g, wind_mps.size(), state);
    state.past[g][state.next] = wind_mps[g];
    if (!spike) continue;
    wind_mps[g] = kNone;
    ++found;
  }
  for (std::size_t g = wind_mps.size(); g < state.past.size(); ++g) {
    state.past[g][state.next] = kNone;
  }
  state.next = (state.next + 1) % kPast;
  return found;
}

}  // namespace lac
