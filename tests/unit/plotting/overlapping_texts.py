# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts of a figure that overlap each other or foreign axes."""

from __future__ import annotations

from contextlib import contextmanager
from itertools import combinations
from unittest.mock import patch

from matplotlib.figure import Figure

SLACK = 0.5  # [pt]


@contextmanager
def overlaps_when_saved():
    """Collect the overlapping pairs of each saved figure, {figure: pairs}.

    A figure is laid out before it is saved, where its tight box is asked for; to draw it once more
    would take as long again.
    """
    found, tight = {}, Figure.get_tightbbox

    def look(figure, renderer=None, *args, **options):
        found[figure] = overlaps(figure, renderer or figure.canvas.get_renderer())
        return tight(figure, renderer, *args, **options)

    with patch.object(Figure, "get_tightbbox", look):
        yield found


def overlaps(figure, renderer=None):
    """Return overlapping pairs; texts within their own axes, such as legends, are permitted.

    A figure that was drawn by a renderer is not drawn again.
    """
    if renderer is None:
        figure.draw_without_rendering()
        renderer = figure.canvas.get_renderer()
    shrink = -SLACK * figure.dpi / 72
    boxes = [
        (text.get_text(), ax, text.get_window_extent(renderer).padded(shrink))
        for ax in figure.axes
        for text in texts(ax)
    ]
    pairs = [
        (one, other)
        for (one, _, a), (other, _, b) in combinations(boxes, 2)
        if a.overlaps(b) and a.width > 0 and b.width > 0
    ]
    areas = [(ax, ax.get_window_extent(renderer).padded(shrink)) for ax in figure.axes]
    return pairs + [
        (name, "another plot")
        for name, own, box in boxes
        for ax, area in areas
        if ax is not own and box.overlaps(area)
    ]


def texts(ax):
    """Return visible texts of axes: labels, title, legend, annotations, ticks within the limits."""
    legend = ax.get_legend()
    found = [ax.xaxis.label, ax.yaxis.label, ax.title, *ax.texts]
    found += [ax.xaxis.get_offset_text(), ax.yaxis.get_offset_text()]
    found += [] if legend is None else [*legend.get_texts(), legend.get_title()]
    for axis in (ax.xaxis, ax.yaxis):
        low, high = sorted(axis.get_view_interval())
        room = 1e-9 * (high - low)
        for tick in axis.get_major_ticks():
            if low - room <= tick.get_loc() <= high + room:
                found += [tick.label1, tick.label2]
    return [text for text in found if text.get_visible() and text.get_text().strip()]
