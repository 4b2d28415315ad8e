# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of lubricated contacts: film, pressure, interference fringes and Stribeck curve."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes

from .._util.checks import FloatArray, finite, finite_array, positive, require_type
from .._util.display import quantity
from .._util.lazy_scipy import scipy
from ..lubricants import Lubricant
from ..lubrication import FilmSolution, StribeckCurve, friction, regime
from ..lubrication.formulas import regime_of
from ..lubrication.groups import Contact, film_groups
from .parts import MIN_LONG_CONTACT_RATIO, add_to_title, axes_or_new, finish, prefixed

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

MAX_SHOWN_FILM = 3.0
"""Largest film thickness shown in a map, relative to the central film thickness."""
_POINTS_PER_CELL = 6
_PIXELS = 250.0  # of an interferogram, along its longer side
_LABEL_WIDTH, _LABEL_HEIGHT = 1.2, 0.5  # of a label in the chart of regimes, decades
_MIN_EDGE_RATIO = 2.0  # of the ends of the axis and the middle of a label
_REGIMES = (
    "rigid-isoviscous", "elastic-isoviscous", "rigid-piezoviscous", "elastic-piezoviscous",
)  # fmt: skip
_REGIME_COLOURS = ("#dfe8f2", "#f4e3d7", "#e2efdf", "#f1e6ef")
WAVELENGTH, REFRACTIVE_INDEX = 600e-9, 1.5
"""Defaults of an interferogram: wavelength of red light [m], refractive index of oil under
pressure [-]."""


def film_map(film: FilmSolution, ax: Axes | None = None, *, max_film: float | None = None) -> Axes:
    """Draw a map of the film thickness of a lubricated contact, with contour lines.

    Parameters
    ----------
    film : FilmSolution
        Solution of `samcontact.lubrication.steady`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    max_film : float, optional
        Film thickness at the end of the colour scale [m]. Default: three times the central film.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        `film` is the film of a line contact, or `max_film` is not positive.
    TypeError
        `film` is not a `FilmSolution`.
    """
    require_type("film", film, FilmSolution)
    limit = (
        MAX_SHOWN_FILM * film.central_film if max_film is None else positive("max_film", max_film)
    )
    factor, unit = prefixed(limit, "m")
    plane = _Plane(film, ax)
    ax, field = plane.ax, plane.oriented(film.film) * factor
    shown = ax.pcolormesh(
        plane.across, plane.along, field, cmap="viridis", vmin=0.0, vmax=limit * factor,
        rasterized=True, shading="nearest",
    )  # fmt: skip
    ax.contour(
        plane.across, plane.along, field, levels=np.linspace(0.0, limit * factor, 13)[1:],
        colors="white", linewidths=0.5,
    )  # fmt: skip
    place: dict[str, Any] = {"location": "bottom"} if plane.is_turned else {}
    ax.figure.colorbar(shown, ax=ax, label=f"film thickness [{unit}]", extend="max", **place)
    _note_films(ax, film)
    return finish(ax)


def film_profile(
    film: FilmSolution,
    ax: Axes | None = None,
    *,
    max_film: float | None = None,
    max_pressure: float | None = None,
) -> Axes:
    """Draw pressure and film thickness along x through the middle of a lubricated contact.

    The profile passes through the cell with the smallest gap of the undeformed surfaces. film:
    solution of `samcontact.lubrication.steady`; ax: axes to draw on, default a new figure;
    max_film: largest film thickness shown [m], default three times the central film; max_pressure:
    largest pressure shown [Pa], default the maximum pressure of the film. Returns the axes of the
    pressure. Raises TypeError if `film` is not a `FilmSolution`, and ValueError if `max_film` or
    `max_pressure` is not positive.
    """
    require_type("film", film, FilmSolution)
    ax = axes_or_new(ax)
    row = _middle_row(film)
    length, metres = prefixed(float(np.abs(film.grid.x).max()), "m")
    highest = film.pressure.max() if max_pressure is None else max_pressure
    factor, pascals = prefixed(positive("max_pressure", float(highest)), "Pa")
    limit = (
        MAX_SHOWN_FILM * film.central_film if max_film is None else positive("max_film", max_film)
    )
    thickness, unit = prefixed(limit, "m")
    x = film.grid.x * length
    ax.plot(x, film.pressure[:, row] * factor, "C0-", label="pressure")
    if film.boundary is not None:
        ax.fill_between(
            x, 0.0, film.boundary_pressure[:, row] * factor, color="C0", alpha=0.3, linewidth=0,
            label="boundary layer",
        )  # fmt: skip
    ax.set_xlabel(f"x [{metres}]")
    ax.set_ylabel(f"pressure [{pascals}]", color="C0")
    ax.set_ylim(bottom=0.0)
    if max_pressure is not None:
        ax.set_ylim(0.0, 1.05 * max_pressure * factor)
    right = ax.twinx()
    right.plot(x, film.film[:, row] * thickness, "C3-", label="film")
    right.set_ylabel(f"film thickness [{unit}]", color="C3")
    right.set_ylim(0.0, limit * thickness)
    _note_films(ax, film)
    return finish(ax)


