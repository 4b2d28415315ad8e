# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of the documentation, from what was measured."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import deck

QUANTITIES = {
    "load": ("load [N]", 1.0),
    "von_mises": ("largest von Mises stress [MPa]", 1e-6),
    "plastic_strain": ("largest plastic strain [%]", 100.0),
    "residual_von_mises": ("largest residual von Mises stress [MPa]", 1e-6),
    "print": ("depth of the print [µm]", 1e6),
}
ASKED_FOR = {
    "load": "load",
    "von_mises": "max_von_mises_body2",
    "plastic_strain": "max_equivalent_plastic_strain_body2",
    "residual_von_mises": "max_residual_von_mises_body2",
    "print": "print_depth_body2",
}
"""Names of the quantities in `to_accuracy`."""
Runs = dict[str, dict[str, Any]]
TEXT = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: OMP_NUM_THREADS=1 python -m benchmarks.finite_elements --docs -->
# Beside finite elements

An elastic ball on a ball of AISI 52100 that yields, of 15 mm radius each: pressed by
{approach:.3f} µm (1500 N, 4.1 GPa by Hertz) in {up} increments, and released in {down}. Both codes
solve it on one thread, on meshes of their own:

- [CalculiX](https://www.calculix.de) 2.20 (Debian's `calculix-ccx`), axisymmetric: quadratic
  elements with reduced integration, as many on the contact's radius as the table says, evenly down
  to {fine} radii and beside it, then each {growth} times as large as the last, out to
  {far:.0f} radii; contact face to face with a stiffness that lets 4 nm through. It has the
  advantage of two dimensions: the scene has an axis, of which samcontact does not know.
- samcontact, three-dimensional: cubic cells, as many on the contact's radius, no `nz`, all settings
  as they come; the mirror planes are found;
- the same asked for to 5, 1 and 0.2 % (`sc.to_accuracy`), which chooses cells and increments;
  its time is that of all its grids.

```console
$ apt install calculix-ccx
$ OMP_NUM_THREADS=1 python -m benchmarks.finite_elements --docs
```

![Largest error over time](figures/finite_elements.png)

## The same error

The largest of the errors of five numbers, each against its code's own limit on fine meshes (the two
finest extrapolated with order two; to an accuracy also in ever more increments), and the
processor's time:

{times}

{ratios}

Work on the deck is not in it, nor that a scene without an axis has no such mesh.

## The numbers

{numbers}

The limits differ by {differ}: the finite elements' surface has slopes, up to {slope:.0f} % here,
while half-spaces are plane. Without flow, finite elements differ from Hertz by {load:+.2f} % in
the load and {stress:+.2f} % in the largest von Mises stress; with a radius four times as large by
{flat_load:+.2f} and {flat_stress:+.2f} %. CalculiX has stress and strain at integration points
beside the axis, samcontact in the middle of cells on it.
"""


def limit(runs: Runs, quantity: str) -> float:
    """Where the two finest meshes lead with order two."""
    (coarse, a), (fine, b) = sorted((int(size), run[quantity]) for size, run in runs.items())[-2:]
    ratio = (fine / coarse) ** 2
    return float((ratio * b - a) / (ratio - 1))


def error_of(runs: Runs, size: str) -> float:
    """The largest relative error of a mesh."""
    return max(abs(runs[size][q] / limit(runs, q) - 1) for q in QUANTITIES)


def error_against(truth: dict[str, float], run: dict[str, Any]) -> float:
    """The largest relative error of a run whose limit is known."""
    return max(abs(run[q] / truth[q] - 1) for q in QUANTITIES)


def time_at(points: list[tuple[float, float]], error: float) -> float | None:
    """Time at an error between those of points (error, time), in logarithms; None outside."""
    known = sorted(points)
    errors, times = np.log(known).T
    if not errors[0] <= np.log(error) <= errors[-1]:
        return None
    return float(np.exp(np.interp(np.log(error), errors, times)))


def ratios(results: dict[str, Runs], accuracy: dict[str, Runs]) -> str:
    """What one code takes times the other, at the errors of the slower one's meshes."""
    lines = []
    grids = results["samcontact"]
    fixed = [(error_of(grids, size), grids[size]["seconds"]) for size in grids]
    truth = accuracy["truth"]["limit"]
    asked = [(error_against(truth, run), run["seconds"]) for run in accuracy["runs"].values()]
    for size in results["CalculiX"]:
        error = error_of(results["CalculiX"], size)
        theirs = results["CalculiX"][size]["seconds"]
        for ours, than in (
            (time_at(fixed, error), "a grid"),
            (time_at(asked, error), "an accuracy"),
        ):
            if ours is not None:
                lines.append(
                    f"At an error of {100 * error:.2g} % finite elements take "
                    f"{theirs / ours:.0f} times as long as {than}."
                )
    return "\n".join(lines)


def table(heading: list[str], rows: list[list[str]]) -> str:
    """Markdown."""
    lines = [heading, ["---"] * len(heading), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def page(runs: dict[str, Runs], slopes: Runs, accuracy: dict[str, Runs]) -> str:
    """All of it."""
    times, numbers = [], []
    for code, found in runs.items():
        for size, run in found.items():
            count = run.get("elements", run.get("cells"))
            unit = "elements" if "elements" in run else "cells"
            error = f"{100 * error_of(found, size):.2g}"
            times.append([code, size, f"{count:.0f} {unit}", error, f"{run['seconds']:.3g}"])
            values = [f"{scale * run[q]:.5g}" for q, (_, scale) in QUANTITIES.items()]
            numbers.append([code, size, *values])
        values = [f"{scale * limit(found, q):.5g}" for q, (_, scale) in QUANTITIES.items()]
        numbers.append([code, "limit", *values])
    truth = accuracy["truth"]["limit"]
    for asked, run in accuracy["runs"].items():
        error = f"{100 * error_against(truth, run):.2g}"
        mesh = f"{run['cells']} cells and coarser"
        seconds = f"{run['seconds']:.3g}"
        times.append([f"samcontact, to {100 * float(asked):g} %", "", mesh, error, seconds])
    one, other = runs.values()
    apart = {q: 100 * abs(limit(one, q) / limit(other, q) - 1) for q in QUANTITIES}
    off = {at: {q: 100 * (value - 1) for q, value in found.items()} for at, found in slopes.items()}
    return TEXT.format(
        load=off["1"]["load"],
        stress=off["1"]["von_mises"],
        flat_load=off["4"]["load"],
        flat_stress=off["4"]["von_mises"],
        approach=1e3 * deck.APPROACH,
        up=deck.UP,
        down=deck.DOWN,
        fine=deck.FINE,
        growth=deck.GROWTH,
        far=deck.FAR,
        times=table(["code", "on the radius", "mesh", "largest error [%]", "time [s]"], times),
        ratios=ratios(runs, accuracy),
        numbers=table(
            ["code", "on the radius", *(name for name, _ in QUANTITIES.values())], numbers
        ),
        differ=f"{min(apart.values()):.2g} to {max(apart.values()):.2g} %",
        slope=100 * deck.FINE * deck.CONTACT / deck.RADIUS,
    )
