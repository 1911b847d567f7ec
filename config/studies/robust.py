#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flies config/studies/robust.yaml and prints its table: changes against feedback alone in the same wind.

    python3 config/studies/robust.py build/release/bin/lac [FOLDER]
"""
import csv
import pathlib
import subprocess
import sys

STUDY = pathlib.Path(__file__).with_name("robust.yaml")
ROWS = [  # name, fault, controller without and with the monitor
    ("none", "none", "plain", "watched"),
    ("buffer 1 s short", "none", "early", "early_watched"),
    ("buffer 1 s long", "none", "late", "late_watched"),
    ("biased +20 %", "high", "plain", "watched"),
    ("biased -20 %", "low", "plain", "watched"),
    ("half of the data missing", "missing", "plain", "watched"),
    ("a beam stuck", "stuck", "plain", "watched"),
    ("wind from 20 deg beside", "direction", "plain", "watched"),
    ("biased +100 %", "twice", "plain", "watched"),
]


def table(rows, channel):
    """Mean and largest change in per cent over the seeds, without / with the monitor."""
    column = next(c for c in rows[0] if c.startswith(channel))
    value = {(r["mean_speed_mps"], r["seed"], r["fault"], r["control"]): float(r[column]) for r in rows}
    winds = sorted({k[0] for k in value}, key=float)
    seeds = sorted({k[1] for k in value})

    def cell(wind, fault, control):
        turned = "direction" if fault == "direction" else "none"
        changes = [100.0 * (value[wind, s, fault, control] / value[wind, s, turned, "feedback"] - 1.0)
                   for s in seeds]
        return f"{sum(changes) / len(changes):+.1f} ({max(changes):+.1f})"

    print("| fault | " + " | ".join(f"{float(w):g} m/s" for w in winds) + " |")
    print("|---" * (len(winds) + 1) + "|")
    for name, fault, plain, watched in ROWS:
        cells = [f"{cell(w, fault, plain)} / {cell(w, fault, watched)}" for w in winds]
        print(f"| {name} | " + " | ".join(cells) + " |")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "results/robust")
    subprocess.run([sys.argv[1], "campaign", str(STUDY), "--output", str(folder)], check=True)
    rows = list(csv.DictReader((folder / "results.csv").open()))
    for channel in ("RotSpeed_std", "TwrBsMyt_del4"):
        print(f"\n{channel}, change against feedback alone in %: mean (worst seed), without / with monitor\n")
        table(rows, channel)


if __name__ == "__main__":
    main()
