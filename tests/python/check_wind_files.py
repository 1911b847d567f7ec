# SPDX-License-Identifier: Apache-2.0
"""Opens the wind files that `lac wind convert` writes with other people's readers, and gives it
files that other people's writers have made. The truth is a field of numbers made here: no two
points or directions are alike, so that a mirrored axis or a sign cannot pass.

    check_wind_files.py LAC

Needs numpy, weio, openfast_io and hipersim (pip install weio openfast-io hipersim); without them it
ends with exit code 77: skipped.
"""

import struct
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy as np
    from hipersim import TurbulenceField
    from openfast_io.turbsim_file import TurbSimFile as OpenFastTurbSimFile
    from weio.fast_wind_file import FASTWndFile
    from weio.mannbox_file import MannBoxFile
    from weio.turbsim_file import TurbSimFile as WeioTurbSimFile
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

NT, NY, NZ = 20, 5, 4
DT, DY, DZ = 0.5, 7.0, 6.0
U, Z_BOTTOM, Z_HUB = 12.0, 81.0, 90.0
Y = (np.arange(NY) - (NY - 1) / 2) * DY  # to the left, looking down-wind
Z = Z_BOTTOM + np.arange(NZ) * DZ


def truth():
    """[component][t][y][z]"""
    t, y, z = np.meshgrid(np.arange(NT) * DT, Y, Z, indexing="ij")
    u = U + np.sin(0.9 * t) + 0.02 * y + 0.05 * (z - Z_HUB) + 0.001 * t * y
    v = 0.5 * np.cos(0.7 * t) + 0.03 * y - 0.01 * (z - Z_HUB)
    w = 0.3 * np.sin(0.4 * t + 0.1 * y) + 0.02 * (z - Z_HUB)
    return np.array([u, v, w])


def write_bts(file, field):
    """TurbSim's format after its manual, by hand."""
    low, high = field.min(axis=(1, 2, 3)), field.max(axis=(1, 2, 3))
    scale = 65535.0 / (high - low)
    offset = -32768.0 - scale * low
    data = np.round(field * scale[:, None, None, None] + offset[:, None, None, None])
    with open(file, "wb") as f:
        f.write(struct.pack("<h4i", 8, NZ, NY, 0, NT))
        f.write(struct.pack("<6f", DZ, DY, DT, U, Z_HUB, Z_BOTTOM))
        for s, o in zip(scale, offset):
            f.write(struct.pack("<2f", s, o))
        f.write(struct.pack("<i", 4) + b"hand")
        f.write(data.transpose(1, 3, 2, 0).astype("<i2").tobytes())  # t, z, y, component


class Checker:
    def __init__(self, lac, folder):
        self.lac, self.folder, self.failures = lac, Path(folder), 0

    def run(self, *arguments):
        done = subprocess.run([self.lac, "wind", *map(str, arguments)], cwd=self.folder,
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"lac wind {arguments}: {done.stderr}")

    def path(self, name):
        return str(self.folder / name)

    def compare(self, what, found, expected, error):
        found, expected = np.asarray(found, float), np.asarray(expected, float)
        worst = np.abs(found - expected).max() if found.shape == expected.shape else np.inf
        good = worst <= error
        self.failures += not good
        print(f"{'ok ' if good else 'BAD'} {what}: greatest difference {worst:.2e} (<= {error:.1e})")


BOX = ["--points", NT, NY, NZ, "--spacing", DT * U, DY, DZ, "--mean-speed", U, "--hub-height",
       Z_BOTTOM + (NZ - 1) * DZ / 2]
STEP = 1e-4  # of the integers of .bts, with some rounding
BLADED_STEP = 1e-3


def check_written(c, field):
    """Files of ours in the hands of others."""
    c.run("convert", "truth.bts", "ours.bts")
    for name, reader in (("weio", WeioTurbSimFile), ("openfast_io", OpenFastTurbSimFile)):
        file = reader(c.path("ours.bts"))
        c.compare(f"{name} reads .bts", file["u"], field, STEP)
        c.compare(f"{name} reads .bts, y", file["y"], Y, 1e-5)
        c.compare(f"{name} reads .bts, z", file["z"], Z, 1e-5)

    c.run("convert", "truth.bts", "ours.wnd")
    bladed = TurbulenceField.from_bladed(c.path("ours.wnd"))
    left_handed = field * np.array([1, -1, 1])[:, None, None, None]
    c.compare("hipersim reads .wnd (v as in the file: to the right)", bladed.uvw, left_handed,
              BLADED_STEP)
    c.compare("hipersim reads .wnd, spacing", bladed.dxyz, [DT * U, DY, DZ], 1e-5)

    c.run("convert", "truth.bts", "ours.bin")
    fluctuation = field - np.array([U, 0, 0])[:, None, None, None]
    for i, letter in enumerate("uvw"):
        box = MannBoxFile(c.path(f"ours-{letter}.bin"), N=(NT, NY, NZ), dy=DY, dz=DZ)
        c.compare(f"weio reads the box of {letter} (it mirrors y)", box["field"], fluctuation[i],
                  STEP)
    files = [c.path(f"ours-{letter}.bin") for letter in "uvw"]
    box = TurbulenceField.from_hawc2(files, (NT, NY, NZ), (DT * U, DY, DZ))
    c.compare("hipersim reads the box (rows as in the file: from the left)", box.uvw,
              fluctuation[:, :, ::-1, :], STEP)
    c.run("convert", "truth.bts", "mann.bin", "--last-plane-first", "--rows-from-right")
    files = [c.path(f"mann-{letter}.bin") for letter in "uvw"]
    box = TurbulenceField.from_hawc2(files, (NT, NY, NZ), (DT * U, DY, DZ))
    c.compare("hipersim reads the box in Mann's frame (x down-wind, y to the left)", box.uvw,
              fluctuation[:, ::-1, :, :], STEP)


