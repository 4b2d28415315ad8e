# SPDX-License-Identifier: GPL-3.0-or-later
"""What is told of a dataset whose parts are not those that this package writes."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def parts_of_a_run() -> Iterator[None]:
    """Turn what goes wrong with a variable of another shape or type into a ValueError."""
    try:
        yield
    except (LookupError, TypeError, AttributeError, ArithmeticError) as error:
        raise ValueError(
            "dataset must be that of a run, but some part of it is missing or of another kind: "
            f"{type(error).__name__}: {error}"
        ) from error
