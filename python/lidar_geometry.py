# SPDX-License-Identifier: Apache-2.0
"""Where a lidar measures and with which weight, for lidar_correlation.py: points of the probe
volumes, and the points of a grid that stand for them."""

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Setup:
    speed: float = 16.0
    radius: float = 63.0
    gates: np.ndarray = field(default_factory=lambda: np.linspace(50, 170, 10))  # along x
    azimuth: tuple = (14.4, 14.4, -14.4, -14.4)  # [deg], in the lidar's frame
    elevation: tuple = (14.0, -14.0, 14.0, -14.0)
    fwhm: float = 30.0
    rayleigh: float = None  # continuous wave: Rayleigh length [m] (Mann, planes of gates or frozen)
    range_points: int = 41  # quadrature over +-3 standard deviations
    planes: str = "gate"  # of a point: its gate's, the nearest one's, or frozen
    lateral: str = "same"  # Kaimal: v and w have the coherence of u, or independent
    grid: tuple = None

    def directions(self):
        a, e = np.radians(self.azimuth), np.radians(self.elevation)
        return np.array([-np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)]).T

    def sigma(self):
        return self.fwhm / np.sqrt(8 * np.log(2))

    def range_filter(self, wavenumber):
        if self.rayleigh is not None:
            return np.exp(-self.rayleigh * np.abs(wavenumber))
        return np.exp(-0.5 * (wavenumber * self.sigma()) ** 2)


@dataclass
class Points:
    """Where and how much of what the estimate takes: sum of weight . velocity."""

    gate: np.ndarray  # distance of the gate from the rotor [m]
    plane: np.ndarray  # of the plane of wind that is read
    x: np.ndarray  # up-wind
    y: np.ndarray
    z: np.ndarray
    weight: np.ndarray  # [point][component]


def measuring_points(s):
    offsets = np.linspace(-3, 3, s.range_points) * s.sigma() if s.fwhm > 0 else np.zeros(1)
    shares = np.exp(-0.5 * (offsets / s.sigma()) ** 2) if s.fwhm > 0 else np.ones(1)
    shares /= shares.sum()
    rows = []
    for n in s.directions():
        for gate in s.gates:
            for offset, share in zip(offsets, shares):
                p = (gate / -n[0] + offset) * n
                weight = share * n / n[0] / (len(s.azimuth) * len(s.gates))
                rows.append([gate, -p[0], p[1], p[2], *weight])
    gate, x, y, z = np.array(rows)[:, :4].T
    borders = (np.r_[0, s.gates[:-1]] + s.gates) / 2
    nearest = np.r_[0, s.gates][np.searchsorted(borders, x)]
    plane = {"gate": gate, "nearest": nearest, "frozen": 0 * gate}[s.planes]
    return Points(gate, plane, x, y, z, np.array(rows)[:, 4:])


def axis_of(count, width):
    return np.linspace(-width / 2, width / 2, count)


def between(axis, values):
    """Index of the node below, and the share of the one above."""
    place = (values - axis[0]) / (axis[1] - axis[0])
    low = np.clip(np.floor(place + 1e-9).astype(int), 0, len(axis) - 2)
    return low, place - low


def phases(s, p, k1):
    """e^(-i k1 (x - x_gate)) of each point; linear between steps if there is a grid."""
    if s.grid is None:
        return np.exp(-1j * k1 * (p.x - p.gate))
    step = s.speed * s.grid[4]
    low = np.floor(p.x / step + 1e-9)
    share = p.x / step - low
    line = (1 - share) * np.exp(-1j * k1 * low * step) + share * np.exp(-1j * k1 * (low + 1) * step)
    return line * np.exp(1j * k1 * p.gate)


class Nodes:
    """The points, or the grid points that stand for them, each once per plane."""

    def __init__(self, s, p):
        corners = [(p.y, p.z, np.ones_like(p.y))]
        if s.grid is not None:
            ys, zs = axis_of(int(s.grid[0]), s.grid[2]), axis_of(int(s.grid[1]), s.grid[3])
            (iy, ty), (iz, tz) = between(ys, p.y), between(zs, p.z)
            corners = [(ys[iy + a], zs[iz + b], (a * ty + (1 - a) * (1 - ty)) *
                        (b * tz + (1 - b) * (1 - tz))) for a in (0, 1) for b in (0, 1)]
        rows = np.concatenate([np.column_stack([p.plane, y, z]) for y, z, _ in corners])
        places, self.index = np.unique(rows.round(9), axis=0, return_inverse=True)
        self.index = self.index.reshape(len(corners), -1)
        self.share = np.array([share for _, _, share in corners])
        self.plane, self.y, self.z = places.T
        self.weight = p.weight

    def weights(self, phase):
        """[component][node]"""
        result = np.zeros((3, len(self.y)), complex)
        for index, share in zip(self.index, self.share):
            for c in range(3):
                np.add.at(result[c], index, share * phase * self.weight[:, c])
        return result


def rotor_nodes(s):
    y, z = np.meshgrid(axis_of(int(s.grid[0]), s.grid[2]), axis_of(int(s.grid[1]), s.grid[3]))
    inside = np.hypot(y, z) <= s.radius * (1 + 1e-9)
    return y[inside], z[inside]
