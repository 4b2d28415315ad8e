# SPDX-License-Identifier: GPL-3.0-or-later
"""What is asked for: a case, an accuracy for each of its quantities, memory and time."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._util import memory
from .._util.checks import boolean, positive
from .._util.short_text import in_short
from .outcome import Accurate
from .run import OF_INCREMENTS, Search
from .scene import Refinable

if TYPE_CHECKING:
    from ..cases import Case

HOUR = 3600.0


def to_accuracy(
    case: Case | str | Path | Mapping[str, Any],
    accuracy: float | Mapping[str, float] | None = None,
    *,
    quantities: Sequence[str] | None = None,
    max_memory: float | None = None,
    max_time: float | None = None,
    progress: bool = True,
    checkpoint: str | os.PathLike[str] | None = None,
) -> Accurate:
    """Solve a case on grids that become finer, until the errors of its values are small enough.

    Window, cells, layers and increments are chosen; a [grid] of the case, its ``increments`` and
    the ``step`` of passes are not used. docs/theory/accuracy.md has how errors are estimated.

    Parameters
    ----------
    case : Case, path or dict
        A case of one contact, from `load_case`, its file, or a dictionary of the same layout.
    accuracy : float or dict, optional
        Relative error [-], in (0, 1), of all quantities or of each by its name; default that of the
        case.
    quantities : sequence of str, optional
        Names in results files, e.g. "max_pressure", "print_depth_body2"; default all that the
        case has, or those that it names.
    max_memory : float, optional
        Of the finest grid [bytes]; default what is available.
    max_time : float, optional
        In all [s]; default an hour. The first three grids are solved whatever they take.
    progress : bool, optional
        Tell of each grid, on stderr.
    checkpoint : path, optional
        Folder in which to keep the values of each grid, and the increments of the last ones. The
        same call goes on from it, with the same bits. Remove it when it is no longer needed.

    Returns
    -------
    Accurate
        An error or interrupt (Ctrl-C) after the third grid has the best values so far in its
        attribute `result`.

    Raises
    ------
    ValueError
        An argument out of range, `checkpoint` of another case, or a case with surfaces that are
        known on one grid only: the text names them and what to do instead.

    Warns
    -----
    AccuracyWarning
        The accuracy needs more memory or time than allowed: what it would need. The best values so
        far are returned with their errors.
    """
    search = searched(case, accuracy, quantities, max_memory, max_time, progress=progress)
    try:
        with search.solves.kept_in(checkpoint):
            return search.search()
    except BaseException as error:  # Ctrl-C too
        error.result = search.best()  # type: ignore[attr-defined]
        raise


def searched(
    case: Case | str | Path | Mapping[str, Any],
    accuracy: float | Mapping[str, float] | None = None,
    quantities: Sequence[str] | None = None,
    max_memory: float | None = None,
    max_time: float | None = None,
    *,
    progress: bool = False,
) -> Search:
    """What `to_accuracy` does, before anything is solved."""
    from ..cases.given import case_of_contact

    boolean("progress", progress)
    own = isinstance(case, Mapping) and "grid" not in case and accuracy is not None
    known = case_of_contact("case", case, **({"accuracy": accuracy} if own else {}))
    scene = Refinable(known)
    asked = _asked(scene, known, accuracy, quantities)
    scene.accept(min(asked.values()))
    scene.names = [name for name in scene.names if name in asked or name in OF_INCREMENTS]
    most = known.max_memory if max_memory is None else positive("max_memory", max_memory)
    limit = known.max_time if max_time is None else positive("max_time", max_time)
    if most is None:
        most = memory.available() or math.inf
    return Search(scene, asked, most, HOUR if limit is None else limit, progress)


def _asked(
    scene: Refinable,
    case: Case,
    accuracy: float | Mapping[str, float] | None,
    quantities: Sequence[str] | None,
) -> dict[str, float]:
    """Relative accuracy of each quantity that is judged."""
    given = case.accuracy if accuracy is None else accuracy
    if given is None:
        raise ValueError("accuracy must be a number in (0, 1), e.g. 0.01, or a dict of them")
    chosen = case.quantities if quantities is None else quantities
    if chosen is not None and not (
        isinstance(chosen, (list, tuple)) and all(isinstance(name, str) for name in chosen)
    ):
        raise TypeError(f"quantities must be a list of names, got {in_short(chosen)}")
    if isinstance(given, Mapping):
        asked = dict(given)
        for name in chosen or ():
            if name not in asked:
                raise ValueError(f"accuracy has no value for {in_short(name)} of quantities")
    else:
        asked = dict.fromkeys(scene.names if chosen is None else chosen, given)
    if not asked:
        raise ValueError("quantities must name one at least, got none")
    for name, value in asked.items():
        if name not in scene.names:
            raise ValueError(
                f"quantities: {in_short(name)} is none of this case, which has "
                f"{', '.join(scene.names)}"
            )
        positive("accuracy", value)
        if not value < 1:
            raise ValueError(
                f"accuracy must be a relative error in (0, 1), e.g. 0.01 for 1 %, "
                f"got {in_short(value)}"
            )
    return asked
