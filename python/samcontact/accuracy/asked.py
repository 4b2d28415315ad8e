# SPDX-License-Identifier: GPL-3.0-or-later
"""Function `to_accuracy`: solution to a prescribed accuracy; checks of its arguments."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._util import memory
from .._util.checks import boolean, positive
from .._util.errors import attach
from .._util.short_text import in_short
from .outcome import AccuracyResult
from .refinable_case import RefinableCase
from .run import INCREMENT_QUANTITIES, AccuracySearch

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
) -> AccuracyResult:
    """Solve a case on finer and finer grids until all errors are below the prescribed accuracy.

    Grid, layers and increments are chosen automatically; the fields [grid], ``increments`` and
    ``step`` of the case are not used. docs/theory/accuracy.md explains the error estimates.

    Parameters
    ----------
    case : Case, path or dict
        Case of one contact: result of `load_case`, path of a case file, or dictionary with the
        layout of a case file.
    accuracy : float or dict, optional
        Maximum relative error [-], in (0, 1): one number for all quantities, or a number for each
        quantity by name. Default: accuracy of the case.
    quantities : sequence of str, optional
        Quantities whose error is controlled, by their names in results files, e.g. "max_pressure",
        "imprint_depth_body2". Default: the quantities named by the case, or all.
    max_memory : float, optional
        Memory limit of the finest grid [bytes]. Default: available memory.
    max_time : float, optional
        Limit of the total time [s]. Default: 3600. At least three grids are always solved.
    progress : bool, optional
        Print one line per grid to stderr.
    checkpoint : path, optional
        Folder that stores the values of each grid and the increments of the last grids. Repeating
        the call continues from these, with bit-identical results. Remove the folder when it is no
        longer needed.

    Returns
    -------
    AccuracyResult
        Values with errors. If an exception or interruption (Ctrl-C) occurs after the third grid,
        its attribute `result` has the best values so far.

    Raises
    ------
    ValueError
        An argument is out of range, `checkpoint` belongs to another case, or surfaces of the case
        are defined on one grid only. The message names the cause and a remedy.

    Warns
    -----
    AccuracyWarning
        The accuracy requires more memory or time than allowed; the message gives both amounts. The
        best values so far are returned with their errors.
    """
    search = prepare_search(case, accuracy, quantities, max_memory, max_time, progress=progress)
    try:
        with search.solves.kept_in(checkpoint):
            return search.search()
    except BaseException as error:  # including Ctrl-C
        attach(error, result=search.best())
        raise


def prepare_search(
    case: Case | str | Path | Mapping[str, Any],
    accuracy: float | Mapping[str, float] | None = None,
    quantities: Sequence[str] | None = None,
    max_memory: float | None = None,
    max_time: float | None = None,
    *,
    progress: bool = False,
) -> AccuracySearch:
    """Check the arguments of `to_accuracy` and prepare the search."""
    from ..cases.given import case_of_contact

    boolean("progress", progress)
    own = isinstance(case, Mapping) and "grid" not in case and accuracy is not None
    known = case_of_contact("case", case, **({"accuracy": accuracy} if own else {}))
    scene = RefinableCase(known)
    asked = _prescribed_accuracy(scene, known, accuracy, quantities)
    scene.accept(min(asked.values()))
    scene.names = [name for name in scene.names if name in asked or name in INCREMENT_QUANTITIES]
    most = known.max_memory if max_memory is None else positive("max_memory", max_memory)
    limit = known.max_time if max_time is None else positive("max_time", max_time)
    if most is None:
        most = memory.available() or math.inf
    return AccuracySearch(scene, asked, most, HOUR if limit is None else limit, progress)


def _prescribed_accuracy(
    scene: RefinableCase,
    case: Case,
    accuracy: float | Mapping[str, float] | None,
    quantities: Sequence[str] | None,
) -> dict[str, float]:
    """Return the prescribed maximum relative error of each controlled quantity, by name."""
    given = case.accuracy if accuracy is None else accuracy
    if given is None:
        raise ValueError(
            "accuracy must be a number in (0, 1), e.g. 0.01, or a dict of such numbers by quantity"
        )
    chosen = case.quantities if quantities is None else quantities
    if chosen is not None and not (
        isinstance(chosen, (list, tuple)) and all(isinstance(name, str) for name in chosen)
    ):
        raise TypeError(f"quantities must be a list of names, got {in_short(chosen)}")
    if isinstance(given, Mapping):
        asked = dict(given)
        for name in chosen or ():
            if name not in asked:
                raise ValueError(
                    "accuracy must have a value for each name in quantities, got none for "
                    f"{in_short(name)}: add a value for this name, or remove the name from "
                    "quantities"
                )
    else:
        asked = dict.fromkeys(scene.names if chosen is None else chosen, given)
    if not asked:
        raise ValueError("quantities must contain at least one name, got none")
    for name, value in asked.items():
        if name not in scene.names:
            raise ValueError(
                "quantities must be names of quantities of this case "
                f"({', '.join(scene.names)}), got {in_short(name)}"
            )
        positive("accuracy", value)
        if not value < 1:
            raise ValueError(
                f"accuracy must be a relative error in (0, 1), e.g. 0.01 for 1 %, "
                f"got {in_short(value)}"
            )
    return asked
