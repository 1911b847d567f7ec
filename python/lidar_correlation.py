#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Spectra of the rotor-effective wind speed (REWS), of its lidar estimate, and between them,
integrated from a turbulence model. Independent of the harness, for checks of it.

    python -m venv venv && venv/bin/pip install numpy scipy
    venv/bin/python python/lidar_correlation.py mann neutral --wavenumbers 0.001 0.1 40

REWS: mean of u over the disk (Guo et al. 2023, eq. 23). Lidar estimate: mean over all beams and
gates of v_los / n_x (eq. 28), each gate delayed by its distance over U and seen through a Gaussian
range weighting; the wind changes between its planes (eqs. 17, 18) and not within one. All beams
measure at once. The lidar is in the rotor centre.

Prints f [Hz], k1 [rad/m], one-sided S_RR, S_LL and |S_RL| [m^2/s^2/Hz], gamma^2 =
|S_RL|^2 / (S_RR S_LL), |G| = |S_RL| / S_LL and the phase of S_RL [rad], positive where the estimate
is late (X = sum of x e^(-i 2 pi f t), S_RL = E[X_R X_L*]); then k0.5, where gamma^2 crosses 0.5, and
f_c, where |G| crosses -3 dB.

`--grid NY NZ WIDTH HEIGHT DT` computes the same for wind that is known on a grid about the rotor
axis and interpolated linearly in y, z and time: what a simulated lidar in a generated field should
have, whatever the grid. There the rotor is the grid points within its radius, and time is counted
from the passage of a grid step through the rotor plane.
"""

import argparse
import shlex
import sys

import numpy as np
from scipy.special import j1

from lidar_geometry import Nodes, Setup, measuring_points, phases, rotor_nodes
from turbulence_models import KAIMAL, MANN, Kaimal


def distances(a, b):
    return np.hypot(a[0][:, None] - b[0][None, :], a[1][:, None] - b[1][None, :])


def disk_mean(rate, radius, distance, angles=720):
    """Mean of exp(-rate r) over a disk, r from a point at this distance from its centre: closed
    form along rays from the point, sum over their angles."""
    angle = (np.arange(angles) + 0.5) * 2 * np.pi / angles
    d = np.asarray(distance)[:, None]
    root = np.sqrt(np.maximum(radius**2 - (d * np.sin(angle)) ** 2, 0))
    ends = [np.maximum(-d * np.cos(angle) + sign * root, 0) for sign in (-1, 1)]
    hit = radius > np.abs(d * np.sin(angle))
    near, far = [1 - (1 + rate * r) * np.exp(-rate * r) for r in ends]
    return ((far - near) * hit).sum(axis=1) * 2 / angles / (rate * radius) ** 2


def disk_mean_of_pairs(rate, radius):
    nodes, weights = np.polynomial.legendre.leggauss(48)
    share = 0.5 * (nodes + 1)  # of the disk's area inside a ring
    return 0.5 * weights @ disk_mean(rate, radius, radius * np.sqrt(share))


def kaimal_spectra(m: Kaimal, s, nodes, points, f):
    k1 = 2 * np.pi * f / s.speed
    a = nodes.weights(phases(s, points, k1))
    place = (nodes.y, nodes.z)
    rate, along = m.rate(f, s.speed), m.evolution_rate(f, s.speed)
    apart = distances(place, place)
    evolved = np.exp(-along * np.abs(nodes.plane[:, None] - nodes.plane[None, :]))
    coherence = np.exp(-rate * apart) * evolved
    lateral = coherence if s.lateral == "same" else (apart < 1e-6) * evolved
    s_ll = sum(m.spectrum(c, f, s.speed)
               * (a[c].conj() @ (coherence if c == 0 else lateral) @ a[c]).real for c in range(3))
    if s.grid is None:
        s_rr = disk_mean_of_pairs(rate, s.radius)
        to_rotor = disk_mean(rate, s.radius, np.hypot(*place))
    else:
        rotor = rotor_nodes(s)
        s_rr = np.exp(-rate * distances(rotor, rotor)).mean()
        to_rotor = np.exp(-rate * distances(place, rotor)).mean(axis=1)
    s_rl = a[0].conj() @ (to_rotor * np.exp(-along * nodes.plane))
    return np.array([s_rr, s_rl]) * m.spectrum(0, f, s.speed), s_ll


def plane_factors(s, nodes, points, k1, k2, k3):
    """Per plane, nearest first: distance and [component] arrays of the estimate's filter
    A(k2, k3)."""
    if s.grid is None and s.planes != "nearest":
        for x in np.unique(points.plane):
            total = [0, 0, 0]
            for n in s.directions():
                for gate in s.gates[s.gates == x] if s.planes == "gate" else s.gates:
                    along = k1 * n[0] + k2 * n[1] + k3 * n[2]
                    phase = np.exp(-1j * gate / n[0] * (k2 * n[1] + k3 * n[2]))
                    seen = s.range_filter(along) * phase
                    share = n / n[0] / (len(s.azimuth) * len(s.gates))
                    total = [t + w * seen for t, w in zip(total, share)]
            yield x, total
        return
    a = nodes.weights(phases(s, points, k1))
    for x in np.unique(nodes.plane):
        here = nodes.plane == x
        ey = np.exp(1j * np.outer(k2.ravel(), nodes.y[here]))
        ez = np.exp(1j * np.outer(k3.ravel(), nodes.z[here]))
        yield x, [(ey * a[c, here]) @ ez.T for c in range(3)]


def rotor_filter(s, k2, k3):
    if s.grid is None:
        kr = np.hypot(k2, k3) * s.radius
        return 2 * j1(kr) / kr
    y, z = rotor_nodes(s)
    ey, ez = np.exp(1j * np.outer(k2.ravel(), y)), np.exp(1j * np.outer(k3.ravel(), z))
    return ey @ ez.T / len(y)


def mann_spectra(m, s, nodes, points, f, count=401, reach=80.0):
    k1 = 2 * np.pi * f / s.speed
    k, weight = m.nodes(k1, count, reach * (1 / m.length + k1))
    k2, k3 = k[:, None] + 0 * k1, k[None, :]
    k2 = k2 + 1e-12  # the disk's filter is 0/0 at 0
    area = np.outer(weight, weight)
    phi = m.tensor(k1, k2, k3)
    disk = rotor_filter(s, k2, k3)
    decay = 1 / m.evolution_time(np.sqrt(k1**2 + k2**2 + k3**2)) / s.speed
    s_rr = (area * phi[0][0] * np.abs(disk) ** 2).sum()
    s_ll = s_rl = 0
    gathered, last = [0, 0, 0], 0.0
    for x, a in plane_factors(s, nodes, points, k1, k2, k3):
        gathered = [g * np.exp(-(x - last) * decay) + ac for g, ac in zip(gathered, a)]
        last = x
        phi_a = [sum(phi[i][j] * a[j] for j in range(3)) for i in range(3)]
        for i in range(3):
            s_ll += (area * (phi_a[i].conj() * (2 * gathered[i] - a[i])).real).sum()
        s_rl += (area * phi_a[0].conj() * np.exp(-x * decay) * disk).sum()
    one_sided = 4 * np.pi / s.speed
    return np.array([s_rr, s_rl]) * one_sided, s_ll * one_sided


def table(model, s, frequencies):
    """Rows f, k1, S_RR, S_LL, |S_RL|, gamma^2, |G|, phase of S_RL."""
    points = measuring_points(s)
    nodes = Nodes(s, points)
    spectra = kaimal_spectra if isinstance(model, Kaimal) else mann_spectra
    rows = []
    for f in frequencies:
        (s_rr, s_rl), s_ll = spectra(model, s, nodes, points, f)
        s_rr, phase, s_rl = s_rr.real, -np.angle(s_rl), abs(s_rl)  # time runs against x
        rows.append([f, 2 * np.pi * f / s.speed, s_rr, s_ll, s_rl, s_rl**2 / (s_rr * s_ll),
                     s_rl / s_ll, phase])
    return np.array(rows)


def crossing(x, y, level):
    """First downward crossing, linear in between; None if there is none."""
    below = np.flatnonzero((y[:-1] >= level) & (y[1:] < level))
    if len(below) == 0:
        return None
    i = below[0]
    return x[i] + (y[i] - level) / (y[i] - y[i + 1]) * (x[i + 1] - x[i])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("model", choices=["kaimal", "mann"])
    parser.add_argument("stability", choices=list(MANN))
    parser.add_argument("--speed", type=float, default=16.0)
    parser.add_argument("--radius", type=float, default=63.0)
    parser.add_argument("--gates", nargs=3, metavar=("FIRST", "LAST", "COUNT"),
                        type=float, default=(50, 170, 10), help="along x [m]")
    parser.add_argument("--azimuth", nargs="+", type=float, default=Setup.azimuth, help="[deg]")
    parser.add_argument("--elevation", nargs="+", type=float, default=Setup.elevation)
    parser.add_argument("--fwhm", type=float, default=30.0)
    parser.add_argument("--rayleigh", type=float,
                        help="continuous wave: Rayleigh length [m]; only mann without grid")
    parser.add_argument("--range-points", type=int, default=41)
    parser.add_argument("--planes", choices=["gate", "nearest", "frozen"], default="gate")
    parser.add_argument("--lateral", choices=["same", "independent"], default="same")
    parser.add_argument("--grid", nargs=5, type=float, metavar=("NY", "NZ", "WIDTH", "HEIGHT", "DT"))
    parser.add_argument("--wavenumbers", nargs=3, type=float, metavar=("FIRST", "LAST", "COUNT"),
                        default=(0.001, 0.1, 60))
    a = parser.parse_args()
    first, last, count = a.gates
    s = Setup(a.speed, a.radius, np.linspace(first, last, int(count)), a.azimuth, a.elevation,
              a.fwhm, a.rayleigh, a.range_points, a.planes, a.lateral, a.grid)
    if a.rayleigh is not None and (a.model == "kaimal" or a.grid or a.planes == "nearest"):
        parser.error("--rayleigh needs mann, no --grid, --planes gate or frozen")
    model = (KAIMAL if a.model == "kaimal" else MANN)[a.stability]
    first, last, count = a.wavenumbers
    rows = table(model, s, np.geomspace(first, last, int(count)) * a.speed / (2 * np.pi))
    print("#", shlex.join(["lidar_correlation.py", *sys.argv[1:]]))
    print("# f_hz k1_radpm s_rr s_ll abs_s_rl gamma_squared abs_g phase_s_rl_rad")
    for row in rows:
        print(" ".join(f"{x:.6g}" for x in row))
    print("# k0.5 [rad/m]", crossing(rows[:, 1], rows[:, 5], 0.5),
          " f_c [Hz]", crossing(rows[:, 0], rows[:, 6], 10 ** (-3 / 20)))


if __name__ == "__main__":
    main()
