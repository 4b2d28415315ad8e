# SPDX-License-Identifier: GPL-3.0-or-later
"""Animation of a moving contact: pressure, section and residual imprint, in the frame of a body."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.animation import AbstractMovieWriter, FFMpegWriter, FuncAnimation, PillowWriter
from matplotlib.axes import Axes
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D

from .._util.checks import FloatArray, choice, positive
from .._util.quantities import CONTACT
from ..files.atomic import replacing
from ..solutions.state import on_common_grid
from .parts import edges, finish, nearest, new_figure, require_volume
from .track import positions_on_body

if TYPE_CHECKING:
    from ..solutions.state import State

_WIDTH = 8.0
_QUANTITIES = ("von_mises", "residual_von_mises", "equivalent_plastic_strain")


def rolling_animation(
    states: Sequence[State], *, body: int = 2, quantity: str = "von_mises", interval: float = 100.0
) -> FuncAnimation:
    """Animate a moving contact: pressure, longitudinal section and residual imprint of each state.

    All fields are shown in the plane y = 0 and in the frame of reference of the chosen body. In
    this frame the contact moves, and the residual imprint is at rest.

    Parameters
    ----------
    states : sequence of State
        States on a grid with layers, in the order of the path. To halve the computing time, pass
        ``states[::2]``.
    body : {1, 2}
        Body whose frame of reference, section and residual imprint are shown.
    quantity : {"von_mises", "residual_von_mises", "equivalent_plastic_strain"}
        Quantity shown in the section. With "von_mises", the stress under load is shown inside the
        grid, which moves with the contact and whose edges are dotted lines. Outside the grid, the
        residual stress is shown where the body has yielded. Cells without a computed stress are
        grey.
    interval : float, optional
        Interval between frames during playback [ms], > 0.

    Returns
    -------
    matplotlib.animation.FuncAnimation
        Animation for `save_animation`, or ``to_jshtml()`` in a notebook. Assign it to a variable:
        Matplotlib deletes animations that no variable refers to.

    Raises
    ------
    ValueError
        `states` is empty, the grid has no layers, `body` or `quantity` is unknown, or `interval` is
        not positive.
    """
    if len(states) == 0:
        raise ValueError("states must contain at least one state, got none")
    choice("body", body, (1, 2))
    choice("quantity", quantity, _QUANTITIES)
    positive("interval", interval)
    states = on_common_grid(states)
    grid = states[0].grid
    require_volume(grid)
    assert grid.dz is not None
    depths = max((state.depths for state in states), key=len)
    states = [state.at_layers(len(depths)) for state in states]
    row = nearest(grid.y, 0.0)

    windows = [positions_on_body(state, body) for state in states]
    first = min(window[0] for window in windows)
    count = round((max(window[-1] for window in windows) - first) / grid.dx) + 1
    x = first + grid.dx * np.arange(count)
    sections = [
        _section(state, body, quantity, row, window, x)
        for state, window in zip(states, windows, strict=True)
    ]
    imprints = [_imprint(state, body, row) for state in states]
    pressures = [state.pressure[:, row] * CONTACT["pressure"].factor for state in states]

    shown = CONTACT[quantity]
    across, depth = edges(x, grid.dx) * 1e6, edges(depths, grid.dz) * 1e6
    ratio = min(max(0.8 * _WIDTH * depth[-1] / (across[-1] - across[0]), 1.4), 3.0)
    figure = new_figure(_WIDTH, ratio + 4.0)
    above, middle, below = figure.subplots(3, 1, sharex=True, height_ratios=[1.5, ratio, 1.5])
    pressure_line = _pressure_panel(above, pressures)
    largest = shown.factor * max(float(np.nanmax(s)) for s in sections)
    image, frame = _section_panel(middle, across, depth, quantity, largest)
    imprint_line = _imprint_panel(below, imprints, body)
    below.set_xlim(across[0], across[-1])

    def draw(number: int) -> list[Any]:
        state = states[number]
        place = -state.travel[body - 1]
        pressure_line.set_data((np.asarray(grid.x) - state.origin + place) * 1e6, pressures[number])
        image.set_data(sections[number].T * shown.factor)
        imprint_line.set_data(imprints[number][0] * 1e6, imprints[number][1] * 1e6)
        ends = edges(windows[number], grid.dx)[[0, -1]] * 1e6
        for line, end in zip(frame, ends, strict=True):
            line.set_xdata([end, end])
        above.set_title(
            f"load {state.load:.4g} N, contact at {place * 1e6 + 0.0:.4g} µm", fontsize="medium"
        )
        return [pressure_line, image, imprint_line, *frame]

    draw(0)
    figure.align_ylabels()
    figure.draw_without_rendering()
    figure.set_layout_engine("none")  # panels must not move between frames
    return FuncAnimation(
        figure, draw, frames=len(states), interval=interval, cache_frame_data=False, blit=False
    )


def _pressure_panel(ax: Axes, pressures: list[FloatArray]) -> Line2D:
    (line,) = ax.plot([], [], "-", linewidth=1.2, color="C3")
    ax.set_ylim(0.0, 1.08 * max(float(np.max(p)) for p in pressures) or 1.0)
    ax.set_ylabel(CONTACT["pressure"].label)
    finish(ax)
    return line


def _section_panel(
    ax: Axes, across: FloatArray, depth: FloatArray, quantity: str, largest: float
) -> tuple[AxesImage, list[Line2D]]:
    """Draw an empty section; return its image and the two lines that mark the edges of the grid."""
    shown = CONTACT[quantity]
    empty = np.zeros((len(depth) - 1, len(across) - 1))
    image = ax.imshow(
        empty,
        cmap=shown.colours,
        vmin=0.0,
        vmax=largest or 1.0,
        extent=(across[0], across[-1], depth[-1], depth[0]),
        aspect="auto",
        interpolation="bilinear",
    )
    ax.figure.colorbar(image, ax=ax)
    framed = quantity == "von_mises"
    grey = "" if quantity == "equivalent_plastic_strain" else ", grey: not computed"
    edge = ", dotted: edge of the grid (residual stress outside)" if framed else ""
    ax.set_title(f"{shown.label}{grey}{edge}", fontsize="medium")
    ax.set_facecolor("0.85")
    frame = [ax.axvline(color="C3", linestyle=":", linewidth=framed) for _ in range(2)]
    ax.set_ylabel("depth z [µm]")
    return image, frame


def _imprint_panel(ax: Axes, imprints: list[tuple[FloatArray, FloatArray]], body: int) -> Line2D:
    (line,) = ax.plot([], [], "-", linewidth=1.2, color="C0")
    heights = np.concatenate([u for _, u in imprints]) * 1e6
    margin = 0.08 * float(np.ptp(heights)) or 1.0
    ax.set_ylim(float(heights.max()) + margin, float(heights.min()) - margin)
    ax.set_xlabel(f"x on body {body} [µm]")
    ax.set_ylabel(CONTACT["residual_displacement"].label)
    finish(ax)
    return line


def _section(
    state: State, body: int, quantity: str, row: int, window: FloatArray, x: FloatArray
) -> FloatArray:
    """Return a field of the body in the plane y = 0 at positions x, shape (len(x), nz).

    Stresses that were not computed are NaN. Strains outside the track (the region that the contact
    has passed) are 0. row: index along y of the row of cells. window: x positions of the cells of
    the grid in the frame of reference of the body [m].
    """
    # outside the track nothing has yielded, but stresses exist
    beyond = 0.0 if quantity == "equivalent_plastic_strain" else np.nan
    values = np.full((len(x), len(state.depths)), beyond)
    track = state.track(body=body)
    field = "residual_von_mises" if quantity == "von_mises" else quantity
    rows = np.round((track.x - x[0]) / state.grid.dx).astype(int)
    shown = (rows >= 0) & (rows < len(x))
    if quantity == "von_mises":  # outside the plastic zone the stress is due to the load
        shown &= np.any(track.equivalent_plastic_strain() > 0, axis=(1, 2))
    values[rows[shown]] = getattr(track, field)()[shown, row, :]
    if quantity == "von_mises":
        start = round((window[0] - x[0]) / state.grid.dx)
        values[start : start + len(window)] = state.von_mises(body=body)[:, row, :]
    return values


def _imprint(state: State, body: int, row: int) -> tuple[FloatArray, FloatArray]:
    track = state.track(body=body)
    return track.x, track.residual_displacement()[:, row]


def save_animation(
    animation: FuncAnimation, path: str | Path, *, fps: float = 10.0, dpi: float = 100.0
) -> Path:
    """Write an animation as GIF or MP4.

    Parameters
    ----------
    animation : matplotlib.animation.FuncAnimation
        Result of `rolling_animation`, `partial_slip_animation` or `film_animation`.
    path : str or Path
        File name that ends in .gif or .mp4. Writing .mp4 requires the program ffmpeg.
    fps : float, optional
        Frames per second, > 0.
    dpi : float, optional
        Pixels per inch, > 0.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    ValueError
        The file name ends in neither .gif nor .mp4, or `fps` or `dpi` is not positive.
    RuntimeError
        The program ffmpeg, required for .mp4, is missing.
    OSError
        The file cannot be written.
    """
    target, rate = Path(path), positive("fps", fps)
    writer: AbstractMovieWriter
    if target.suffix.lower() == ".gif":
        writer = PillowWriter(fps=rate)  # type: ignore[arg-type]  # also accepts fractions
    elif target.suffix.lower() == ".mp4":
        if not FFMpegWriter.isAvailable():
            raise RuntimeError(
                "writing .mp4 requires the program ffmpeg, which was not found: install ffmpeg, or "
                "write a file that ends in .gif"
            )
        writer = FFMpegWriter(fps=rate)  # type: ignore[arg-type]
    else:
        raise ValueError(f"path must end in .gif or .mp4, got {str(target)!r}")
    resolution = positive("dpi", dpi)
    with replacing(target, target.suffix) as part:
        animation.save(part, writer=writer, dpi=resolution)
    return target
