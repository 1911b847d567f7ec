#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Correlation of lidar wind speeds with loads, beside Giyanani et al. (2018): flies g18.yaml, runs
`lac correlate` on every case for torque and thrust, prints the tables of docs/studies/g18.md.

  python3 config/studies/g18.py [LAC [FOLDER]]     (defaults: lac, results/g18)
"""

import csv
import math
import pathlib
import statistics
import subprocess
import sys

LAC = sys.argv[1] if len(sys.argv) > 1 else "lac"
FOLDER = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "results/g18")
STUDY = pathlib.Path(__file__).with_name("g18.yaml")
RANGES = {50: "rec1122", 110: "rec1138", 170: "rec1154"}
# config/turbines/nrel5mw/turbine.yaml
TO_THE_ROTOR = ["--inertia", "4.3703e7", "--gear-ratio", "97"]
LOADS = {"aerodynamic torque Q": ["--load", "GenTq", *TO_THE_ROTOR], "thrust T": ["--load", "RotThrust"]}
MODES = ("below rated", "above rated")
RATED_KW = "5000"
# G18, Table 1 (correlation, share of it, delay [s], share), Q and out-of-plane moment
PUBLISHED = {
    ("aerodynamic torque Q", "below rated"): {170: "0.60-0.65, 22 %; 21-22 s, 45 %",
        110: "0.60-0.65, 27 %; 14-15 s, 65 %", 50: "0.70-0.75, 30 %; 8-9 s, 50 %"},
    ("aerodynamic torque Q", "above rated"): {170: "0.70-0.75, 20 %; 13-14 s, 59 %",
        110: "0.80-0.85, 37 %; 10-11 s, 57 %", 50: "0.80-0.85, 40 %; 6-7 s, 60 %"},
    ("thrust T", "below rated"): {170: "0.40-0.45, 22 %; 21-22 s, 32 %",
        110: "0.80-0.85, 30 %; 13-14 s, 53 %", 50: "0.75-0.80, 32 %; 7-8 s, 75 %"},
    ("thrust T", "above rated"): {170: "0.70-0.75, 42 %; 12-12.5 s, 68 %",
        110: "0.80-0.85, 52 %; 9-9.5 s, 63 %", 50: "0.80-0.85, 56 %; 5-5.5 s, 66 %"},
}


def lac(*words):
    """Without what it prints; its progress and its errors are seen."""
    words = [LAC, *map(str, words)]
    if subprocess.run(words, stdout=subprocess.DEVNULL, check=False).returncode != 0:
        sys.exit("failed: " + " ".join(words))


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def correlate(case, name, options, *more):
    """Windows and spectra of a case, made once."""
    out = [case / (name + kind + ".csv") for kind in ("_windows", "_spectra")]
    lac("correlate", case / "feedback-only.outb", case / "feedback-only.lac.outb",
        "--wind", ",".join(RANGES.values()), "--ranges", ",".join(map(str, RANGES)), *options,
        "--from", 60, "--rated-power", RATED_KW, "--max-delay", 40, "--either-sign", "--csv", out[0],
        "--spectra", out[1], *more)
    return [rows_of(path) for path in out]


def most_frequent(values, width):
    """The bin with most values, and its share."""
    if not values:
        return None
    bins = [int(v // width) for v in values]
    best = max(sorted(set(bins)), key=bins.count)
    return best * width, (best + 1) * width, bins.count(best) / len(bins)


def window_line(windows, load, mode, distance):
    mine = [w for w in windows if w["mode"] == mode and w["wind"] == RANGES[distance]]
    inside = [float(w["delay [s]"]) for w in mine if w["at_edge"] == "0"]
    rho = [float(w["correlation [-]"]) for w in mine]
    if not mine or not inside:
        return "| %s | %d | 0 | | | | | |" % (mode, distance)
    r, d = most_frequent(rho, 0.05), most_frequent(inside, 1.0)
    return "| %s | %d | %d | %.2f | %.2f to %.2f, %.0f %% | %.1f | %.0f to %.0f s, %.0f %% | %s |" % (
        mode, distance, len(mine), statistics.median(rho), r[0], r[1], 100 * r[2],
        statistics.median(inside), d[0], d[1], 100 * d[2], PUBLISHED[load, mode][distance])


def fall_hz(spectrum, level=0.4):
    """Where the coherence falls through a level for the first time; None: it is below already."""
    points = [(float(r["frequency [Hz]"]), float(r["coherence"])) for r in spectrum]
    if not points or points[0][1] < level:
        return None
    for (f0, c0), (f1, c1) in zip(points, points[1:]):
        if c1 < level:
            return f0 + (c0 - level) / (c0 - c1) * (f1 - f0)
    return None


def pooled(spectra):
    """The mean coherence of runs of equal length at each frequency."""
    by_frequency = {}
    for spectrum in spectra:
        for row in spectrum:
            by_frequency.setdefault(row["frequency [Hz]"], []).append(float(row["coherence"]))
    return [{"frequency [Hz]": f, "coherence": statistics.mean(c)}
            for f, c in sorted(by_frequency.items(), key=lambda item: float(item[0]))]


def decay(spectra, distance, speed):
    """alpha of exp(-alpha f dx/U), least squares weighted with the spectrum of the wind."""
    rows = [(float(r["frequency [Hz]"]), float(r["coherence"]), float(r["wind_density"]))
            for s in spectra for r in s]

    def error(alpha):
        return sum(s * (c - math.exp(-alpha * f * distance / speed)) ** 2
                   for f, c, s in rows)
    near = min(range(1, 60), key=error)
    return min((near + 0.02 * k for k in range(-49, 50)), key=error)


def main():
    lac("campaign", STUDY, "--output", FOLDER, "--no-report")
    cases = rows_of(FOLDER / "results.csv")
    windows = {load: [] for load in LOADS}
    spectra = {}
    for row in cases:
        case = FOLDER / "cases" / row["case"]
        for number, (load, options) in enumerate(LOADS.items()):
            name = "g18_%d" % number
            windows[load] += correlate(case, name, options)[0]
            for s in correlate(case, name + "_300s", options, "--block", 300)[1]:
                key = load, float(row["mean_speed_mps"]), s["mode"], s["wind"]
                spectra.setdefault(key, {}).setdefault(row["seed"], []).append(s)
    for load in LOADS:
        print("\n%s\n\n| mode | range m | windows | rho | most frequent | delay s | most frequent | G18: rho; delay |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- |" % load)
        for mode in MODES:
            for distance in sorted(RANGES, reverse=True):
                print(window_line(windows[load], load, mode, distance))
    print("\n| load | mode | TI < 0.12, windows: rho | TI >= 0.12 |\n| --- | --- | --- | --- |")
    for load in LOADS:
        for mode in MODES:
            mine = [w for w in windows[load] if w["mode"] == mode and w["wind"] == RANGES[50]]
            halves = [[float(w["correlation [-]"]) for w in mine
                       if (float(w["intensity [-]"]) >= 0.12) == high] for high in (False, True)]
            print("| %s | %s | %s |" % (load, mode, " | ".join(
                "%d: %.2f" % (len(h), statistics.median(h)) if h else "0" for h in halves)))
    print("\n| load | U m/s | mode | range m | f dx/U where coherence is 0.4 | decay alpha |\n"
          "| --- | --- | --- | --- | --- | --- |")
    for (load, speed, mode, wind), seeds in sorted(spectra.items()):
        distance = next(d for d, name in RANGES.items() if name == wind)
        if mode != ("below rated" if speed < 11 else "above rated"):
            continue
        fall = fall_hz(pooled(seeds.values()))
        print("| %s | %g | %s | %d | %s | %.1f |" % (
            load, speed, mode, distance,
            "%.2f (%.3f Hz)" % (fall * distance / speed, fall) if fall else "-",
            decay(seeds.values(), distance, speed)))
    print("\n| U m/s | time scale s (median) | length scale m |\n| --- | --- | --- |")
    for speed in sorted({float(row["mean_speed_mps"]) for row in cases}):
        mine = [w for w in windows["thrust T"] if w["wind"] == RANGES[50]
                and abs(float(w["speed [m/s]"]) - speed) < 1.0]
        print("| %g | %.1f | %.0f |" % (speed, statistics.median(float(w["time_scale [s]"]) for w in mine),
                                        statistics.median(float(w["length_scale [m]"]) for w in mine)))


main()
