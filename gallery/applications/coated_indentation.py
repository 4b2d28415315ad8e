# SPDX-License-Identifier: GPL-3.0-or-later
"""Indentation of a hard coating on steel."""

from __future__ import annotations

from matplotlib.figure import Figure

import samcontact as sc

from ..drawing import APPLICATION_SIZE, axes, depth_down, field, finish_titled
from .application import Answer, Application, Work, largest

DIAMOND = sc.Material.elastic(E=1141e9, nu=0.07)
COATED = sc.Layered(
    [(sc.Material.elastic(E=400e9, nu=0.25), 2e-6)], sc.Material.elastic(E=210e9, nu=0.3)
)
TIP = 100e-6


def elastic(load: float) -> sc.ContactSolution:
    """Elastic solution of the Python interface, on cells of half the size."""
    grid = sc.Grid(nx=65, ny=65, dx=0.2e-6, dy=0.2e-6)
    solver = sc.ContactSolver(grid, DIAMOND, COATED)
    return solver.solve(sc.surfaces.paraboloid(grid, TIP), load=load)


def answers(work: Work) -> list[Answer]:
    found = work.dataset()
    depth, error = largest(found, "approach")
    imprint, imprint_error = largest(found, "imprint_depth_body2")
    strain, strain_error = largest(found, "max_equivalent_plastic_strain_body2")
    first = found.isel(increment=0)
    solution = elastic(float(first["load"]))
    load, load_error = work.row("load", 1)[0]
    python = "sc.ContactSolver on cells of half the size"
    return [
        Answer("elastic", "depth at 37.5 mN, where all is elastic", float(first["approach"]), "m",
               float(first["approach_error"] / first["approach"]), python,
               float(solution.approach)),
        Answer("depth", "depth at 300 mN", depth, "m", error),
        Answer("imprint", "depth of the imprint", imprint, "m", imprint_error),
        Answer("strain", "plastic strain of the steel below the coating", strain, "%",
               strain_error),
        Answer("load", "load that leaves an imprint of 10 nm", load, "N", load_error),
    ]  # fmt: skip


def picture(work: Work) -> Figure:
    found = work.dataset()
    figure, (left, right) = axes(size=APPLICATION_SIZE)
    load, depth = found["load"].values * 1e3, found["approach"].values * 1e9
    left.plot([0.0, *depth], [0.0, *load], "o-")
    finish_titled(left, "depth [nm]", "load [mN]", "indentation curve", False)
    middle = found.sizes["y"] // 2
    strain = found["equivalent_plastic_strain_body2"].isel(output_increment=-1, y=middle).values
    x, z = found["x"].values * 1e6, found["z"].values * 1e6
    field(right, x, z, 100 * strain, "plastic strain [%]", "magma_r")
    right.axhline(2.0, color="k", linestyle="--")
    depth_down(right, min(z[-1], 10.0))
    finish_titled(right, "x [µm]", "depth [µm]", "dashed: interface", False)
    return figure


APPLICATION = Application(
    name="coated_indentation",
    title="Indentation of a coating",
    kind="coated_indentation",
    gains="The indentation curve of a coated steel, the imprint, and the plastic strain of the "
    "steel below the coating.",
    text="The tip reaches a depth of {depth} and leaves an imprint of {imprint}. The coating "
    "stays elastic and bends where the steel below it yields, up to a plastic strain of {strain}. "
    "A load of "
    "{load} leaves an imprint of 10 nm.",
    commands=(
        "run coated_indentation.toml",
        'find coated_indentation.toml "imprint_depth_body2=10 nm"',
    ),
    shown=("Estimated grid errors", "Nitride coating"),
    functions=(
        ("sc.Layered", "coated body"),
        ("sc.Simulation", "load history of elastic-plastic bodies"),
        ("sc.State.residual_displacement", "imprint"),
        ("sc.find_load", "load for a given imprint"),
    ),
    guide=("indentation", "indentation.md"),
    limits="The coating neither cracks nor debonds. Sharp tips cause strains above the limit of "
    "small strains.",
    answers=answers,
    picture=picture,
    caption="Load over depth, and the plastic zone of the steel below the coating.",
)
