# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of docs/peers.md: error against relative time, and ratio of times against size."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from ..plots import COLOURS, MARKERS
from .page import COUNTED_AT, MEASURE, OURS, TITLES, Ladder, by_place, points, ratio_at, time_at
from .running import CODES

TIME = "with_setup_s"


def style(code: str) -> dict[str, str]:
    number = list(CODES).index(code)
    return {"color": COLOURS[number], "marker": MARKERS[number], "label": code}


def draw_precision(axes: Axes, codes: dict[str, Ladder], problem: str) -> None:
    """Draw error against time; times are relative to samcontact at the error `COUNTED_AT`."""
    unit = time_at(points(codes[OURS], MEASURE[problem], TIME), COUNTED_AT[problem])
    for code, ladder in codes.items():
        curve = points(ladder, MEASURE[problem], TIME)
        if curve and unit:
            errors, times = zip(*curve, strict=True)
            axes.loglog([t / unit for t in times], errors, markersize=5, **style(code))
    axes.set(xlabel="time / time of samcontact [-]", ylabel=f"rms error of {MEASURE[problem]} [-]")
    axes.grid(True, which="major", alpha=0.3)


def draw_ratios(axes: Axes, places: dict[int, dict[str, Ladder]], problem: str) -> None:
    """Draw the time relative to samcontact at equal error against the number of cells across."""
    for code in CODES:
        found = {}
        for n, codes in places.items():
            if code in codes:
                found[n] = ratio_at(codes, code, MEASURE[problem], TIME, COUNTED_AT[problem])
        known = {n: ratio for n, ratio in found.items() if ratio}
        if known:
            axes.loglog(list(known), list(known.values()), markersize=5, **style(code))
    axes.set_xticks(sorted(places), [str(n) for n in sorted(places)])
    axes.xaxis.set_minor_formatter(NullFormatter())
    target = f"{COUNTED_AT[problem]:.0e}".replace("e-0", "e-")
    axes.set(xlabel="cells across [-]", ylabel=f"time / time of samcontact at error {target} [-]")
    axes.grid(True, which="major", alpha=0.3)


def figure(data: dict[str, Any], problem: str) -> Figure | None:
    """Return the figure of a problem, with a row of axes for each case."""
    by_case: dict[str, dict[int, dict[str, Ladder]]] = {}
    for (name, case, n), codes in by_place(data).items():
        if name == problem and OURS in codes:
            by_case.setdefault(case, {})[n] = codes
    if not by_case:
        return None
    drawn = Figure(figsize=(9, 3.4 * len(by_case) + 0.5), layout="constrained")
    grid = drawn.subplots(len(by_case), 2, squeeze=False)
    for (left, right), (case, places) in zip(grid, by_case.items(), strict=True):
        # The largest size solved by most codes.
        max_codes = max(len(codes) for codes in places.values())
        n = max(n for n, codes in places.items() if len(codes) == max_codes)
        draw_precision(left, places[n], problem)
        draw_ratios(right, places, problem)
        left.set_title(", ".join([f"{n}² cells", *([case] if case else [])]))
    names: dict[str, Any] = {}
    for axes in grid.ravel():
        handles, labels = axes.get_legend_handles_labels()
        names.update(zip(labels, handles, strict=True))
    drawn.legend(list(names.values()), list(names), loc="outside lower center", ncols=3)
    drawn.suptitle(TITLES[problem])
    return drawn


def draw(data: dict[str, Any]) -> dict[str, Figure]:
    """Return the figures of the problems with measurements, by file name."""
    drawn = {f"peers_{problem}.png": figure(data, problem) for problem in MEASURE}
    return {name: one for name, one in drawn.items() if one is not None}
