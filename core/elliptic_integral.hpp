// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lac {

/// Bulirsch's general complete elliptic integral (Numerische Mathematik 13, 1969),
///
///   cel(kc, p, a, b) = integral from 0 to pi/2 of
///                      (a cos^2 + b sin^2) / ((cos^2 + p sin^2) sqrt(cos^2 + kc^2 sin^2)) dphi
///
/// by his iteration of the arithmetic-geometric mean; relative error about 1e-14. With the
/// parameter m = 1 - kc^2: K(m) = cel(kc, 1, 1, 1), E(m) = cel(kc, 1, 1, kc^2),
/// Pi(n | m) = cel(kc, 1 - n, 1, 1). Precondition: kc > 0, p > 0.
double complete_elliptic_integral(double kc, double p, double a, double b) noexcept;

}  // namespace lac
