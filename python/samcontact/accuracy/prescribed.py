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

    Grid, layers and increments are chosen automatically; ``increments`` and ``step`` of the case
    are not used. With periodic, rough or measured surfaces, and with wear, all grids have the
    extent of [grid]. If surface heights are interpolated, the errors refer to the interpolated
    surface, see docs/theory/accuracy.md.

    Parameters
    ----------
    case : Case, path or dict
        Case of one contact: result of `load_case`, path of a case file, or dictionary with the
        layout of a case file.
    accuracy : float or dict, optional
        Maximum relative error [-], in (0, 1): one number for all quantities, or a number for each
        quantity by name. Default: `accuracy` of the case.
    quantities : sequence of str, optional
        Quantities whose error is controlled, by their names in results files, e.g. "max_pressure",
        "imprint_depth_body2". Default: the quantities that the case names; if it names none, all
        quantities.
    max_memory : float, optional
        Memory limit of the finest grid [bytes]. Default: available memory.
    max_time : float, optional
        Limit of the total time [s]. Default: 3600. At least three grids are solved, or four for
        slowly converging quantities, even if they take longer.
    progress : bool, optional
        Print one line per grid to stderr.
    checkpoint : path, optional
        Folder that stores the values of each grid and the increments of the last grids. Repeating
        the call continues from this folder, with bit-identical results. Remove the folder when it
        is no longer needed.

    Returns
    -------
    AccuracyResult
        Values with errors. If an exception or interruption (Ctrl-C) occurs after the third grid,
        the attribute `result` of the exception has the best values so far.

    Raises
    ------
    ValueError
        An argument is out of range, `checkpoint` was written for another case, the case lacks a
        [grid] that it needs, or the results of the case have no limit on finer grids. The message
        names the cause and a remedy.

    Warns
    -----
    AccuracyWarning
        The accuracy requires more memory or time than allowed; the message gives the memory and the
        time required. The best values so far are returned with their errors.
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
    from .given_case import case_of_contact

    boolean("progress", progress)
    own = isinstance(case, Mapping) and "grid" not in case and accuracy is not None
    known = case_of_contact("case", case, **({"accuracy": accuracy} if own else {}))
    refinable = RefinableCase(known)
    targets = _prescribed_accuracy(refinable, known, accuracy, quantities)
    refinable.accept(min(targets.values()))
    refinable.names = [
        name for name in refinable.names if name in targets or name in INCREMENT_QUANTITIES
    ]
    memory_limit = known.max_memory if max_memory is None else positive("max_memory", max_memory)
    time_limit = known.max_time if max_time is None else positive("max_time", max_time)
    if memory_limit is None:
        memory_limit = memory.available() or math.inf
    return AccuracySearch(
        refinable, targets, memory_limit, HOUR if time_limit is None else time_limit, progress
    )


def _prescribed_accuracy(
    refinable: RefinableCase,
    case: Case,
    accuracy: float | Mapping[str, float] | None,
    quantities: Sequence[str] | None,
) -> dict[str, float]:
    """Return the prescribed maximum relative error of each controlled quantity, by name."""
    given = case.accuracy if accuracy is None else accuracy
    if given is None:
        raise ValueError(
            "accuracy must be a number in (0, 1), e.g. 0.01, or a dict with such a number for each "
            "quantity, got None"
        )
    chosen = case.quantities if quantities is None else quantities
    if chosen is not None and not (
        isinstance(chosen, (list, tuple)) and all(isinstance(name, str) for name in chosen)
    ):
        raise TypeError(f"quantities must be a list of names, got {in_short(chosen)}")
    if isinstance(given, Mapping):
        targets = dict(given)
        for name in chosen or ():
            if name not in targets:
                raise ValueError(
                    "accuracy must have a value for each name in quantities, got none for "
                    f"{in_short(name)}: add a value for this name, or remove the name from "
                    "quantities"
                )
    else:
        defaults = refinable.study.default_names
        targets = dict.fromkeys(defaults if chosen is None else chosen, given)
    if not targets:
        raise ValueError("quantities must contain at least one name, got none")
    for name, value in targets.items():
        if name not in refinable.names:
            raise ValueError(
                f"for this case, quantities must be any of {', '.join(refinable.names)}, got "
                f"{in_short(name)}"
            )
        positive("accuracy", value)
        if not value < 1:
            raise ValueError(
                f"accuracy must be a relative error in (0, 1), e.g. 0.01 for 1 %, "
                f"got {in_short(value)}"
            )
    return targets
