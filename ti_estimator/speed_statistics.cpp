// SPDX-License-Identifier: Apache-2.0
#include "ti_estimator/speed_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace lac {
namespace {

constexpr double kSpareRows = 1.25;  // a lidar may be that much faster than ScanTime
constexpr double kFewestWeights = 2.0;

}  // namespace

int StatisticsSpec::needed_samples() const {
  const int fewest = detrending == Detrending::Linear ? 3 : 2;
  return std::max(fewest, static_cast<int>(std::ceil(minimum_fill * expected_samples() - 1e-9)));
}

SpeedStatistics::SpeedStatistics(const StatisticsSpec& spec)
    : spec_(spec), needed_samples_(spec.needed_samples()) {
  if (exponential()) {
    fading_ = ExponentialWindow(spec.beams, spec.gates, spec.window_s, spec.scan_time_s);
    return;
  }
  const double rows = kSpareRows * spec.beams * spec.expected_samples() + 2.0 * spec.beams;
  sliding_ = SampleWindow(spec.beams, spec.gates, static_cast<int>(rows), spec.window_s);
}

SpeedStatistics::Series SpeedStatistics::series(int beam, int gate, double time_s) const noexcept {
  if (exponential()) {
    const ExponentialMoments& s = fading_.series(beam, gate);
    const double needed = std::max(kFewestWeights, spec_.minimum_fill * fading_.full_weight());
    if (fading_.weight(beam, gate, time_s) < needed) return {};
    return {true, s.mean(), std::sqrt(s.variance())};
  }
  const TrendMoments& s = sliding_.series(beam, gate);
  if (s.speeds().count() < needed_samples_) return {};
  const double variance =
      spec_.detrending == Detrending::Linear ? s.variance_about_trend() : s.speeds().variance();
  return {true, s.speeds().mean_mps(), std::sqrt(variance)};
}

}  // namespace lac
