# SPDX-License-Identifier: GPL-3.0-or-later
"""Traction curve: friction of a lubricated contact versus slide-to-roll ratio."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from .._util.checks import FloatArray, finite_array, integer, positive, require_type
from .._util.display import ShortRepr
from .film_solution import FilmSolution
from .friction import friction
from .nested import FilmTask, LevelSolver, state_of, table_of
from .sheared import sheared_from
from .steady import require_converged, solution_of


@dataclass(frozen=True, repr=False, eq=False)
class TractionCurve(ShortRepr):
    """Coefficient of friction versus slide-to-roll ratio, from `traction_curve`.

    Attributes
    ----------
    slide_to_roll : ndarray, shape (n,)
        Slide-to-roll ratios (u1 - u2)/((u1 + u2)/2) [-].
    coefficient : ndarray, shape (n,)
        Coefficients of friction, with the sign of the ratio [-].
    central_film : ndarray, shape (n,)
        Central film thicknesses [m].
    max_rise : ndarray, shape (n,)
        Largest temperature rises in the film [K]; zeros for a film without heating.
    """

    slide_to_roll: FloatArray
    coefficient: FloatArray
    central_film: FloatArray
    max_rise: FloatArray


def traction_curve(
    film: FilmSolution, slide_to_roll: ArrayLike, *, tol: float = 1e-6, max_iterations: int = 40
) -> TractionCurve:
    """Return the coefficient of friction versus slide-to-roll ratio at constant mean velocity.

    A film that was solved with `shear_thinning` or `thermal` is solved again at each ratio. Other
    films do not depend on the sliding. Their friction is too high at large ratios, because the
    heating of the film is neglected.

    slide_to_roll: ratios (u1 - u2)/((u1 + u2)/2) along the mean velocity [-], a list;
    tol, max_iterations: as for `steady`. Raises TypeError or ValueError where `friction` does, and
    ConvergenceError where `steady` does.
    """
    require_type("film", film, FilmSolution)
    tol, most = positive("tol", tol), integer("max_iterations", max_iterations, 1)
    ratios = finite_array("slide_to_roll", slide_to_roll)
    if ratios.ndim != 1 or not ratios.size:
        raise ValueError(
            f"slide_to_roll must be a list of numbers, got an array of shape {ratios.shape}"
        )
    mean = 0.5 * (film.velocities[0] + film.velocities[1])
    if not np.any(mean):
        raise ValueError(
            "the mean velocity of film must differ from 0, because slide_to_roll is relative to it"
        )
    if film.heat is not None and film.grid.ny == 1 and np.any(np.abs(ratios) == 2.0):
        raise ValueError(
            "for a heated line contact, slide_to_roll must not contain 2 or -2, which mean a "
            "surface at rest: its steady temperature under a line source is infinite"
        )
    is_sheared = film.shear_thinning or film.heat is not None
    found = np.zeros((3, ratios.size))
    # Each film starts from that at the ratio before, in both directions from pure rolling.
    for sign in (1.0, -1.0):
        solver = _ShearedFilms(film, tol, most) if is_sheared else None
        chosen = np.flatnonzero(ratios >= 0.0 if sign > 0.0 else ratios < 0.0)
        for n in chosen[np.argsort(np.abs(ratios[chosen]), kind="stable")]:
            velocities = _velocities(mean, float(ratios[n]))
            at = replace(film, velocities=velocities) if solver is None else solver.at(velocities)
            rise = 0.0 if at.heat is None else at.heat.max_rise
            coefficient = float(np.sign(ratios[n])) * friction(at).coefficient
            found[:, n] = coefficient, at.central_film, rise
    return TractionCurve(ratios, *found)


def _velocities(mean: FloatArray, ratio: float) -> FloatArray:
    return np.array([mean * (1.0 + 0.5 * ratio), mean * (1.0 - 0.5 * ratio)])


class _ShearedFilms:
    """Films with shear thinning or heat at several velocities; each starts from the last one."""

    def __init__(self, film: FilmSolution, tol: float, max_iterations: int) -> None:
        body1, body2 = film.bodies
        self._film = film
        self._task = FilmTask(
            (body1, body2), film.gap, True, film.load, film.velocities, film.spin, film.lubricant,
            film.supply, film.boundary, film.order, tol, max_iterations, film.shear_thinning,
            film.heat is not None,
        )  # fmt: skip
        peak = float(film.pressure.max())
        self._layer = self._task.layer(peak)
        self._solver = LevelSolver(self._task, film.grid, film.gap, table_of(film.lubricant, peak))
        self._state = {
            "fluid_pressure": film.fluid_pressure, "boundary_pressure": film.boundary_pressure,
            "void_fraction": 1.0 - film.filling, "approach": film.approach,
        }  # fmt: skip

    def at(self, velocities: FloatArray) -> FilmSolution:
        """Return the film at the given velocities of the surfaces [m/s], shape (2, 2)."""
        task = replace(self._task, velocities=velocities)
        self._solver.task = task
        found = sheared_from(self._solver, self._state, self._layer)
        require_converged(found, task)
        film = self._film
        self._state = state_of(found)
        return solution_of(film.grid, film.gap, task, found, [self._solver.level(found)])
