# SPDX-License-Identifier: Apache-2.0
"""The two turbulence models of the harness a second time, for checks: written from the papers,
with no code in common with it.

Kaimal: spectra and exponential coherence (IEC 61400-1; Guo et al. 2023, eqs. 11, 12, 18).
Mann: the uniform-shear tensor as rapid distortion of the isotropic one, and its extension in time
(Mann 1994; Guo et al. 2023, eqs. 1-17). SI units, angles in rad, x down-wind, z up.

    python turbulence_models.py mann neutral
"""

import argparse
import shlex
import sys
from dataclasses import dataclass

import numpy as np
from scipy.special import hyp2f1


@dataclass
class Kaimal:
    sigma: tuple  # of u, v, w
    length: tuple
    decay: float  # a_yz
    coherence_length: float
    evolution_decay: float  # a_x
    evolution_offset: float  # b_x

    def spectrum(self, component, f, speed):
        """One-sided in f."""
        time = self.length[component] / speed
        return 4 * self.sigma[component] ** 2 * time / (1 + 6 * f * time) ** (5 / 3)

    def rate(self, f, speed):
        """c of the root coherence exp(-c r) across the wind."""
        return self.decay * np.hypot(f / speed, 0.12 / self.coherence_length)

    def evolution_rate(self, f, speed):
        """The same along the wind: half of what the squared coherence has."""
        return 0.5 * self.evolution_decay * np.hypot(f / speed, self.evolution_offset)


@dataclass
class Mann:
    alpha_epsilon: float
    length: float
    gamma: float
    low_slope: float = -1.0
    high_slope: float = -2 / 3
    evolution: float = np.inf  # gamma of eq. 15 [s]
    lifetime: str = "guo"

    NORM = hyp2f1(1 / 3, 17 / 6, 4 / 3, -1) ** -0.5

    def beta(self, k):
        """Shear strain of an eddy over its life."""
        kl = k * self.length
        if self.lifetime == "guo":
            difference = self.high_slope - self.low_slope
            return self.gamma * self.NORM * kl**self.low_slope * (kl**10 + 1) ** (difference / 10)
        nodes = np.linspace(np.log(kl.min()) - 0.01, np.log(kl.max()) + 0.01, 4001)
        table = -0.5 * np.log(hyp2f1(1 / 3, 17 / 6, 4 / 3, -np.exp(-2 * nodes))) - 2 / 3 * nodes
        return self.gamma * np.exp(np.interp(np.log(kl), nodes, table))

    def tensor(self, k1, k2, k3):
        """[3][3] arrays of Phi: B Phi_isotropic(k0) B^T, B what shear makes of a Fourier mode."""
        kh2 = k1**2 + k2**2
        k_squared = kh2 + k3**2
        beta = self.beta(np.sqrt(k_squared))
        k30 = k3 + beta * k1
        k0_squared = kh2 + k30**2
        c1 = beta * k1**2 * (k0_squared - 2 * k30**2 + beta * k1 * k30) / (k_squared * kh2)
        angle = np.arctan2(beta * k1 * np.sqrt(kh2), k0_squared - k30 * k1 * beta)
        c2 = k2 * k0_squared / kh2**1.5 * angle
        one, zero = np.ones_like(k_squared), np.zeros_like(k_squared)
        b = [[one, zero, c1 - k2 / k1 * c2],
             [zero, one, k2 / k1 * c1 + c2],
             [zero, zero, k0_squared / k_squared]]
        energy = (self.alpha_epsilon * self.length ** (5 / 3) * (k0_squared * self.length**2) ** 2
                  / (1 + k0_squared * self.length**2) ** (17 / 6))
        k0 = [k1 * one, k2 * one, k30]
        isotropic = [[energy / (4 * np.pi * k0_squared**2) * ((i == j) * k0_squared - k0[i] * k0[j])
                      for j in range(3)] for i in range(3)]
        half = [[sum(b[i][m] * isotropic[m][j] for m in range(3)) for j in range(3)]
                for i in range(3)]
        return [[sum(half[i][m] * b[j][m] for m in range(3)) for j in range(3)] for i in range(3)]

    def evolution_time(self, k):
        kl = k * self.length
        return self.evolution * self.NORM / kl * (kl**10 + 1) ** (-2 / 15)

    def nodes(self, k1, count, reach):
        """Nodes and weights of one axis: trapezoid rule in t, k = s sinh(t), |k| <= reach."""
        s = 0.3 * k1
        t = np.linspace(-np.arcsinh(reach / s), np.arcsinh(reach / s), count)
        return s * np.sinh(t), s * np.cosh(t) * (t[1] - t[0])

    def cross_spectra(self, k1, cases, count=401, reach=600):
        """F_ij(k1, dy, dz, dt) of every case (i, j, dy, dz, dt), two-sided in k1; |k2|, |k3| up to
        reach (1/L + k1)."""
        k, weight = self.nodes(k1, count, reach * (1 / self.length + k1))
        k2, k3 = k[:, None], k[None, :]
        phi = self.tensor(k1, k2, k3)
        decay = 1 / self.evolution_time(np.sqrt(k1**2 + k2**2 + k3**2))
        return np.array([(weight * np.exp(1j * k * dy)) @ (phi[i][j] * np.exp(-dt * decay))
                         @ (weight * np.exp(1j * k * dz)) for i, j, dy, dz, dt in cases])


