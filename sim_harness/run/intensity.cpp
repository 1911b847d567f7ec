// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/run/intensity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/swap_view.hpp"
#include "sim_harness/analysis/statistics.hpp"
#include "sim_harness/output/text_table.hpp"

namespace lac::sim {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kRounding = 1e-6;  // of a step
constexpr std::array<Rec, 4> kEstimates{Rec::TurbulenceIntensity, Rec::TurbulenceUncorrected,
                                        Rec::TurbulenceAnemometer, Rec::TurbulenceTurbine};
constexpr const char* kErrorEnding = "Err";

/// A series whose values hold until the next one.
struct Held {
  std::vector<double> values;
  double start_s = 0.0;
  double step_s = 1.0;

  double at(double time_s) const {
    const double steps = std::floor((time_s - start_s) / step_s + kRounding);
    return steps >= 0.0 && steps < static_cast<double>(values.size())
               ? values[static_cast<std::size_t>(steps)]
               : kNaN;
  }
};

Held rotor_intensity(const RotorSignals& rotor) {
  return {rotor.intensity, rotor.t_begin_s, rotor.dt_s};
}

bool has_channel(const Recording& r, const std::string& name) {
  return std::ranges::find(r.channels(), name, &TableChannel::name) != r.channels().end();
}

struct Estimate {
  std::string name;
  Held intensity;
};

std::vector<Estimate> estimates_in(const FlownController& flown) {
  std::vector<Estimate> found;
  if (!flown.chain_output) return found;
  const Recording& chain = *flown.chain_output;
  for (const Rec record : kEstimates) {
    const std::string name{find_record(static_cast<int>(record))->name};
    if (!has_channel(chain, name)) continue;
    found.push_back({name, {chain.column(name), chain.start_time_s(), chain.time_step_s()}});
  }
  return found;
}

/// `rotor`: what each error counts from.
IntensityError error_of(const std::string& estimate, std::span<const double> rotor,
                        std::span<const double> errors) {
  std::vector<double> known;
  double rotor_sum = 0.0;
  std::size_t references = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (std::isfinite(rotor[i])) ++references;
    if (!std::isfinite(errors[i])) continue;
    known.push_back(errors[i]);
    rotor_sum += rotor[i];
  }
  if (known.size() < 2) return {estimate, 0.0, kNaN, kNaN, kNaN, kNaN};
  const Statistics s = statistics(known);
  const auto n = static_cast<double>(known.size());
  return {estimate,
          n / static_cast<double>(references),
          rotor_sum / n,
          s.mean,
          s.standard_deviation,
          std::max(s.max, -s.min)};
}

}  // namespace

Recording with_rotor_intensity(const FlownController& flown, const RotorSignals& rotor,
                               double lead_s) {
  const Recording& flight = flown.recording;
  const std::vector<Estimate> estimates = estimates_in(flown);
  const Held reference = rotor_intensity(rotor);
  std::vector<TableChannel> channels = flight.channels();
  channels.push_back({kRotorIntensityChannel, "-"});
  for (const Estimate& e : estimates) channels.push_back({e.name + kErrorEnding, "-"});

  Recording result(channels, flight.start_time_s(), flight.time_step_s(), flight.rows());
  std::vector<float> row(channels.size());
  for (std::size_t i = 0; i < flight.rows(); ++i) {
    const double time_s = flight.start_time_s() + static_cast<double>(i) * flight.time_step_s();
    auto next = std::ranges::copy(flight.row(i), row.begin()).out;
    const double later = reference.at(time_s + lead_s);
    *next++ = static_cast<float>(reference.at(time_s));
    for (const Estimate& e : estimates)
      *next++ = static_cast<float>(e.intensity.at(time_s) - later);
    result.append(row.data());
  }
  return result;
}

std::vector<IntensityError> intensity_errors(const Recording& recording, const RotorSignals& rotor,
                                             double run_in_s, double lead_s) {
  const std::size_t first = recording.first_row_from(run_in_s);
  const Held reference = rotor_intensity(rotor);
  std::vector<double> later;
  for (std::size_t i = first; i < recording.rows(); ++i)
    later.push_back(reference.at(recording.start_time_s() +
                                 static_cast<double>(i) * recording.time_step_s() + lead_s));
  std::vector<IntensityError> errors;
  for (const Rec record : kEstimates) {
    const std::string name{find_record(static_cast<int>(record))->name};
    if (!has_channel(recording, name + kErrorEnding)) continue;
    const std::vector<double> column = recording.column(name + kErrorEnding);
    errors.push_back(error_of(name, later, std::span(column).subspan(first)));
  }
  return errors;
}

std::string intensity_table(const std::vector<FlownController>& flights, const RotorSignals& rotor,
                            double run_in_s, double window_s, double lead_s) {
  constexpr double kPercent = 100.0;
  TextTable table({"Turbulence intensity", "estimate", "known [%]", "rotor [%]", "bias [%]",
                   "std [%]", "largest [%]"});
  for (const FlownController& flown : flights) {
    for (const IntensityError& e : intensity_errors(flown.recording, rotor, run_in_s, lead_s)) {
      table.add_row({flown.name, e.estimate, format_value(kPercent * e.known, 1),
                     format_value(kPercent * e.rotor_mean, 2), format_value(kPercent * e.bias, 3),
                     format_value(kPercent * e.standard_deviation, 3),
                     format_value(kPercent * e.largest, 3)});
    }
  }
  std::ostringstream note;
  note << "rotor: mean over the disk of standard deviations over " << window_s
       << " s, over the mean of the means; error: estimate less that, [%] of intensity\n";
  return table.text() + note.str();
}

}  // namespace lac::sim