def film_temperature(film: FilmSolution, ax: Axes | None = None) -> Axes:
    """Draw the temperature rise along x in the middle of the film and at both surfaces.

    The profile passes through the cell with the smallest gap of the undeformed surfaces. film:
    solution of `samcontact.lubrication.steady` with `thermal=True`; ax: axes to draw on, default a
    new figure. Returns the axes. Raises TypeError if `film` is not a `FilmSolution`, and ValueError
    if it was solved without `thermal=True`.
    """
    require_type("film", film, FilmSolution)
    if film.heat is None:
        raise ValueError(
            "film must have temperatures, got an isothermal film: solve it with thermal = True"
        )
    ax = axes_or_new(ax)
    row = _middle_row(film)
    length, metres = prefixed(float(np.abs(film.grid.x).max()), "m")
    x = film.grid.x * length
    ax.plot(x, film.heat.middle_rise[:, row], "C3-", label="middle of the film")
    for number, style in ((1, "C0-"), (2, "C2--")):
        label = f"surface of body {number}"
        ax.plot(x, film.heat.surface_rise[number - 1][:, row], style, label=label)
    ax.set_xlabel(f"x [{metres}]")
    ax.set_ylabel("temperature rise [K]")
    ax.set_ylim(bottom=0.0)
    ax.legend(fontsize="small")
    return finish(ax)


def interferogram(
    film: FilmSolution,
    ax: Axes | None = None,
    *,
    wavelength: float = WAVELENGTH,
    refractive_index: float = REFRACTIVE_INDEX,
    phase: float = 0.0,
) -> Axes:
    """Draw the interference fringes of a film between a glass disc and a body.

    The intensity is cos^2(2 pi n h/wavelength + phase), where n is the refractive index and h the
    film thickness. It is averaged over each pixel, so fringes narrower than a pixel appear grey.

    Parameters
    ----------
    film : FilmSolution
        Solution of `samcontact.lubrication.steady`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw on; default: a new figure.
    wavelength : float, optional
        Wavelength of the light in vacuum [m].
    refractive_index : float, optional
        Refractive index n of the lubricant [-].
    phase : float, optional
        Phase at zero film thickness, due to the reflections at both surfaces [rad].

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        `film` is the film of a line contact, or a number is outside its range.
    TypeError
        `film` is not a `FilmSolution`.
    """
    require_type("film", film, FilmSolution)
    wave = positive("wavelength", wavelength)
    index, shift = positive("refractive_index", refractive_index), finite("phase", phase)
    plane = _Plane(film, ax)
    ax, across, along = plane.ax, plane.across, plane.along
    # between the centres of the cells too, where fringes are narrower than a cell
    thickness = scipy.ndimage.zoom(plane.oriented(film.film), _POINTS_PER_CELL, order=3)
    path = 4.0 * np.pi * index * thickness / wave + 2.0 * shift
    intensity = 0.5 + 0.5 * np.cos(path) * _contrast(path)
    ax.pcolormesh(
        np.linspace(across[0], across[-1], intensity.shape[1]),
        np.linspace(along[0], along[-1], intensity.shape[0]),
        intensity, cmap="gray", vmin=0.0, vmax=1.0, rasterized=True, shading="nearest",
    )  # fmt: skip
    add_to_title(ax, f"wavelength {quantity(wave, 'm')}, refractive index {index:g}")
    return finish(ax)


