// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/correlate_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "core/units.hpp"
#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/time_series.hpp"

namespace lac::sim {
namespace {

constexpr double kRounding = 1e-6;  // of a sample
constexpr double kKilo = 1e-3;

class Sources {
 public:
  explicit Sources(const CorrelateInput& input) : input_(input) {
    for (const auto& file : input.files) {
      recordings_.push_back(read_time_series(file, MissingRows::kNotNumbers));
      const Recording& r = recordings_.back();
      start_s_ = std::max(start_s_, r.start_time_s());
      end_s_ = std::min(end_s_, r.start_time_s() + static_cast<double>(r.rows()) * r.time_step_s());
    }
    if (!(end_s_ > start_s_)) throw Error("correlate: the files have no time in common");
    if (!(end_s_ > input.from_s)) {
      throw Error("correlate: --from " + format_value(input.from_s, 2) +
                  " s is beyond the common time of the files, " + format_value(start_s_, 2) +
                  " to " + format_value(end_s_, 2) + " s");
    }
    start_s_ = std::max(start_s_, input.from_s);
  }

  double start_s() const { return start_s_; }
  const Recording& holder_of(const std::string& channel) const {
    std::vector<std::string> known;
    for (const Recording& r : recordings_) {
      for (const TableChannel& c : r.channels()) {
        if (c.name == channel) return r;
        known.push_back(c.name);
      }
    }
    throw Error("correlate: no file has a channel '" + channel + "'" +
                did_you_mean(channel, known));
  }
  /// In the common time, at the rate of its file.
  std::vector<double> column(const std::string& channel) const {
    const Recording& r = holder_of(channel);
    const std::vector<double> all = r.column(channel);
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(r.first_row_from(start_s_));
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(r.first_row_from(end_s_));
    return {first, end};
  }
  double step_s(const std::string& channel) const { return holder_of(channel).time_step_s(); }
  std::vector<double> at_common_rate(const std::string& channel,
                                     const std::vector<double>& series) const {
    const double samples = 1.0 / (input_.rate_hz * step_s(channel));
    const double whole = std::round(samples);
    if (whole < 1.0 || std::abs(samples - whole) > kRounding * whole) {
      throw Error("correlate: --rate " + std::to_string(input_.rate_hz) + " Hz is " +
                  std::to_string(samples) + " samples of '" + channel +
                  "', expected a whole number");
    }
    return block_means(series, static_cast<std::size_t>(whole));
  }
  void require_unit(const std::string& channel, const std::string& expected) const {
    for (const TableChannel& c : holder_of(channel).channels()) {
      if (c.name == channel && c.unit != expected)
        throw Error("correlate: '" + channel + "' is in [" + c.unit + "], expected [" + expected +
                    "] with --inertia");
    }
  }
  std::vector<double> ready(const std::string& channel) const {
    return at_common_rate(channel, column(channel));
  }

 private:
  const CorrelateInput& input_;
  std::vector<Recording> recordings_;
  double start_s_ = -std::numeric_limits<double>::infinity();
  double end_s_ = std::numeric_limits<double>::infinity();
};

/// Per second, by central differences; at the ends by the one step there is.
std::vector<double> rate_of(const std::vector<double>& x, double step_s) {
  std::vector<double> rate(x.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, x.size() - 1);
    if (after > before)
      rate[i] = (x[after] - x[before]) / (step_s * static_cast<double>(after - before));
  }
  return rate;
}

std::vector<double> load_of(const Sources& sources, const CorrelateInput& input) {
  std::vector<double> load = sources.ready(input.load);
  const TorqueAtRotor& t = input.torque;
  if (t.inertia_kgm2 == 0.0) return load;
  sources.require_unit(input.load, "kNm");
  sources.require_unit(t.rotor_speed, "rpm");
  const std::vector<double> rate_rpmps = sources.at_common_rate(
      t.rotor_speed, rate_of(sources.column(t.rotor_speed), sources.step_s(t.rotor_speed)));
  load.resize(std::min(load.size(), rate_rpmps.size()));
  for (std::size_t i = 0; i < load.size(); ++i)
    load[i] = t.gear_ratio * load[i] + kKilo * t.inertia_kgm2 * radps_from_rpm(rate_rpmps[i]);
  return load;
}

void cut_to_shortest(InflowSeries& s) {
  const std::size_t n = std::min({s.wind.size(), s.load.size(), s.power.size(), s.pitch.size()});
  for (std::vector<double>* series : {&s.wind, &s.load, &s.power, &s.pitch}) series->resize(n);
}

}  // namespace

CorrelatedSeries read_correlated(const CorrelateInput& input) {
  const Sources sources(input);
  InflowSeries common;
  common.start_s = sources.start_s();
  common.time_step_s = 1.0 / input.rate_hz;
  common.load = load_of(sources, input);
  common.power = sources.ready(input.power);
  common.pitch = sources.ready(input.pitch);
  CorrelatedSeries result;
  for (const std::string& name : input.winds) {
    std::vector<double> wind = sources.column(name);
    result.dropped.push_back(input.companion.empty()
                                 ? 0
                                 : drop_by_companion(wind, sources.column(input.companion),
                                                     input.companion_min, input.companion_max));
    result.quality.push_back(clean(wind, sources.step_s(name), input.wind_rule));
    result.of_wind.push_back(common);
    result.of_wind.back().wind = sources.at_common_rate(name, wind);
    cut_to_shortest(result.of_wind.back());
  }
  return result;
}

}  // namespace lac::sim
