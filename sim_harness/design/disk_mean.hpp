// SPDX-License-Identifier: Apache-2.0
// Means of the coherence exp(-c r) over a rotor disk.
#pragma once

namespace lac::sim {

/// Mean over a disk of exp(-rate r), r from a point at this distance from its centre (inside or
/// outside). With F(r) = 1/c^2 (1 - (1 + c r) e^(-c r)) and integration by parts it is
///
///   2/(pi R^2) ∫_0^pi F(r) (r^2 + R^2 - d^2) / (r sqrt((r + |R - d|)(r + R + d))) dt,
///   r = (R + d + |R - d|)/2 - (R + d - |R - d|)/2 cos t,
///
/// smooth and even in t at both ends: the midpoint rule with 48 points leaves 1e-7. rate >= 0.
double disk_mean(double rate_per_m, double radius_m, double distance_m);

/// Mean over all pairs of points of a disk: disk line picking (methods section 4), to 1e-8.
double disk_mean_of_pairs(double rate_per_m, double radius_m);

}  // namespace lac::sim