def check_read(c, field):
    """Files of others in ours."""
    def read_back(what, name, error, *options):
        c.run("convert", name, "back.bts", *options)
        c.compare(f"lac reads {what}", WeioTurbSimFile(c.path("back.bts"))["u"], field, error)

    WeioTurbSimFile(c.path("truth.bts")).write(c.path("weio.bts"))
    read_back("weio's .bts", "weio.bts", 2 * STEP)

    fluctuation = field - np.array([U, 0, 0])[:, None, None, None]
    for i, letter in enumerate("uvw"):
        box = MannBoxFile()
        box["field"] = fluctuation[i]
        box.write(c.path(f"weio-{letter}.bin"))
    read_back("weio's box", "weio-u.bin", STEP, *BOX)

    mann_frame = fluctuation[:, ::-1, :, :]
    for i, letter in enumerate("uvw"):
        mann_frame[i].astype("<f4").tofile(c.path(f"hipersim{letter}.turb"))
    read_back("a box as hipersim's to_hawc2 writes it (x down-wind, y to the left)",
              "hipersimu.turb", STEP, *BOX, "--last-plane-first", "--rows-from-right")

    # hipersim takes the means out, cuts to whole steps of U/1000, keeps the sign of v and leaves the
    # summary to the user.
    box = TurbulenceField(fluctuation, (NT, NY, NZ), (DT * U, DY, DZ), generator="test")
    box.to_bladed(U, zhub=Z_HUB, folder=str(c.folder), basename="hipersim")
    (c.folder / "hipersim_1.sum").write_text(
        f"{Z_HUB} hub height\nUBar = {U}\nTI = 100 %\nTI = 100 %\nTI = 100 %\nPERIODIC\n")
    c.run("convert", "hipersim_1.wnd", "back.bts")
    centred = fluctuation - fluctuation.mean(axis=(1, 2, 3))[:, None, None, None]
    c.compare("lac reads hipersim's .wnd", WeioTurbSimFile(c.path("back.bts"))["u"],
              centred + np.array([U, 0, 0])[:, None, None, None], 1.1e-3 * U)


def check_uniform(c):
    """An extreme direction change as a uniform wind file."""
    (c.folder / "edc.yaml").write_text(
        "hub_height_m: 90\nrotor_radius_m: 63\n"
        "wind: {kind: edc, mean_speed_mps: 18, start_s: 20, shear_exponent: 0.2}\n")
    c.run("make", "edc.yaml", "-o", "edc.hh", "--duration", 60, "--time-step", 0.5)
    rows = np.loadtxt(c.path("edc.hh"), comments="!")
    angle = 4 * np.degrees(np.arctan(0.16 * (0.75 * 18 + 5.6) / (18 * (1 + 0.1 * 126 / 42))))
    inside = np.clip((rows[:, 0] - 20) / 6, 0, 1)
    c.compare("uniform file, direction", rows[:, 2], angle / 2 * (1 - np.cos(np.pi * inside)), 1e-5)
    c.compare("uniform file, shear exponent", rows[:, 5], 0 * inside + 0.2, 1e-8)
    eight = np.delete(rows, 8, axis=1)  # weio knows the form of eight columns
    np.savetxt(c.path("edc8.wnd"), eight, header="t V dir w hs ps vs gust", comments="!", fmt="%.6f")
    table = FASTWndFile(c.path("edc8.wnd")).toDataFrame().to_numpy()
    c.compare("weio reads eight columns", table, eight, 1e-6)
    c.run("convert", "edc8.wnd", "back.hh", "--hub-height", 90, "--rotor-diameter", 126)
    c.compare("lac reads eight columns", np.loadtxt(c.path("back.hh"), comments="!"), rows, 1e-5)


def main():
    with tempfile.TemporaryDirectory() as folder:
        checker = Checker(sys.argv[1], folder)
        field = truth()
        write_bts(checker.path("truth.bts"), field)
        check_written(checker, field)
        check_read(checker, field)
        check_uniform(checker)
        return 1 if checker.failures else 0


if __name__ == "__main__":
    sys.exit(main())
