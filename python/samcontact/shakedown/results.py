# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of repeated load cycles."""

from __future__ import annotations

from dataclasses import dataclass, field

from .._util.checks import FloatArray, choice
from .._util.display import HtmlTable, Rows, ShortRepr
from ..solutions.state import State

ELASTIC, SHAKEDOWN = "elastic", "elastic shakedown"
PLASTIC, RATCHETING = "plastic shakedown", "ratcheting"
UNDECIDED = "undecided"


class NotSteadyWarning(UserWarning):
    """Warning that the response was not steady after the last cycle."""


@dataclass(frozen=True)
class Cycle:
    """Results of one solved cycle."""

    number: int
    """Number of the cycle, from 1; extrapolated cycles are counted."""
    flow: float
    """Maximum equivalent plastic strain added in the cycle [-]."""
    net: float
    """Maximum magnitude sqrt(2/3 e_ij e_ij) of the plastic strain change e over the cycle [-].
    Forward and reversed flow cancel in this change.
    """


@dataclass(frozen=True, eq=False, repr=False)
class ShakedownResult(ShortRepr, HtmlTable):
    """Long-term response to repeated load cycles.

    Attributes
    ----------
    response : str
        "elastic": no plastic flow. "elastic shakedown": flow has ceased. "plastic shakedown":
        plastic flow cancels over each cycle. "ratcheting": each cycle adds as much plastic strain
        as the preceding one. "undecided": none of these responses has been found.
    rate : float
        Maximum magnitude of the plastic strain change over the last cycle [-]: `cycles[-1].net`.
    flow : float
        Maximum equivalent plastic strain added by the last cycle [-]: `cycles[-1].flow`.
    cycles : tuple of Cycle
        Solved cycles, without those that followed an extrapolation which was undone.
    solved : int
        Number of all solved cycles, including cycles after extrapolations that were undone.
    error : float
        Estimated maximum error of the plastic strain due to extrapolation [-]; 0 without
        extrapolation.
    rejected : int
        Number of extrapolations that were undone because the next cycle did not confirm them.
    yield_strain : float
        Yield strain (yield stress divided by Young's modulus) with which strains are compared [-];
        the smaller value if both bodies can yield.
    state : State
        State at the end of the last cycle.
    """

    response: str
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
        """Whether plastic strain ceases to grow (elastic or plastic shakedown)."""
        return self.response in (ELASTIC, SHAKEDOWN, PLASTIC)

    def strain_per_cycle(self, body: int = 2) -> FloatArray:
        """Return the plastic strain that the last cycle added to a body [-].

        Parameters
        ----------
        body : {1, 2}

        Returns
        -------
        ndarray, shape (6, rows, ny, nz)
            Tensor components in the cells of ``state.track(body, margin=0)``.

        Raises
        ------
        ValueError
            The body cannot yield.
        """
        return self._strain[choice("body", body, tuple(self._strain))]

    def residual_stress(self, body: int = 2) -> FloatArray:
        """Return the residual stress after the last cycle [Pa], see `State.residual_stress`."""
        return self.state.residual_stress(body)

    def _rows(self) -> Rows:
        rows = [
            ("response", self.response),
            ("plastic strain per cycle", f"{self.rate:.3g}"),
            ("plastic flow per cycle", f"{self.flow:.3g}"),
            ("yield strain", f"{self.yield_strain:.3g}"),
            ("cycles", f"{self.cycles[-1].number}, {self.solved} of which solved"),
        ]
        if self.error > 0:
            rows.append(("extrapolation error of plastic strain", f"{self.error:.2g}"))
        return rows
