# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings before and after the increments of a simulation; each warning is issued once."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from .._util.display import quantity
from .._util.errors import GridTooSmallWarning, PlasticStrainWarning
from ..heat import Heat
from ..solutions.state import State
from . import adhesion, resolution, sharp_edges
from .hertz_estimate import ContactSetup
from .plastic_patterns import warn_of_alternation, warn_of_limit
from .relaxation_steps import RelaxationSteps

MAX_SMALL_STRAIN = 0.05
"""Small-strain limit: plastic strain above which results are unreliable [-]."""


@dataclass
class Monitor:
    """Record of the warnings that a simulation has issued, and of the enabled checks."""

    strain_warned: bool = False
    pressure_warned: bool = False
    limit_warned: bool = False
    alternation_warned: bool = False
    checks_increments: bool = True
    """Whether the error due to the size of the increments is estimated after each increment."""
    checks_steps: bool = True
    """Whether the grid resolution is checked after each step, instead of at the end of a run."""
    clipping_warned: bool = False
    setup_warned: bool = False
    contact_warned: bool = False
    edge_warned: bool = False
    adhesion_warned: bool = False
    largest_load: float = 0.0
    relaxation: RelaxationSteps = field(default_factory=RelaxationSteps)

    @contextmanager
    def deferred_resolution_checks(self) -> Iterator[None]:
        """Context manager that suppresses checks of resolution and increments after each step."""
        enabled = self.checks_steps, self.checks_increments
        self.checks_steps = self.checks_increments = False
        try:
            yield
        finally:
            self.checks_steps, self.checks_increments = enabled

    def warn_of_units(
        self, setup: ContactSetup, heat: Heat, target: Mapping[str, Any], *, stacklevel: int
    ) -> None:
        """Issue unit warnings before an increment; suppress later warnings of the same cause."""
        if self.setup_warned:
            return
        loaded = self.largest_load > 0
        finding = setup.warn_of_units(heat, target, is_loaded=loaded, stacklevel=stacklevel + 1)
        if not finding:
            return
        self.setup_warned = True
        if finding.of_contact:
            self.contact_warned = True
            self.checks_steps = False

    def warn_of_run(self, states: Sequence[State], setup: ContactSetup, *, stacklevel: int) -> None:
        """Issue warnings about the grid resolution after a run."""
        if not self.contact_warned:
            resolution.warn_of_run(states, setup, stacklevel=stacklevel + 1)

    def warn(
        self, state: State, setup: ContactSetup, found: Sequence[UserWarning], *, stacklevel: int
    ) -> None:
        """Issue warnings after an increment, including the warnings `found` by the core."""
        for warning in found:
            warnings.warn(warning, stacklevel=stacklevel + 1)
        if setup.plastic and not self.clipping_warned and (text := _cut_text(state)):
            self.clipping_warned = True
            warnings.warn(text, GridTooSmallWarning, stacklevel=stacklevel + 1)
        if self.checks_steps and (load := state.load) > self.largest_load:
            self.largest_load = load
            warned = resolution.warn_of_step(state, setup, stacklevel=stacklevel + 1)
            self.checks_steps = not warned
        if not self.pressure_warned:
            self.pressure_warned = resolution.warn_of_strain(
                state, setup, stacklevel=stacklevel + 1
            )
        if not self.edge_warned and sharp_edges.may_have_edge(state, setup):
            edge = sharp_edges.edge_of_state(state)
            self.edge_warned = sharp_edges.warn_of_edge(state, edge, stacklevel=stacklevel + 1)
        if not self.adhesion_warned:
            self.adhesion_warned = adhesion.warn_of_adhesion(
                state.setup.adhesion, state, state.setup.bodies, state.setup.friction,
                stacklevel=stacklevel + 1,
            )  # fmt: skip
        if setup.plastic:
            self._warn_of_flow(state, setup, stacklevel=stacklevel + 1)

    def _warn_of_flow(self, state: State, setup: ContactSetup, *, stacklevel: int) -> None:
        """Issue warnings about plastic flow after an increment."""
        if not self.limit_warned:
            self.limit_warned = warn_of_limit(state, setup, stacklevel=stacklevel + 1)
        if not self.alternation_warned:
            self.alternation_warned = warn_of_alternation(state, stacklevel=stacklevel + 1)
        if not self.strain_warned and (text := _strain_text(state, setup)):
            self.strain_warned = True
            warnings.warn(text, PlasticStrainWarning, stacklevel=stacklevel + 1)


def _strain_text(state: State, setup: ContactSetup) -> str:
    """Text of the warning if a plastic strain exceeds the small-strain limit, else ""."""
    for body, *_ in setup.plastic:
        accumulated, magnitude = state.max_strains[body - 1]
        if accumulated <= MAX_SMALL_STRAIN and magnitude <= MAX_SMALL_STRAIN:
            continue
        # with reversed flow, accumulated strain has no bound while the strain remains small
        is_reversed = magnitude < 0.5 * accumulated
        limit = f"above the small-strain limit of {MAX_SMALL_STRAIN}"
        if accumulated > MAX_SMALL_STRAIN and not is_reversed:
            return (
                f"the accumulated equivalent plastic strain of body {body} is {accumulated:.3g}, "
                f"{limit}, with a plastic strain magnitude sqrt(2/3 e:e) of at most "
                f"{magnitude:.3g}: results are unreliable"
            )
        if magnitude > MAX_SMALL_STRAIN:  # with reversed flow, or prescribed as initial strain
            name = "plastic strain magnitude sqrt(2/3 e:e)"
            return f"the {name} of body {body} is {magnitude:.3g}, {limit}: results are unreliable"
    return ""


def _cut_text(state: State) -> str:
    """Text of the warning if plastic strain lies outside the output fields, else ""."""
    grid, core = state.grid, state._core
    for body in (1, 2):
        box = core.strain_beyond(body - 1)
        if box is None:
            continue
        first_x, first_y, nx, ny, nz = box
        where, remedy = [], []
        if grid.nz and nz > grid.nz:
            depths = [quantity(n * (grid.dz or 0.0), "m") for n in (nz, grid.nz)]
            where.append(
                f"to a depth of {depths[0]}, below the output layers (nz dz = {depths[1]})"
            )
            remedy.append("omit nz")
        for axis, first, cells, n, d in (
            ("x", first_x, nx, grid.nx, grid.dx), ("y", first_y, ny, grid.ny, grid.dy),
        ):  # fmt: skip
            if first < 0 or first + cells > n:
                where.append(f"outside the grid along {axis} (length {quantity(cells * d, 'm')})")
                remedy.append(f"enlarge n{axis}")
        return (
            f"plastic strain of body {body} extends {' and '.join(where)}: the solution includes "
            f"it, but volume fields do not; {' and '.join(remedy)} to see it in these fields"
        )
    return ""