def stribeck_curve(curve: StribeckCurve, ax: Axes | None = None) -> Axes:
    """Draw the share of the load on the boundary layer, and the friction coefficient, versus speed.

    curve: result of `samcontact.lubrication.stribeck`; friction is drawn only if the slide-to-roll
    ratio is not 0. ax: axes to draw on, default a new figure. Returns the axes that show the share
    of the load. Raises TypeError if `curve` is not a `StribeckCurve`, and ValueError in the cases
    in which `samcontact.lubrication.friction` does.
    """
    require_type("curve", curve, StribeckCurve)
    coefficients = np.array([friction(film).coefficient for film in curve.solutions])
    return stribeck_lines(curve.speed, curve.boundary_share, coefficients, ax)


def stribeck_lines(
    speed: FloatArray, boundary_share: FloatArray, coefficient: FloatArray, ax: Axes | None = None
) -> Axes:
    """Draw the share of the load on the boundary layer, and friction, versus mean speed [m/s].

    boundary_share: share of the load on the boundary layer [-]; coefficient: friction coefficient
    [-]; both have the length of `speed`. Friction is drawn only if a coefficient is not zero.
    Returns the axes that show the share of the load.
    """
    ax = axes_or_new(ax)
    ax.semilogx(speed, 100.0 * boundary_share, "C0o-", markersize=3)
    ax.set_xlabel("mean speed [m/s]")
    ax.set_ylabel("load on the boundary layer [%]", color="C0")
    ax.set_ylim(0.0, 105.0)
    if np.nan_to_num(coefficient).any():
        right = ax.twinx()
        right.semilogx(speed, coefficient, "C3s-", markersize=3)
        right.set_ylabel("friction coefficient [-]", color="C3")
        right.set_ylim(bottom=0.0)
    return finish(ax)


def traction_curve(
    slide_to_roll: ArrayLike, coefficient: ArrayLike, ax: Axes | None = None
) -> Axes:
    """Draw the friction coefficient versus slide-to-roll ratio.

    slide_to_roll, coefficient: arrays of `samcontact.lubrication.TractionCurve` [-]; ax: axes to
    draw on, default a new figure. Returns the axes. Raises ValueError if the shapes differ.
    """
    ratio = finite_array("slide_to_roll", slide_to_roll)
    values = finite_array("coefficient", coefficient, ratio.shape)
    ax = axes_or_new(ax)
    order = np.argsort(ratio.ravel())
    ax.plot(ratio.ravel()[order], values.ravel()[order], "C0o-", markersize=3)
    ax.set_xlabel("slide-to-roll ratio [-]")
    ax.set_ylabel("friction coefficient [-]")
    return finish(ax)


def regime_chart(
    contact: Contact, speed: tuple[float, float], lubricant: Lubricant, ax: Axes | None = None
) -> Axes:
    """Draw the map of lubrication regimes in terms of Moes' numbers; a dot marks the contact.

    The limits of the regimes are calculated for the ratio of radii of this contact. contact, speed,
    lubricant: as for `samcontact.lubrication.regime`; ax: axes to draw on, default a new figure.
    Returns the axes. Raises the errors of `samcontact.lubrication.regime`.
    """
    here = regime(contact, speed, lubricant)  # refuses other contacts
    found = film_groups(contact, speed, lubricant)
    M, L = found.moes
    shape = found.approach / found.scale / M ** (2.0 / 3.0)  # Hertz: load^(2/3)
    loads = np.geomspace(min(1e-2, 0.1 * M), max(1e5, 10.0 * M), 121)
    oils = np.geomspace(min(1e-2, 0.1 * L) if L > 0.0 else 1e-2, max(1e2, 10.0 * L), 81)
    kinds = np.array(
        [
            [_REGIMES.index(regime_of(m, n, found.D, shape * m ** (2.0 / 3.0))) for n in oils]
            for m in loads
        ]
    )
    ax = axes_or_new(ax)
    for number, (name, colour) in enumerate(zip(_REGIMES, _REGIME_COLOURS, strict=True)):
        inside = kinds == number
        if inside.any():
            ax.contourf(loads, oils, inside.T.astype(float), levels=[0.5, 1.5], colors=[colour])
            i, j = inside.nonzero()
            m, n = _label_place(loads[i], oils[j], (M, max(L, float(oils[0]))))
            n = float(np.clip(n, oils[0] * _MIN_EDGE_RATIO, oils[-1] / _MIN_EDGE_RATIO))
            ax.text(m, n, name.replace("-", "\n"), ha="center", va="center", fontsize="small")
    ax.plot([M], [max(L, oils[0])], "ko", markersize=5)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel("load number M [-]")
    ax.set_ylabel("lubricant number L [-]")
    ax.set_title(f"{here}, $a_y/a_x$ = {found.k:.3g}", fontsize="medium")
    return finish(ax)