def distorted_mode(k, beta, amplitude):
    """An incompressible Fourier mode under the shear du/dz = 1 for the time beta, by integrating
    the linearised equations of motion; k is the wave vector at the end. For checks of tensor()."""
    from scipy.integrate import solve_ivp

    def rate(t, z):
        k3 = k[2] + k[0] * (beta - t)
        k_squared = k[0] ** 2 + k[1] ** 2 + k3**2
        return np.array([2 * k[0] ** 2 / k_squared - 1, 2 * k[0] * k[1] / k_squared,
                         2 * k[0] * k3 / k_squared]) * z[2]

    return solve_ivp(rate, (0, beta), amplitude, rtol=1e-10, atol=1e-12).y[:, -1]


# Guo et al. 2023, Tables 1 and 2; sigma_u of 16 m/s in IEC class 1A.
KAIMAL = {
    "unstable": Kaimal((2.82, 2.34, 1.98), (744.8, 181.9, 126.4), 6.5, 1502.0, 4.1, 7.67e-5),
    "neutral": Kaimal((2.82, 2.25, 1.41), (340.2, 113.4, 27.72), 12.0, 340.2, 1.8, 1.49e-4),
    "stable": Kaimal((2.82, 2.26, 1.83), (101.1, 33.3, 27.0), 13.1, 101.1, 1.6, 9.18e-4),
}
MANN = {
    "unstable": Mann(0.184, 140.0, 2.6, evolution=600.0),
    "neutral": Mann(0.311, 49.0, 3.1, evolution=400.0),
    "stable": Mann(0.652, 30.0, 2.4, low_slope=-0.8, evolution=200.0),
}

SEPARATIONS_M = (10.0, 20.0, 40.0, 80.0, 160.0)  # along y
DISTANCES_M = (50.0, 100.0, 170.0)  # along x


def kaimal_row(m, f, speed):
    spectra = [m.spectrum(c, f, speed) for c in range(3)]
    across = [np.exp(-m.rate(f, speed) * r) for r in SEPARATIONS_M] * 3
    along = [np.exp(-m.evolution_rate(f, speed) * x) for x in DISTANCES_M]
    return [*spectra, *across, *along, 0.0]


def mann_row(m, f, speed):
    k1 = 2 * np.pi * f / speed
    cases = [(i, j, 0, 0, 0) for i, j in ((0, 0), (1, 1), (2, 2), (0, 2))]
    cases += [(0, 0, 0, 0, x / speed) for x in DISTANCES_M]
    uu, vv, ww, uw, *along = m.cross_spectra(k1, cases).real
    # The tail matters little to coherence across, and far points need narrow steps.
    pairs = [(i, i, r, 0, 0) for i in range(3) for r in (0.0, *SEPARATIONS_M)]
    across = m.cross_spectra(k1, pairs, count=801, reach=60).real.reshape(3, -1)
    return [*(4 * np.pi / speed * np.array([uu, vv, ww])), *(across[:, 1:] / across[:, :1]).ravel(),
            *(np.array(along) / uu), uw / np.sqrt(uu * ww)]


def main():
    parser = argparse.ArgumentParser(
        description="Prints f [Hz], one-sided spectra of u, v, w [m^2/s^2/Hz], root coherence of u, "
        f"v and w (v and w as u in Kaimal) {SEPARATIONS_M} m apart along y, of u {DISTANCES_M} m "
        "apart along the wind at the time of arrival, and the co-coherence of u and w at a point.")
    parser.add_argument("model", choices=["kaimal", "mann"])
    parser.add_argument("stability", choices=list(MANN))
    parser.add_argument("--speed", type=float, default=16.0)
    parser.add_argument("--wavenumbers", nargs=3, type=float, metavar=("FIRST", "LAST", "COUNT"),
                        default=(0.00025, 0.25, 25), help="k1 [rad/m]")
    a = parser.parse_args()
    first, last, count = a.wavenumbers
    print("#", shlex.join(["turbulence_models.py", *sys.argv[1:]]))
    for f in np.geomspace(first, last, int(count)) * a.speed / (2 * np.pi):
        row = (kaimal_row(KAIMAL[a.stability], f, a.speed) if a.model == "kaimal"
               else mann_row(MANN[a.stability], f, a.speed))
        print(" ".join(f"{x:.6g}" for x in [f, *row]))


if __name__ == "__main__":
    main()
