#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Power, thrust and torque coefficient tables of a rotor, computed with CCBlade.

    python -m venv venv && venv/bin/pip install wisdem==4.2.9
    venv/bin/python python/compute_rotor_tables.py TURBINE.yaml OUTPUT.txt

TURBINE.yaml is a turbine definition in windIO 2 form. The ones of NREL 5 MW, IEA 3.4 MW and
IEA 15 MW come with the package, in `examples/02_reference_turbines` of its installation. OUTPUT
has the layout of ROSCO's performance tables; its header says how it was computed.

The model: steady blade-element momentum theory (Ning 2014, doi:10.1002/we.1636) with Prandtl's
tip and hub loss, wake rotation and drag in the induction, uniform inflow at one wind speed (the
polars have one Reynolds number), tilt, cone and prebend as defined, rigid blades, no tower.
The blade elements are the stations at which the definition gives the chord, hub and tip excepted.
Between two airfoils of the definition their polars are blended linearly over its relative
thickness, unless `--airfoils` names one airfoil per station. Coefficients and tip-speed ratio are
formed with the radius hub radius + blade length (without cone): use the table with this radius.

The committed tables are those of the defaults; NREL 5 MW with the airfoils of its report
(NREL/TP-500-38060, table 3-1), which assigns one to each of its 17 stations:
`--airfoils Cylinder1*2 Cylinder2 DU40_A17 DU35_A17*2 DU30_A17 DU25_A17*2 DU21_A17*2 NACA64_A17*6`.
"""

import argparse
import datetime
import importlib.metadata
import multiprocessing
import pathlib

import numpy as np
import yaml
from wisdem.ccblade.ccblade import CCAirfoil, CCBlade

AIR_DENSITY_KGPM3 = 1.225
AIR_VISCOSITY_PAS = 1.81e-5
WIND_SPEED_MPS = 10.0
ANGLE_OF_ATTACK_DEG = np.unique(np.r_[-180:-30:5.0, -30:30:0.5, 30:180.1:5.0])


def at(curve, grid):
    """Value of a windIO curve at relative span `grid` (linear)."""
    return np.interp(grid, curve["grid"], curve["values"])


def read_polars(definition):
    """Name of airfoil -> (relative thickness, cl, cd on ANGLE_OF_ATTACK_DEG)."""
    polars = {}
    for airfoil in definition["airfoils"]:
        table = airfoil["polars"][0]["re_sets"][0]
        coefficients = [
            np.interp(ANGLE_OF_ATTACK_DEG, table[c]["grid"], table[c]["values"]) for c in ("cl", "cd")
        ]
        polars[airfoil["name"]] = (airfoil["rthick"], *coefficients)
    return polars


def blend(stations, polars, grid, thickness):
    """cl and cd at relative span `grid`: between the two airfoils around it, by thickness."""
    positions = [s["spanwise_position"] for s in stations]
    i = int(np.clip(np.searchsorted(positions, grid, side="right") - 1, 0, len(positions) - 2))
    (t0, cl0, cd0), (t1, cl1, cd1) = (polars[stations[j]["name"]] for j in (i, i + 1))
    if t0 == t1:
        weight = (grid - positions[i]) / (positions[i + 1] - positions[i])
    else:
        weight = np.clip((t0 - thickness) / (t0 - t1), 0.0, 1.0)
    return cl0 + weight * (cl1 - cl0), cd0 + weight * (cd1 - cd0)


def expand(names):
    """["A*2", "B"] -> ["A", "A", "B"]"""
    pairs = [name.partition("*") for name in names]
    return [name for name, _, count in pairs for _ in range(int(count or 1))]


def build_rotor(definition, airfoil_names):
    """CCBlade rotor on the stations of the definition, and its radius [m] without cone."""
    if not str(definition.get("windIO_version", "")).startswith("2"):
        raise SystemExit("the turbine definition is not windIO 2: no `windIO_version: 2...` in it")
    components = definition["components"]
    blade, hub = components["blade"], components["hub"]
    shape, axis = blade["outer_shape"], blade["reference_axis"]
    hub_radius = hub["diameter"] / 2
    length = axis["z"]["values"][-1]
    grid = np.array(shape["chord"]["grid"][1:-1])
    polars = read_polars(definition)
    if airfoil_names:
        if len(airfoil_names) != len(grid):
            raise SystemExit(f"--airfoils names {len(airfoil_names)} airfoils; expected {len(grid)}, one per station")
        sections = [polars[name][1:] for name in airfoil_names]
    else:
        sections = [blend(shape["airfoils"], polars, s, at(shape["rthick"], s)) for s in grid]
    airfoils = [CCAirfoil(ANGLE_OF_ATTACK_DEG, [], cl, cd) for cl, cd in sections]
    rotor = CCBlade(
        hub_radius + at(axis["z"], grid), at(shape["chord"], grid), at(shape["twist"], grid), airfoils,
        hub_radius, hub_radius + length, definition["assembly"]["number_of_blades"],
        AIR_DENSITY_KGPM3, AIR_VISCOSITY_PAS,
        precone=hub["cone_angle"], tilt=components["drivetrain"]["outer_shape"]["uptilt"],
        shearExp=0.0, nSector=4,
        precurve=at(axis["x"], grid), precurveTip=axis["x"]["values"][-1],
    )
    return rotor, hub_radius + length


def compute_row(job):
    """[cp, ct] over pitch at one tip-speed ratio."""
    definition, airfoil_names, tsr, pitch_deg = job
    rotor, radius = build_rotor(definition, airfoil_names)
    n = len(pitch_deg)
    rpm = tsr * WIND_SPEED_MPS / radius * 30 / np.pi
    loads, _ = rotor.evaluate(np.full(n, WIND_SPEED_MPS), np.full(n, rpm), np.asarray(pitch_deg))
    force = 0.5 * AIR_DENSITY_KGPM3 * np.pi * radius**2 * WIND_SPEED_MPS**2
    return loads["P"] / (force * WIND_SPEED_MPS), loads["T"] / force


def write_tables(path, header, pitch_deg, tsr, blocks):
    """ROSCO's layout: pitch along columns, tip-speed ratio along rows."""
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.writelines(f"# {line}\n" for line in header)
        out.write(f"\n# Pitch angle vector, {len(pitch_deg)} entries - x axis (matrix columns) (deg)\n")
        out.write(" ".join(f"{p:g}" for p in pitch_deg))
        out.write(f"\n# TSR vector, {len(tsr)} entries - y axis (matrix rows) (-)\n")
        out.write(" ".join(f"{t:g}" for t in tsr))
        out.write(f"\n# Wind speed vector - z axis (m/s)\n{WIND_SPEED_MPS:g}\n")
        for name, table in blocks:
            out.write(f"\n# {name} coefficient\n\n")
            out.writelines(" ".join(f"{x:.6f}" for x in row) + "\n" for row in table)
            out.write("\n")


