# SPDX-License-Identifier: GPL-3.0-or-later
"""What repeated cycles come to."""

from __future__ import annotations

from dataclasses import dataclass, field

from .._util.checks import FloatArray, choice
from .._util.display import Brief, Rows, Shown
from ..solutions.state import State

ELASTIC, SHAKEDOWN = "elastic", "elastic shakedown"
PLASTIC, RATCHETING = "plastic shakedown", "ratcheting"
UNDECIDED = "undecided"


class NotSteadyWarning(UserWarning):
    """Cycles ended before it was clear what they come to."""


@dataclass(frozen=True)
class Cycle:
    """One cycle that was solved."""

    number: int
    """From 1; cycles that were extrapolated count too."""
    flow: float
    """Largest equivalent plastic strain that is added in it [-]."""
    net: float
    """Largest equivalent of the plastic strain between its beginning and its end [-].

    That is the square root of 2/3 e_ij e_ij, which flow to and fro does not raise.
    """


@dataclass(frozen=True, eq=False, repr=False)
class ShakedownResult(Brief, Shown):
    """What repeated cycles come to.

    Attributes
    ----------
    verdict : str
        "elastic": nothing ever flowed. "elastic shakedown": flow has come to rest. "plastic
        shakedown": each cycle flows to and fro, and ends where it began. "ratcheting": each cycle
        adds as much plastic strain as the one before. "undecided": none of them yet.
    rate : float
        `net` of the last cycle: plastic strain that each cycle leaves [-].
    flow : float
        `flow` of the last cycle [-].
    cycles : tuple of Cycle
        Those that were solved and count.
    solved : int
        All that were solved, with those of extrapolations that were taken back.
    error : float
        Estimated error of the plastic strain by extrapolation, of any component [-]; 0 without.
    rejected : int
        Extrapolations that a cycle did not confirm, and which were taken back.
    yield_strain : float
        Yield stress over Young's modulus of the body that yields first, to compare strains with.
    state : State
        At the end of the last cycle.
    """

    verdict: str
    rate: float
    flow: float
    cycles: tuple[Cycle, ...]
    solved: int
    error: float
    rejected: int
    yield_strain: float
    state: State = field(repr=False)
    _strain: dict[int, FloatArray] = field(repr=False)

    @property
    def shakes_down(self) -> bool:
        """Whether plastic strain comes to an end, elastic or closed in each cycle."""
        return self.verdict in (ELASTIC, SHAKEDOWN, PLASTIC)

    def strain_per_cycle(self, body: int = 2) -> FloatArray:
        """What the last cycle added to the plastic strain of a body [-].

        Parameters
        ----------
        body : {1, 2}

        Returns
        -------
        ndarray, shape (6, rows, ny, nz)
            Tensor components, on the cells of ``state.track(body, margin=0)``.

        Raises
        ------
        ValueError
            A body that cannot yield.
        """
        return self._strain[choice("body", body, tuple(self._strain))]

    def residual_stress(self, body: int = 2) -> FloatArray:
        """`State.residual_stress` at the end [Pa], shape (6, nx, ny, nz)."""
        return self.state.residual_stress(body)

    def _rows(self) -> Rows:
        rows = [
            ("verdict", self.verdict),
            ("plastic strain left by a cycle", f"{self.rate:.3g}"),
            ("plastic flow in a cycle", f"{self.flow:.3g}"),
            ("yield strain", f"{self.yield_strain:.3g}"),
            ("cycles", f"{self.cycles[-1].number}, {self.solved} of them solved"),
        ]
        if self.error > 0:
            rows.append(("error of the plastic strain by extrapolation", f"{self.error:.2g}"))
        return rows
