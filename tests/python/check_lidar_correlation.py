# SPDX-License-Identifier: Apache-2.0
"""python/lidar_correlation.py and python/turbulence_models.py against limits, closed forms, the
equations of motion and published numbers. Needs numpy and scipy; without them it ends with exit
code 77: skipped."""

import sys
from dataclasses import replace
from pathlib import Path

try:
    import numpy as np
    from scipy.integrate import trapezoid
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.path.insert(0, str(Path(__file__).parents[2] / "python"))
from lidar_correlation import (Nodes, Setup, crossing, disk_mean, disk_mean_of_pairs, mann_spectra,
                               measuring_points, table)
from turbulence_models import KAIMAL, MANN, Mann, distorted_mode

failures = 0


def compare(what, found, expected, relative):
    global failures
    error = np.max(np.abs(np.asarray(found) / np.asarray(expected) - 1))
    good = error <= relative
    failures += not good
    print(f"{'ok ' if good else 'BAD'} {what}: relative difference {error:.1e} (<= {relative:.0e})")


def check_tensor():
    rng = np.random.default_rng(1)
    m = MANN["neutral"]
    for k in rng.normal(size=(4, 3)) * 0.03:
        beta = float(m.beta(np.linalg.norm(k)))
        k0 = k + [0, 0, beta * k[0]]
        first = np.cross(k0, [1.0, 2.0, 3.0])
        modes = [first / np.linalg.norm(first)]
        modes.append(np.cross(k0 / np.linalg.norm(k0), modes[0]))
        distorted = [distorted_mode(k, beta, mode) for mode in modes]
        kl2 = k0 @ k0 * m.length**2
        energy = m.alpha_epsilon * m.length ** (5 / 3) * kl2**2 / (1 + kl2) ** (17 / 6)
        expected = energy / (4 * np.pi * k0 @ k0) * sum(np.outer(d, d) for d in distorted)
        found = np.array([[float(x) for x in row] for row in m.tensor(*k)])
        compare("tensor, integrated equations of motion", found, expected, 1e-6)
    isotropic = Mann(0.3, 50.0, 1e-9)
    for k1 in (1e-3, 0.05):
        f = isotropic.cross_spectra(k1, [(0, 0, 0, 0, 0), (2, 2, 0, 0, 0)]).real
        power = k1**2 + 50.0**-2
        compare("isotropic spectra", f, [9 / 55 * 0.3 * power ** (-5 / 6), 3 / 110 * 0.3
                * (3 * 50.0**-2 + 8 * k1**2) * power ** (-11 / 6)], 1e-4)


def check_disk():
    rng = np.random.default_rng(2)
    r, angle = 50 * np.sqrt(rng.random(400_000)), 2 * np.pi * rng.random(400_000)
    for distance in (0.0, 30.0, 70.0):
        apart = np.hypot(r * np.cos(angle) - distance, r * np.sin(angle))
        compare("mean over a disk, random points", disk_mean(0.03, 50.0, [distance])[0],
                np.exp(-0.03 * apart).mean(), 3e-3)
    s = np.linspace(0, 2, 20001)  # distances of pairs of points in a disk
    picking = 4 * s / np.pi * np.arccos(s / 2) - 2 * s**2 / np.pi * np.sqrt(1 - s**2 / 4)
    compare("mean over pairs, line picking", disk_mean_of_pairs(0.03, 50.0),
            trapezoid(picking * np.exp(-0.03 * 50 * s), s), 1e-5)


def check_limits():
    point = Setup(radius=0.01, gates=np.array([100.0]), azimuth=(0.0,), elevation=(0.0,), fwhm=0.0,
                  planes="frozen")
    f = np.array([0.005, 0.05])
    rows = table(KAIMAL["neutral"], point, f)
    s_u = KAIMAL["neutral"].spectrum(0, f, 16.0)
    compare("one point in the hub, Kaimal", rows[:, 2:5].T, [s_u] * 3, 1e-3)
    m = MANN["neutral"]
    s_u = [4 * np.pi / 16 * m.cross_spectra(2 * np.pi * x / 16, [(0, 0, 0, 0, 0)]).real[0] for x in f]
    compare("one point in the hub, Mann", table(m, point, f)[:, 2:5].T, [s_u] * 3, 3e-3)
    rows = table(KAIMAL["neutral"], replace(point, planes="gate"), f)
    decay = 1.8 * 100 * np.hypot(f / 16, 1.49e-4)
    compare("one point in evolving wind, gamma^2", rows[:, 5], np.exp(-decay), 2e-3)


def check_forms():
    frequency = 0.06
    closed = Setup(gates=np.array([60.0, 120.0]))
    exact = mann_spectra(MANN["neutral"], closed, None, measuring_points(closed), frequency)
    gridded = replace(closed, grid=(141, 141, 140, 140, 0.0625))
    points = measuring_points(gridded)
    sums = mann_spectra(MANN["neutral"], gridded, Nodes(gridded, points), points, frequency)
    compare("Mann, closed forms and sums over a grid of 1 m", np.abs([sums[1], *sums[0]]),
            np.abs([exact[1], *exact[0]]), 1e-2)


def check_published():
    for stability, f_c in (("unstable", 0.0347), ("neutral", 0.0449), ("stable", 0.0439)):
        rows = table(KAIMAL[stability], Setup(range_points=11), np.linspace(0.03, 0.055, 11))
        compare(f"Guo et al. 2023, cut-off at 16 m/s, Kaimal {stability}",
                crossing(rows[:, 0], rows[:, 6], 10 ** (-3 / 20)), f_c, 0.04)
    # Held and Mann 2019, region 1: L about 20 m; gamma and the Rayleigh lengths are ours.
    mann = Mann(0.1, 20.0, 3.2, lifetime="mann")
    half = np.radians(18.0)
    quadrants = np.radians([45, 135, 225, 315])
    y, z = np.sin(half) * np.cos(quadrants), np.sin(half) * np.sin(quadrants)
    four = np.degrees([np.arctan2(y, np.cos(half)), np.arcsin(z)])
    for name, focus, azimuth, elevation, rayleigh, k_half in (
            ("two", 37 * np.cos(np.radians(30)), (30.0, -30.0), (0.0, 0.0), 1.2, 0.027),
            ("four", 62 * np.cos(half), tuple(four[0]), tuple(four[1]), 3.4, 0.051)):
        s = Setup(10.0, 26.0, np.array([focus]), azimuth, elevation, rayleigh=rayleigh,
                  planes="frozen")
        rows = table(mann, s, np.array([0.9, 1.0, 1.1]) * k_half * 10 / (2 * np.pi))
        compare(f"Held and Mann 2019, k0.5, {name} beams", crossing(rows[:, 1], rows[:, 5], 0.5),
                k_half, 0.04)


check_tensor()
check_disk()
check_limits()
check_forms()
check_published()
sys.exit(1 if failures else 0)
