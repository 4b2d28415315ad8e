# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of an argument (case, path or dictionary) to a case of one contact."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..cases.base import CaseFile
from ..cases.case import Case
from ..cases.reading import load_case, validated


def case_of_contact(name: str, given: object, **defaults: Any) -> Case:
    """Return a `Case` from a case, the path of a case file, or a dictionary of the same layout.

    name: name of the argument, for error messages. defaults: values of fields that a dictionary
    omits.
    """
    made = given
    if isinstance(given, (str, Path)):
        made = load_case(Path(given))
    elif isinstance(given, Mapping):
        made = validated({"title": "case", **defaults, **given}, Path(name))
    if not isinstance(made, Case):
        kind = type(made).__name__
        hint = f", which is {made.KIND}" if isinstance(made, CaseFile) else ""
        raise ValueError(
            f"{name} must be a case of one contact, the path of its file, or a dict with the "
            f"layout of a case file, got a {kind}{hint}"
        )
    return made
