// SPDX-License-Identifier: Apache-2.0
// What a chain takes for the turbulence intensity, against that of the rotor.
#pragma once

#include <string>
#include <vector>

#include "sim_harness/run/report.hpp"
#include "sim_harness/wind/rotor_signals.hpp"

namespace lac::sim {

/// Rotor-averaged turbulence intensity TI_R [-] (rotor_signals()), as in `<case>.wind.outb`.
inline constexpr const char* kRotorIntensityChannel = "RtTI";

/// The recording of a flight with TI_R as a channel more, and one more "<record>Err" [-] for each
/// of the records TurbulenceIntensity, -Uncorrected, -Anemometer, -Turbine in the chain's own
/// output file: the estimate less TI_R lead_s later, when the wind that a lidar has seen passes the
/// rotor. Series of another step are held; NaN where one of the two is unknown.
Recording with_rotor_intensity(const FlownController& flown, const RotorSignals& rotor,
                               double lead_s = 0.0);

/// One estimate of one flight over the samples behind the run-in at which it is known.
struct IntensityError {
  std::string estimate;             // its record
  double known = 0.0;               // share of the samples at which there is TI_R lead_s later
  double rotor_mean = 0.0;          // of TI_R lead_s later
  double bias = 0.0;                // mean error
  double standard_deviation = 0.0;  // of the error, n - 1
  double largest = 0.0;             // |error|
};
/// Of a recording of with_rotor_intensity() with this rotor and lead. Fewer than two samples: NaN.
std::vector<IntensityError> intensity_errors(const Recording& recording, const RotorSignals& rotor,
                                             double run_in_s, double lead_s = 0.0);

/// The table for the terminal, in percent of intensity (absolute).
std::string intensity_table(const std::vector<FlownController>& flights, const RotorSignals& rotor,
                            double run_in_s, double window_s, double lead_s = 0.0);

}  // namespace lac::sim
