#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Independent figures for the test of ti_estimator/correction: c_TI by brute-force integration.

    python -m venv venv && venv/bin/pip install scipy
    venv/bin/python python/check_c_ti.py

Nothing is shared with the C++ sources, neither code nor formula: the volume response is the double
integral over the two points of the range weighting, not its closed form, and the integral over
frequency is SciPy's adaptive one. Mann: the tensor of turbulence_models.py, integrated over k2, k3 in
polar coordinates.
"""

import numpy as np
from scipy.integrate import quad
from scipy.special import wofz

from turbulence_models import Mann

LENGTHS_M = np.array([8.1, 2.7, 0.66]) * 42.0
SIGMAS = np.array([1.0, 0.8, 0.5])
COHERENCE_LENGTH_M = 340.2
DECAY = 12.0


def beam(azimuth_deg, elevation_deg):
    a, e = np.radians([azimuth_deg, elevation_deg])
    return np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])


def in_wind(n, psi_deg):
    c, s = np.cos(np.radians(psi_deg)), np.sin(np.radians(psi_deg))
    return np.array([c * n[0] + s * n[1], -s * n[0] + c * n[1], n[2]])


def response(f, speed, n, width_m):
    """H^2 by the double integral, midpoint rule along a diagonal grid of +-7 sigma."""
    sigma = width_m / np.sqrt(8.0 * np.log(2.0))
    kappa = DECAY * np.hypot(n[1], n[2]) * np.hypot(f / speed, 0.12 / COHERENCE_LENGTH_M)
    k = 2.0 * np.pi * f / speed * abs(n[0])
    r, step = np.linspace(-7.0 * sigma, 7.0 * sigma, 2001, retstep=True)
    phi = np.exp(-0.5 * (r / sigma) ** 2) / (sigma * np.sqrt(2.0 * np.pi))
    lag = np.arange(len(r)) * step
    # sum over all pairs with the same distance, then over the distances; trapezoid with the
    # second-order end correction at the kink of exp(-kappa |d|) in d = 0
    pairs = np.array([np.dot(phi[: len(r) - i], phi[i:]) for i in range(len(r))]) * step
    g = pairs * np.cos(k * lag) * np.exp(-kappa * lag)
    return 2.0 * step * (np.sum(g) - 0.5 * g[0]) - step**2 / 6.0 * kappa * pairs[0]


def spectrum(f, speed, c):
    t = LENGTHS_M[c] / speed
    return 4.0 * SIGMAS[c] ** 2 * t / (1.0 + 6.0 * f * t) ** (5.0 / 3.0)


def c_ti(n, speed, period_s, scan_hz, max_hz, width_m):
    def los(x):
        f = np.exp(x)
        total = sum(n[c] ** 2 * spectrum(f, speed, c) for c in range(3))
        return f * total * response(f, speed, n, width_m)

    def longitudinal(x):
        return np.exp(x) * spectrum(np.exp(x), speed, 0)

    low = np.log(1.0 / period_s)
    var_los = quad(los, low, np.log(scan_hz), epsrel=1e-9, limit=200)[0]
    var_u = quad(longitudinal, low, np.log(max_hz), epsrel=1e-11, limit=200)[0]
    return np.sqrt(var_u / var_los)


def mann_spectra(model, k1, beams, sigma_m, radii=241, angles=720):
    """F_los of each beam (x down-wind) and F_u at k1, two-sided."""
    low, high = 1e-4 * min(k1, 1.0 / model.length), 1e3 * (1.0 / model.length + k1)
    rho = np.exp(np.linspace(np.log(low), np.log(high), radii))[:, None]
    theta = (np.arange(angles) + 0.5) * 2.0 * np.pi / angles
    k2, k3 = rho * np.cos(theta), rho * np.sin(theta)
    area = rho**2 * np.log(high / low) / (radii - 1) * 2.0 * np.pi / angles
    phi = model.tensor(k1, k2, k3)
    spectra = []
    for n in beams:
        along = sum(n[i] * n[j] * phi[i][j] for i in range(3) for j in range(3))
        spectra.append(np.sum(area * along * np.exp(-((sigma_m * (k1 * n[0] + k2 * n[1] + k3 * n[2]))
                                                      ** 2))))
    return np.array([*spectra, np.sum(area * phi[0][0])])


def mann_c_ti(model, beams, speed, period_s, scan_hz, max_hz, width_m):
    """c_TI of each beam (x down-wind), nothing below 1/T; v_los up to scan_hz, u up to max_hz."""
    sigma_m = width_m / np.sqrt(8.0 * np.log(2.0))
    f = np.exp(np.linspace(np.log(1.0 / period_s), np.log(max_hz), 121))
    table = np.array([mann_spectra(model, 2.0 * np.pi * x / speed, beams, sigma_m) for x in f])
    fine = np.exp(np.linspace(np.log(f[0]), np.log(f[-1]), 20001))

    def variance(column, upper):
        density = fine * np.exp(np.interp(np.log(fine), np.log(f), np.log(table[:, column])))
        return np.trapezoid(np.where(fine <= upper, density, 0.0), np.log(fine))

    return [np.sqrt(variance(-1, max_hz) / variance(i, scan_hz)) for i in range(len(beams))]


def main():
    print("Re w(1+1i), w(3+0.1i), w(0.02+7i):", wofz([1 + 1j, 3 + 0.1j, 0.02 + 7j]).real)
    n = beam(15.0, 12.5)
    print("H^2 at 0.1 Hz, 16 m/s, 30 m:", response(0.1, 16.0, n, 30.0))
    for speed, psi, period in [(16.0, 0.0, 600.0), (16.0, 10.0, 180.0), (6.0, -20.0, 180.0)]:
        value = c_ti(in_wind(n, psi), speed, period, 1.0, 10.0, 30.0)
        print(f"c_TI(15, 12.5 deg; {speed} m/s, psi {psi} deg, T {period} s) = {value:.8f}")
    iec = Mann(1.0, 33.6, 3.9, lifetime="mann")
    up, down = (np.array([-n[0], -n[1], z]) for z in (n[2], -n[2]))
    for length in (33.6, 61.0):
        iec.length = length
        values = mann_c_ti(iec, [up, down], 16.0, 180.0, 1.0, 10.0, 30.0)
        print(f"Mann, L {length} m, T 180 s: c_TI looking up {values[0]:.5f}, down {values[1]:.5f}")
    print("Mann, IEC: F of the two beams and of u at 0.02 and 0.5 rad/m:",
          *(mann_spectra(Mann(1.0, 33.6, 3.9, lifetime="mann"), k, [up, down], 12.7398)
            for k in (0.02, 0.5)))


if __name__ == "__main__":
    main()
