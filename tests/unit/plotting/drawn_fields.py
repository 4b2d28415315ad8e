# SPDX-License-Identifier: GPL-3.0-or-later
"""Values represented by the colours of a smooth field picture at given points."""

from __future__ import annotations

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.contour import QuadContourSet


def drawn_values(ax, x, y):
    """Return the drawn field at all x and y [m], in the units of the colour bar; NaN where white.

    Lines and texts are hidden and remain hidden.
    """
    (filled,) = (c for c in ax.collections if isinstance(c, QuadContourSet) and c.filled)
    for artist in [*ax.collections, *ax.lines, *ax.texts]:
        artist.set_visible(artist is filled)
    if ax.get_legend() is not None:
        ax.get_legend().set_visible(False)
    canvas = FigureCanvasAgg(ax.get_figure(root=True))
    canvas.draw()
    image = np.asarray(canvas.buffer_rgba())[::-1, :, :3].astype(float) / 255
    x, y = np.meshgrid(np.asarray(x) * 1e6, np.asarray(y) * 1e6, indexing="ij")
    places = ax.transData.transform(np.stack([x.ravel(), y.ravel()], axis=1)).astype(int)
    seen = image[places[:, 1], places[:, 0]]
    if filled.colors is not None:  # a colour for each kind
        known = np.array([face[:3] for face in filled.get_facecolor()])
        values = np.arange(len(known), dtype=float)
    else:
        known = filled.cmap(np.linspace(0, 1, 256))[:, :3]
        values = np.asarray(filled.norm.inverse(np.linspace(0, 1, 256)))
    found = values[np.abs(seen[:, None] - known[None]).sum(axis=2).argmin(axis=1)]
    found[np.all(seen == 1.0, axis=1)] = np.nan
    return found.reshape(x.shape)


def shows(ax, x, y, values, within=0.04):
    """Return whether axes show these values at all x and y, to a fraction of the maximum magnitude.

    Bands of colour are not much narrower. White is shown for 0.
    """
    found = np.nan_to_num(drawn_values(ax, x, y))
    return np.abs(found - values).max() <= within * np.abs(values).max()