def _middle_row(film: FilmSolution) -> int:
    """Return the index in y of the cell with the smallest gap of the undeformed surfaces."""
    return int(np.unravel_index(int(np.argmin(film.smooth_gap)), film.gap.shape)[1])


def _label_place(
    loads: FloatArray, oils: FloatArray, dot: tuple[float, float]
) -> tuple[float, float]:
    """Return the position of the label of a region of the chart, away from the dot if possible.

    The label is placed in the middle of the region. If it would hide the dot there, it is placed in
    the middle of the part of the region above or below the dot. loads, oils: Moes' numbers M and L
    of the points of the region. dot: M and L of the contact.
    """
    away = np.abs(np.log10(oils / dot[1])) > _LABEL_HEIGHT
    for part in (np.full(loads.shape, True), away & (oils > dot[1]), away & (oils < dot[1])):
        if not part.any():
            continue
        m, n = (float(np.exp(np.log(v[part]).mean())) for v in (loads, oils))
        far = abs(np.log10(n / dot[1])) > _LABEL_HEIGHT or abs(np.log10(m / dot[0])) > _LABEL_WIDTH
        if far:
            return m, n
    return m, n


class _Plane:
    """Axes of a map, with the cell coordinates in the unit of the axes.

    If the contact is long along y, the map is rotated: y is horizontal and x is vertical.
    """

    def __init__(self, film: FilmSolution, ax: Axes | None) -> None:
        if min(film.film.shape) < 2:
            raise ValueError(
                "film must have several cells along x and y, got a line contact: draw it with "
                "film_profile"
            )
        grid = film.grid
        self.is_turned = grid.ny * grid.dy > MIN_LONG_CONTACT_RATIO * grid.nx * grid.dx
        self.ax = axes_or_new(ax)
        shown = grid.y if self.is_turned else grid.x
        factor, metres = prefixed(float(np.abs(shown).max()), "m")
        places = {"x": grid.x * factor, "y": grid.y * factor}
        names = ("y", "x") if self.is_turned else ("x", "y")
        self.across, self.along = (places[name] for name in names)
        self.ax.set_aspect("equal")
        self.ax.set_xlabel(f"{names[0]} [{metres}]")
        self.ax.set_ylabel(f"{names[1]} [{metres}]")

    def oriented(self, field: FloatArray) -> FloatArray:
        """Return a field as drawn: its first index runs vertically, its second horizontally."""
        return field if self.is_turned else field.T


def _contrast(path: FloatArray) -> FloatArray:
    """Return the fringe contrast [-] that remains after averaging over a pixel of the figure.

    path: values of the argument of the cosine in the intensity 0.5 (1 + cos(path)) at the image
    points [rad].
    """
    pixel = max(1.0, max(path.shape) / _PIXELS)
    slopes = np.gradient(path)
    contrast: FloatArray = np.prod([np.sinc(0.5 * pixel * s / np.pi) for s in slopes], axis=0)
    # side lobes of the average would be false fringes
    return np.where(np.max(np.abs(slopes), axis=0) * pixel < 2.0 * np.pi, contrast, 0.0)


def _note_films(ax: Axes, film: FilmSolution) -> None:
    central, minimum = (quantity(h, "m", 3) for h in (film.central_film, film.minimum_film))
    add_to_title(ax, f"central film {central}, minimum {minimum}")
