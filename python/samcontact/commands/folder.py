# SPDX-License-Identifier: GPL-3.0-or-later
"""Files in the results folder of a run, and removal of outdated files of earlier runs."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from .. import results
from ..files.atomic import undisturbed
from ..files.ownership import recording

if TYPE_CHECKING:
    import xarray as xr

    from ..cases.base import CaseFile

_FIGURES = (
    "partial_slip", "fretting_loop", "rolling_force", "creep_curve",
    "pressure", "pressure_map", "gap_map", "load_approach", "axis_stress", "interface", "sections",
    "imprint", "imprint_map", "residual", "over_time", "cohesive_zone",
    "pull_off", "friction_over_velocity", "pressure_over_velocity",
    "flash_temperature", "temperature", "track_imprint", "track_sections", "force_x", "force_z",
    "load_ratio", "wear_rate", "profile_body[12]", "surface_body[12]", "first_cycle_body[12]",
    "last_cycle_body[12]", "fretting", "fatigue_depth", "fatigue_strain", "fatigue_section",
    "fatigue_exposure", "shakedown",
    "film_imprint", "film_map", "film_over_time", "film_profile", "film_stress",
    "film_temperature", "interferogram", "regime_chart", "stribeck",
)  # fmt: skip
_RESULT_FILES = re.compile(r"(results|series|wear|film|sliding|fatigue|shakedown)\.nc")
_OUTPUT_FILES = re.compile(
    rf"{_RESULT_FILES.pattern}|(series|wear|film|sliding)\.csv|(report|results)\.html"
    r"|(rolling|partial_slip|film)\.gif"
    r"|results(_\d{5,})?(_track)?(_surface)?\.vt[ru]|results(_surface)?\.pvd"
    rf"|({'|'.join(_FIGURES)})\.(png|pdf|svg)"
)
"""Pattern for the names of files that runs, reports and exports write to a results folder."""


def is_own(file: Path) -> bool:
    """Whether a file has one of the names that runs, reports and exports give to their output."""
    return _OUTPUT_FILES.fullmatch(file.name) is not None


def written_names(case: CaseFile, main: str, figures: bool, animate: bool) -> re.Pattern[str]:
    """Return a pattern for the names of all files that a run may write.

    main: name of the results file, without suffix.
    """
    parts = [name for name in ("fatigue", "shakedown") if getattr(case, name, None) is not None]
    names = ["|".join((main, *parts)) + r")\.nc", main + r")\.csv"]
    if figures and case.output.figures:
        names.append(f"{'|'.join(_FIGURES)})\\.({case.output.format}|png)")
    if animate:
        names.append(r"rolling|partial_slip|film)\.gif")
    return re.compile("|".join(f"({name}" for name in names))


def publish(dataset: xr.Dataset, file: Path) -> Path:
    """Write the results of a run, and remove the files of earlier runs from the folder.

    Old files are removed after the new results have been written, so that a failed run loses
    nothing. They are removed before new figures are drawn, so that no figure or report shows old
    results. Files that this package did not write are not touched.
    """
    with undisturbed(), recording(file.parent) as record:
        results.save(dataset, file)
        record.clear(file, marked=_RESULT_FILES)
    return file
