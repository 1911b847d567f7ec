// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/cli/correlate_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_harness/output/text_table.hpp"
#include "sim_harness/tables/csv_table.hpp"
#include "sim_harness/tables/text_number.hpp"

namespace lac::sim {
namespace {

constexpr double kCorrelationBin = 0.05;  // of G18, Table 1
constexpr double kDelayBin_s = 1.0;
constexpr double kHighCoherence = 0.4;  // the level G18 reads off
constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr OperatingMode kModes[] = {OperatingMode::kBelowRated, OperatingMode::kAboveRated,
                                    OperatingMode::kMixed};

struct Class {
  OperatingMode mode;
  double from_intensity;
  double to_intensity;
  std::string name;
};

std::vector<Class> classes_of(double limit) {
  std::vector<Class> classes;
  for (const OperatingMode mode : kModes) {
    classes.push_back({mode, 0.0, kUnlimited, "all"});
    classes.push_back({mode, 0.0, limit, "below " + format_value(limit, 2)});
    classes.push_back({mode, limit, kUnlimited, "from " + format_value(limit, 2)});
  }
  return classes;
}

std::vector<InflowWindow> windows_in(const Class& c, const std::vector<InflowWindow>& all) {
  std::vector<InflowWindow> found;
  std::ranges::copy_if(all, std::back_inserter(found), [&](const InflowWindow& w) {
    return w.mode == c.mode && w.intensity >= c.from_intensity && w.intensity < c.to_intensity;
  });
  return found;
}

template <class Value>
std::vector<double> values_of(const std::vector<InflowWindow>& windows, Value&& value) {
  std::vector<double> values;
  std::ranges::transform(windows, std::back_inserter(values), value);
  return values;
}

std::string range_text(double from, double to, int decimals) {
  return format_value(from, decimals) + "-" + format_value(to, decimals);
}

double delay_of(const InflowWindow& w) {
  return w.peak.delay_s;
}

void add_row(const std::string& wind, const Class& c, const std::vector<InflowWindow>& windows,
             TextTable& table) {
  const Typical rho =
      typical(values_of(windows, [](const InflowWindow& w) { return w.peak.correlation; }),
              kCorrelationBin);
  std::vector<InflowWindow> inside;
  std::ranges::copy_if(windows, std::back_inserter(inside),
                       [](const InflowWindow& w) { return !w.peak.at_edge; });
  const Typical delay_s = typical(values_of(inside, delay_of), kDelayBin_s);
  const Typical time_s =
      typical(values_of(windows, [](const InflowWindow& w) { return w.time_scale_s; }), 1.0);
  const Typical length_m =
      typical(values_of(windows, [](const InflowWindow& w) { return w.length_scale_m; }), 10.0);
  table.add_row({wind, text_of(c.mode), c.name, std::to_string(windows.size()),
                 format_value(rho.median, 2), range_text(rho.lower_quartile, rho.upper_quartile, 2),
                 range_text(rho.bin_from, rho.bin_to, 2), percent_text(rho.bin_share, 0),
                 format_value(delay_s.median, 1), range_text(delay_s.bin_from, delay_s.bin_to, 0),
                 percent_text(delay_s.bin_share, 0), std::to_string(windows.size() - inside.size()),
                 format_value(time_s.median, 1), format_value(length_m.median, 0)});
}

std::string decay_text(const ModeCoherence& c, double range_m) {
  const DecayFit plain = c.decay(range_m);
  return "; decay " + format_significant(plain.decay, 3) + " (residual " +
         format_value(plain.residual, 3) + "), scaled with turbulence intensity " +
         format_significant(c.scaled_decay(range_m).decay, 3);
}

std::string text_of(const ModeCoherence& c, double range_m, double confidence) {
  const CrossSpectrum& s = c.spectrum;
  const Band band =
      coherence_band(std::span(s.coherence).first(1), s.independent_blocks, confidence);
  const double fall_hz = c.fall_hz(kHighCoherence);
  std::string text = std::to_string(c.blocks) + " blocks (worth " +
                     format_value(s.independent_blocks, 1) + "), U " +
                     format_value(c.speed_mps, 1) + " m/s; coherence " +
                     format_value(s.coherence[0], 2) + " (" + format_value(band.low[0], 2) +
                     " to " + format_value(band.high[0], 2) + ") at " +
                     format_significant(s.frequency_hz[0], 2) + " Hz, by chance below " +
                     format_value(coherence_by_chance(s.independent_blocks, confidence), 2);
  text += std::isfinite(fall_hz)
              ? "; falls to 0.4 at " + format_significant(fall_hz, 3) + " Hz, wavelength " +
                    format_value(c.speed_mps / fall_hz, 0) + " m"
              : "; does not fall through 0.4";
  return range_m > 0.0 ? text + decay_text(c, range_m) : text;
}

}  // namespace

std::string relation_table(const std::vector<WindRelation>& relations, double intensity_limit) {
  TextTable table({"wind", "mode", "TI", "windows", "rho", "quartiles", "most in", "share",
                   "delay s", "most in", "share", "at edge", "T s", "L m"});
  for (const WindRelation& r : relations) {
    for (const Class& c : classes_of(intensity_limit)) {
      const std::vector<InflowWindow> windows = windows_in(c, r.windows.windows);
      if (!windows.empty()) add_row(r.wind, c, windows, table);
    }
  }
  return table.text();
}

std::string coherence_lines(const std::vector<WindRelation>& relations, double confidence) {
  std::string lines;
  for (const WindRelation& r : relations) {
    for (const CoherenceOfMode& m : r.modes) {
      lines += r.wind + ", " + text_of(m.mode) + ": " +
               (m.coherence ? text_of(*m.coherence, r.range_m, confidence)
                            : "no two blocks for a coherence") +
               "\n";
    }
  }
  return lines;
}

std::string windows_csv(const std::vector<WindRelation>& relations) {
  std::string text =
      csv_line({"wind", "mode", "start [s]", "speed [m/s]", "intensity [-]", "correlation [-]",
                "delay [s]", "at_edge", "time_scale [s]", "length_scale [m]"});
  for (const WindRelation& r : relations) {
    for (const InflowWindow& w : r.windows.windows) {
      text += csv_line({r.wind, text_of(w.mode), csv_number(w.start_s), csv_number(w.speed_mps),
                        csv_number(w.intensity), csv_number(w.peak.correlation),
                        csv_number(w.peak.delay_s), w.peak.at_edge ? "1" : "0",
                        csv_number(w.time_scale_s), csv_number(w.length_scale_m)});
    }
  }
  return text;
}

std::string spectra_csv(const std::vector<WindRelation>& relations, double confidence) {
  std::string text = csv_line({"wind", "mode", "frequency [Hz]", "wind_density", "wind_low",
                               "wind_high", "load_density", "load_low", "load_high", "coherence",
                               "coherence_low", "coherence_high"});
  for (const WindRelation& r : relations) {
    for (const CoherenceOfMode& m : r.modes) {
      if (!m.coherence) continue;
      const CrossSpectrum& s = m.coherence->spectrum;
      const Band wind = density_band(s.density_x, s.independent_blocks, confidence);
      const Band load = density_band(s.density_y, s.independent_blocks, confidence);
      const Band both = coherence_band(s.coherence, s.independent_blocks, confidence);
      for (std::size_t k = 0; k < s.frequency_hz.size(); ++k) {
        std::vector<std::string> cells{r.wind, text_of(m.mode)};
        for (const double x :
             {s.frequency_hz[k], s.density_x[k], wind.low[k], wind.high[k], s.density_y[k],
              load.low[k], load.high[k], s.coherence[k], both.low[k], both.high[k]})
          cells.push_back(csv_number(x));
        text += csv_line(cells);
      }
    }
  }
  return text;
}

}  // namespace lac::sim
