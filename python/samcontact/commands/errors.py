# SPDX-License-Identifier: GPL-3.0-or-later
"""How the commands end when something goes wrong: one message on stderr, and an exit code."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import click

BAD_INPUT = 2
FAILED = 1
INTERRUPTED = 130


@contextmanager
def short_errors() -> Iterator[None]:
    """Turn the errors a user can cause into one message on stderr, without a traceback."""
    from .. import ConvergenceError

    code = BAD_INPUT
    try:
        yield
        return
    except ConvergenceError as error:
        message, code = f"no convergence: {error}", FAILED
    except ValueError as error:
        message = str(error)
    except BrokenPipeError:  # the reader of our output has left: click ends quietly
        raise
    except (OSError, ModuleNotFoundError, MemoryError) as error:
        message, code = str(error) or "not enough memory", FAILED
    click.echo(f"error: {message}", err=True)
    raise SystemExit(code)
