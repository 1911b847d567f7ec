// SPDX-License-Identifier: Apache-2.0
// The low-pass of the feedforward beside the optimal (Wiener) filter.
#pragma once

#include "sim_harness/design/correlation_curve.hpp"

namespace lac::sim {

/// A low-pass as FFP runs it; order 1: w_c/(s + w_c), order 2: w_0^2/(s^2 + 2 z w_0 s + w_0^2).
struct LowPassDesign {
  int order = 1;
  double frequency_hz = 0.0;
  double damping = 0.0;  // of order 2
};

double gain_of(const LowPassDesign& filter, double frequency_hz);

/// Its delay [s] at a frequency, which FFP makes up for with the buffer.
double delay_s(const LowPassDesign& filter, double frequency_hz);

/// Share of the variance of the rotor-effective wind speed that is left when the filtered estimate,
/// brought forward by the filter's delay T at the delay frequency, is taken off,
///
///   int S_RR (1 - gamma^2) + S_LL |H e^(i 2 pi f T) - |G_RL||^2 df / int S_RR df,
///
/// over the range of the curve (below it both are the same). The first term is that of the Wiener
/// filter. The estimate's own lateness is left out, as if the buffer was trimmed for it.
double share_left(const CorrelationCurve& curve, const LowPassDesign& filter,
                  double delay_frequency_hz);
double share_left_of_wiener(const CorrelationCurve& curve);

/// The low-pass of order 1 or 2 that leaves least, among those that delay the delay frequency by
/// `longest_delay_s` at most: the lead there is is all it can use. Damping 0.5 to 1.5, frequency
/// within the curve; the end of the curve if nothing there is as quick.
LowPassDesign fit_low_pass(int order, const CorrelationCurve& curve, double delay_frequency_hz,
                           double longest_delay_s);

}  // namespace lac::sim
