# SPDX-License-Identifier: Apache-2.0
"""Compares `lac stats` and `lac compare` with other people's programs: loads with rainflow (bit by
bit) and fatpack, intervals of paired differences with scipy.

    check_analysis.py LAC

Needs numpy, scipy, rainflow and fatpack (pip install scipy rainflow fatpack); without them it ends
with exit code 77: skipped.
"""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import fatpack
    import numpy as np
    import rainflow
    from scipy import stats
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

STEP, SAMPLES = 0.05, 12000
DURATION = STEP * SAMPLES
LIFE_CYCLES = 2e6 * DURATION / (20 * 8760 * 3600.0)
EXPONENTS = (3, 4, 10)


def rough_series(random):
    """Red noise with a sine and a plateau, as float32."""
    noise = np.cumsum(random.normal(size=SAMPLES)) * 0.3 + random.normal(size=SAMPLES)
    series = noise + 20 * np.sin(0.7 * STEP * np.arange(SAMPLES))
    series[4000:4100] = series[4000]
    return series.astype(np.float32)


def figures(lac, folder, *options):
    table = folder / "stats.csv"
    subprocess.run([lac, "stats", folder / "a.csv", "--csv", table, "--woehler", "3,4,10", *options],
                   check=True, stdout=subprocess.DEVNULL)
    return next(csv.DictReader(table.open()))


def astm_load(series, m):
    damage = sum(n * r**m for r, _, n, _, _ in rainflow.extract_cycles(series))
    return (damage / DURATION) ** (1 / m)


def four_point_load(series, m):
    """Closed cycles, then those of the residue repeated; its reversals found anew at the joint."""
    closed, residue = fatpack.find_rainflow_cycles(np.array([x for _, x in rainflow.reversals(series)]))
    again = np.array([x for _, x in rainflow.reversals([*residue, *residue])])
    cycles = np.concatenate([closed, fatpack.find_rainflow_cycles(again)[0]])
    return (np.sum(np.abs(cycles[:, 0] - cycles[:, 1]) ** m) / LIFE_CYCLES) ** (1 / m)


def check_loads(lac, folder, random):
    columns = [rough_series(random) for _ in range(3)]
    with (folder / "a.csv").open("w") as f:
        f.write("Time [s]," + ",".join(f"L{i} [kNm]" for i in range(3)) + "\n")
        for k in range(SAMPLES):
            f.write(f"{k * STEP:.10g}," + ",".join(str(c[k]) for c in columns) + "\n")
    astm = figures(lac, folder)
    four = figures(lac, folder, "--rainflow", "four-point", "--reference", "2e6in20y")
    for i, column in enumerate(columns):
        series = [float(x) for x in column]
        for m in EXPONENTS:
            name = f"L{i}_del{m} [kNm]"
            assert float(astm[name]) == astm_load(series, m), (name, astm[name])
            assert abs(float(four[name]) / four_point_load(series, m) - 1) < 1e-14, name
        assert abs(float(astm[f"L{i}_std [kNm]"]) / np.std(series, ddof=1) - 1) < 1e-12
    print("loads: equal to rainflow bit by bit, to fatpack within rounding")


def check_intervals(lac, folder, random):
    speeds, seeds = (12, 14, 16), range(6)
    loads = {(c, v, s): 1000 * v + 300 * random.normal() + (c == "b") * 40 * (v - 13) + 50 * random.normal()
             for v in speeds for s in seeds for c in "ab"}
    with (folder / "t.csv").open("w") as f:
        f.write("mean_speed_mps,seed,controller,TwrBsMyt_del4 [kNm]\n")
        for (c, v, s), load in loads.items():
            f.write(f"{v},{s},{c},{load!r}\n")
    subprocess.run([lac, "compare", folder / "t.csv", "--csv", folder / "c.csv"], check=True,
                   stdout=subprocess.DEVNULL)
    rows = {r["wind_speed_mps"]: r for r in csv.DictReader((folder / "c.csv").open())}
    for v in speeds:
        a, b = (np.array([loads[c, v, s] for s in seeds]) for c in "ab")
        expected = stats.ttest_rel(b, a).confidence_interval(0.95)
        row = rows[str(v)]
        assert abs(float(row["relative_low"]) * a.mean() - expected.low) < 1e-6, v
        assert abs(float(row["relative_high"]) * a.mean() - expected.high) < 1e-6, v
        told = row["verdict"] == "significant"
        assert told == (stats.ttest_rel(b, a).pvalue < 0.05), v
    print("intervals: equal to scipy.stats.ttest_rel")


def main():
    random = np.random.default_rng(1)
    with tempfile.TemporaryDirectory() as folder:
        check_loads(sys.argv[1], Path(folder), random)
        check_intervals(sys.argv[1], Path(folder), random)


main()