def describe(definition, path, rotor, radius, airfoils):
    """The header lines: what computed the numbers, from what, under which assumptions."""
    components = definition["components"]
    version = importlib.metadata.version("wisdem")
    return [
        f"Rotor performance of {definition['name']}, computed with CCBlade of wisdem {version}",
        f"by python/compute_rotor_tables.py on {datetime.date.today()} from {path.name} (windIO"
        f" {definition['windIO_version']}) of that package.",
        f"Normalised with radius {radius:.2f} m; tilt {components['drivetrain']['outer_shape']['uptilt']:.1f} deg,"
        f" cone {components['hub']['cone_angle']:.1f} deg; {len(rotor.r)} stations per blade {airfoils},",
        "4 azimuths; tip and hub loss, wake rotation, drag in the induction; uniform inflow, rigid blades, no tower.",
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("definition", type=pathlib.Path, help="turbine definition, windIO 2 YAML")
    parser.add_argument("output", type=pathlib.Path, help="table file to write")
    parser.add_argument("--pitch", nargs=3, type=float, default=(-5, 30, 1), metavar=("FIRST", "LAST", "STEP"))
    parser.add_argument("--tsr", nargs=3, type=float, default=(2, 15, 0.25), metavar=("FIRST", "LAST", "STEP"))
    parser.add_argument("--airfoils", nargs="*", default=[], metavar="NAME[*COUNT]", help="one per station")
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    args = parser.parse_args()

    pitch_deg, tsr = (
        first + step * np.arange(round((last - first) / step) + 1) for first, last, step in (args.pitch, args.tsr)
    )
    definition = yaml.safe_load(args.definition.read_text(encoding="utf-8"))
    airfoil_names = expand(args.airfoils)
    rotor, radius = build_rotor(definition, airfoil_names)
    with multiprocessing.Pool(args.jobs) as pool:
        rows = pool.map(compute_row, [(definition, airfoil_names, t, pitch_deg) for t in tsr], chunksize=1)
    cp, ct = (np.array([row[k] for row in rows]) for k in (0, 1))
    blocks = [("Power", cp), ("Thrust", ct), ("Torque", cp / tsr[:, None])]
    airfoils = "with one assigned airfoil each" if airfoil_names else "with blended airfoils"
    header = describe(definition, args.definition, rotor, radius, airfoils)
    write_tables(args.output, header, pitch_deg, tsr, blocks)


if __name__ == "__main__":
    main()
