# SPDX-License-Identifier: GPL-3.0-or-later
"""Misaligned roller with logarithmic profile."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

import samcontact as sc

from ..drawing import axes, field, finish_titled
from .application import Answer, Application, Work

STEEL = sc.Material.elastic(E=210e9, nu=0.3)
RADIUS, RACE, LENGTH, LOAD = 5e-3, 20e-3, 10e-3, 15e3


def solved(tilt: float) -> sc.ContactSolution:
    """Solution of the Python interface on a grid of its own."""
    grid = sc.Grid(nx=21, ny=1201, dx=42e-6, dy=LENGTH / 1201)
    gap = sc.surfaces.roller(
        grid, radius=RADIUS, length=LENGTH, profile="logarithmic", race_radius=RACE
    )
    return sc.ContactSolver(grid, STEEL, STEEL).solve(gap, load=LOAD, tilt=(tilt, 0.0))


def answers(work: Work) -> list[Answer]:
    found = work.dataset()
    error = float(found["max_pressure_error"].values[-1])
    best = float(found["max_pressure_best"].values[-1])
    pressure = found["pressure"].isel(increment=-1).values
    middle = float(pressure[:, pressure.shape[1] // 2].max())
    line = sc.hertz.line(
        1 / (1 / RADIUS + 1 / RACE), sc.hertz.effective_modulus(STEEL, STEEL), LOAD / LENGTH
    )
    python = "sc.ContactSolver on a fixed grid"
    straight = float(solved(0.0).pressure.max())
    return [
        Answer("tilted", "maximum pressure with a tilt of 1 mrad", best, "Pa", error / best,
               python, float(solved(1e-3).pressure.max())),
        Answer("middle", "pressure in the middle of the roller", middle, "Pa",
               check="line contact of Hertz", expected=line.p0),
        Answer("aligned", "maximum pressure without tilt (ends of the profile)",
               largest_aligned(work), "Pa", check=python, expected=straight),
    ]  # fmt: skip


def largest_aligned(work: Work) -> float:
    """Return the maximum pressure of the aligned roller, from the sweep."""
    found = work.dataset("sweep/sweep.nc")
    return float(np.nanmax(found["max_pressure"].sel({"surface.tilt": 0.0}).values))


def picture(work: Work) -> Figure:
    found = work.dataset()
    pressure = found["pressure"].isel(increment=-1).values / 1e9
    y, x = found["y"].values * 1e3, found["x"].values * 1e3
    figure, (above, below) = axes(2, 1, (8.0, 5.6), sharex=True)
    above.plot(y, pressure.max(axis=0), label="tilt of 1 mrad")
    aligned = solved(0.0)
    places = (np.arange(1201) - 600) * LENGTH / 1201 * 1e3
    above.plot(places, aligned.pressure.max(axis=0) / 1e9, "k--", label="no tilt")
    finish_titled(above, "", "maximum over x [GPa]", "pressure along the roller")
    field(below, y, x, pressure.T, "pressure [GPa]", "magma_r")
    finish_titled(below, "y along the roller [mm]", "x [mm]", "", False)
    return figure


APPLICATION = Application(
    name="misaligned_roller",
    title="Misaligned roller",
    kind="roller",
    gains="The pressure at the end of a roller with the logarithmic profile of ISO/TS 16281 when "
    "it is tilted by 1 mrad.",
    text="The tilt raises the maximum pressure from {aligned} to {tilted}; in the middle of the "
    "roller the pressure is "
    "{middle}. The peaks of pressure at the ends extend over a few per cent of the length, so the "
    "cells are refined until the estimated error of the maximum pressure is below 2 %.",
    commands=("run roller.toml", "sweep roller.toml --set surface.tilt=0.0,0.0005,0.001"),
    shown=("Estimated errors", "At maximum von Mises stress"),
    functions=(
        ("sc.surfaces.roller", "gap of a roller with its profile"),
        ("sc.ContactSolver.solve", "contact with a given tilt or moment"),
        ("sc.to_accuracy", "solution to a prescribed accuracy"),
    ),
    guide=("static overload of a bearing", "bearing.md#misalignment"),
    limits="The command `run` solves the case to a prescribed accuracy, and estimates the error "
    "of the maximum pressure with tilt from three grids. In the model, both bodies are "
    "half-spaces that continue beyond the ends of the roller. The ends are therefore stiffer than "
    "those of a real roller.",
    answers=answers,
    picture=picture,
    caption="Pressure along the roller: maximum over the width of the contact, and map.",
    coarser=(("accuracy = 0.02", "accuracy = 0.04"),),
)
