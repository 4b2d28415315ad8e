# SPDX-License-Identifier: GPL-3.0-or-later
"""Figure of a parameter study: quantities of all cases versus the parameters."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .._util.quantities import Quantity
from .parts import finish, new_figure, prefixed

MAX_PANELS = 6
"""Maximum number of quantities in the figure."""
MAX_LINES = 8
"""Maximum number of curves with an entry in the legend."""
_MAX_LABEL = 24  # characters of a value that is text
_PREFIXED = ("m", "N", "Pa", "s", "J")
_MIN_VARIATION = 1e-9  # relative to the largest magnitude


def study_figure(
    parameters: Mapping[str, Sequence[Any]],
    units: Mapping[str, str],
    quantities: Mapping[str, Quantity],
    values: Mapping[str, Sequence[Any]],
) -> Figure | None:
    """Return a figure with one panel for each quantity that varies between the cases.

    The horizontal axis shows the first parameter that has several values and whose values are
    numbers. If there is no such parameter, it shows the first parameter with several values. All
    other parameters distinguish the curves. At most `MAX_PANELS` quantities are drawn. Return None
    if no quantity or no parameter varies. The arguments are the attributes of a `SweepSummary`.
    """
    shown = [name for name in quantities if _varies(values[name])][:MAX_PANELS]
    varied = [name for name, column in parameters.items() if len(set(map(str, column))) > 1]
    if not shown or not varied:
        return None
    along = next((name for name in varied if _are_numbers(parameters[name])), varied[0])
    others = [name for name in varied if name != along]
    if all(_follows(parameters[along], parameters[name]) for name in others):
        others = []  # values combined pairwise
    columns = min(len(shown), 3)
    rows = math.ceil(len(shown) / columns)
    figure = new_figure(max(5.0, 3.4 * columns), 2.9 * rows + 0.4)
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    groups = {"": list(range(len(parameters[along])))}
    if others:
        groups = _grouped({name: parameters[name] for name in others}, units)
    for ax, name in zip(panels, shown, strict=False):
        _panel(ax, (along, parameters[along], units[along]), quantities[name], values[name], groups)
    for ax in panels[len(shown) :]:
        ax.set_visible(False)
    if len(groups) > 1:
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper center", frameon=False,
                      fontsize="small", ncols=min(len(labels), 3))  # fmt: skip
    return figure


def _panel(
    ax: Axes, along: tuple[str, Sequence[Any], str], quantity: Quantity, column: Sequence[Any],
    groups: Mapping[str, list[int]],
) -> None:  # fmt: skip
    name, given, unit = along
    x, places = _positions(given)
    factor, shown = 1.0, unit if unit != "1" else ""
    if places is None and unit in _PREFIXED:
        factor, shown = prefixed(float(np.abs(x).max()), unit)
    y, words = _positions(column)
    y = y * (1.0 if words is not None else quantity.factor)
    for number, (label, cases) in enumerate(groups.items()):
        at = np.array(cases)[np.argsort(x[cases], kind="stable")]
        style = "o" if places is not None or words is not None else "o-"
        ax.plot(x[at] * factor, y[at], style, markersize=3.5, linewidth=1.2,
                label=label if number < MAX_LINES else None)  # fmt: skip
    heading = (quantity.heading or quantity.short).replace("\n", " ")
    ax.set(xlabel=f"{name} [{shown}]" if shown else name,
           ylabel=f"{heading} [{quantity.shown}]" if quantity.shown else heading)  # fmt: skip
    ax.yaxis.label.set_fontsize("small")
    if places is not None:
        ax.set_xticks(range(len(places)), [_short(text) for text in places], rotation=20,
                      ha="right")  # fmt: skip
        ax.margins(x=0.1)
    if words is not None:
        ax.set_yticks(range(len(words)), words)
        ax.margins(y=0.2)
    finish(ax)


def _positions(column: Sequence[Any]) -> tuple[np.ndarray[Any, Any], list[str] | None]:
    """Return the axis positions of values, and tick labels if the values are words.

    Numbers are returned unchanged, without tick labels (None). Different words are placed at 0, 1,
    2, ...
    """
    if _are_numbers(column):
        return np.asarray(column, dtype=np.float64), None
    words = [word for word in dict.fromkeys(map(str, column)) if word]
    return np.array([words.index(str(v)) if str(v) else math.nan for v in column]), words


def _are_numbers(column: Sequence[Any]) -> bool:
    return all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in column)


def _varies(column: Sequence[Any]) -> bool:
    if not _are_numbers(column):
        return len({v for v in column if v}) > 1
    numbers = np.asarray(column, dtype=np.float64)
    known = numbers[np.isfinite(numbers)]
    return known.size > 1 and float(np.ptp(known)) > _MIN_VARIATION * float(np.abs(known).max())


def _follows(first: Sequence[Any], second: Sequence[Any]) -> bool:
    """Whether the value of the first parameter determines the value of the second."""
    pairs = {(str(a), str(b)) for a, b in zip(first, second, strict=True)}
    return len(pairs) == len(set(map(str, first)))


def _grouped(
    parameters: Mapping[str, Sequence[Any]], units: Mapping[str, str]
) -> dict[str, list[int]]:
    """Group the cases that have equal values of all given parameters, for the legend.

    Return the indices of the cases of each group by a label that states these values.
    """
    groups: dict[str, list[int]] = {}
    for number, values in enumerate(zip(*parameters.values(), strict=True)):
        named = zip(parameters, values, strict=True)
        label = ", ".join(f"{name} = {_text(value, units[name])}" for name, value in named)
        groups.setdefault(label, []).append(number)
    return groups


def _text(value: Any, unit: str) -> str:
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        if unit in _PREFIXED:
            factor, shown = prefixed(abs(value), unit)
            return f"{value * factor:.4g} {shown}"
        return f"{value:.4g} {unit if unit != '1' else ''}".strip()
    return _short(str(value))


def _short(text: str) -> str:
    return text if len(text) <= _MAX_LABEL else f"{text[: _MAX_LABEL - 1]}…"
