// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace lac {

/// Mean root coherence exp(-c r) of two random points of a disk, r their distance: spectrum of the
/// mean over the rotor over that of one point, for the exponential coherence of IEC. With
/// r = 2 R cos t and the distribution of r between two points of a disk
///   D = 16/pi  int_0^(pi/2) sin t cos t (t - sin t cos t) exp(-2 c R cos t) dt,
/// Gauss-Legendre, relative error below 1e-9. `rate_radius` = c R >= 0 [-]: D = 1 - 0.905 c R for
/// small ones, 2 / (c R)^2 for large ones.
double disk_coherence(double rate_radius) noexcept;

}  // namespace lac
