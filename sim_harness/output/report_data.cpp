// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/output/report_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim_harness/output/page_parts.hpp"

namespace lac::sim {
namespace {

constexpr double kHighestLevel = 65534.0;
constexpr std::uint16_t kMissing = 65535;

std::string number(double value, int digits) {
  return std::isfinite(value) ? json_number(value, digits) : "0";
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const std::uint32_t group = (static_cast<std::uint32_t>(bytes[i]) << 16) |
                                (left > 1 ? static_cast<std::uint32_t>(bytes[i + 1]) << 8 : 0U) |
                                (left > 2 ? bytes[i + 2] : 0U);
    text += kDigits[group >> 18];
    text += kDigits[(group >> 12) & 63U];
    text += left > 1 ? kDigits[(group >> 6) & 63U] : '=';
    text += left > 2 ? kDigits[group & 63U] : '=';
  }
  return text;
}

struct Extremes {
  double low = 0.0;
  double high = 0.0;
};

Extremes finite_extremes(std::span<const double> values) {
  Extremes found;
  bool first = true;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    found.low = first ? v : std::min(found.low, v);
    found.high = first ? v : std::max(found.high, v);
    first = false;
  }
  return found;
}

std::string levels(std::span<const double> values, const Extremes& extremes) {
  const double range = extremes.high - extremes.low;
  const double scale = range > 0.0 ? kHighestLevel / range : 0.0;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * values.size());
  for (const double v : values) {
    const auto level = std::isfinite(v)
                           ? static_cast<std::uint16_t>(std::lround((v - extremes.low) * scale))
                           : kMissing;
    bytes.push_back(static_cast<std::uint8_t>(level & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>(level >> 8));
  }
  return base64(bytes);
}

std::string trace_json(const ReportTrace& trace, std::size_t factor) {
  const std::vector<double> values = thinned(trace.values, factor);
  const Extremes extremes = finite_extremes(values);
  return "{\"name\":" + json_text(trace.name) + ",\"run\":" + std::to_string(trace.run) +
         ",\"low\":" + number(extremes.low, 17) + ",\"high\":" + number(extremes.high, 17) +
         ",\"data\":\"" + levels(values, extremes) + "\"}";
}

std::string spectrum_json(const ReportSpectrum& spectrum) {
  const auto short_number = [](double v) { return number(v, 5); };
  return "{\"name\":" + json_text(spectrum.name) + ",\"run\":" + std::to_string(spectrum.run) +
         ",\"f\":" + json_array(spectrum.frequency_hz, short_number) +
         ",\"s\":" + json_array(spectrum.density, short_number) + "}";
}

template <typename Panel, typename ToText>
std::string panel_json(const Panel& panel, ToText series_text) {
  return "{\"title\":" + json_text(panel.title) + ",\"unit\":" + json_text(panel.unit) +
         ",\"series\":" + json_array(panel.series, series_text) + "}";
}

std::size_t samples_per_trace(const HtmlReport& report) {
  for (const ReportTracePanel& panel : report.traces) {
    if (!panel.series.empty()) return panel.series.front().values.size();
  }
  return 0;
}

}  // namespace

std::size_t thinning_factor(const HtmlReport& report) {
  const std::size_t most = std::max<std::size_t>(report.most_samples_per_trace, 2);
  return std::max<std::size_t>(1, (samples_per_trace(report) + most - 1) / most);
}

std::vector<double> thinned(std::span<const double> values, std::size_t factor) {
  if (factor <= 1) return {values.begin(), values.end()};
  std::vector<double> kept;
  for (std::size_t begin = 0; begin < values.size(); begin += 2 * factor) {
    const std::size_t end = std::min(values.size(), begin + 2 * factor);
    std::size_t low = end, high = end;
    for (std::size_t i = begin; i < end; ++i) {
      if (!std::isfinite(values[i])) continue;
      if (low == end || values[i] < values[low]) low = i;
      if (high == end || values[i] > values[high]) high = i;
    }
    const bool none = low == end;
    kept.push_back(none ? std::nan("") : values[std::min(low, high)]);
    kept.push_back(none ? std::nan("") : values[std::max(low, high)]);
  }
  return kept;
}

std::string report_json(const HtmlReport& report) {
  const std::size_t factor = thinning_factor(report);
  const std::size_t samples = samples_per_trace(report);
  const std::size_t stored =
      factor == 1 ? samples : 2 * ((samples + 2 * factor - 1) / (2 * factor));
  const auto trace = [&](const ReportTrace& t) { return trace_json(t, factor); };
  return "{\"runs\":" + json_array(report.runs, json_text) +
         ",\"t0\":" + number(report.start_time_s, 17) +
         ",\"dt\":" + number(report.time_step_s * static_cast<double>(factor), 17) +
         ",\"n\":" + std::to_string(stored) + ",\"runIn\":" + number(report.run_in_until_s, 17) +
         ",\"traces\":" +
         json_array(report.traces, [&](const auto& p) { return panel_json(p, trace); }) +
         ",\"spectra\":" +
         json_array(report.spectra, [](const auto& p) { return panel_json(p, spectrum_json); }) +
         "}";
}

}  // namespace lac::sim
