# SPDX-License-Identifier: GPL-3.0-or-later
"""How the commands end when something goes wrong: one message on stderr, and an exit code."""

from __future__ import annotations

import errno
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from .._util.memory import BLAS_BUFFER, LIBRARIES, blas_threads, require_address_space
from .._util.short_text import escaped
from .signals import exit_code

BAD_INPUT = 2
FAILED = 1


class StoppedEarlyError(Exception):
    """A run that an error ended, its cause, after some increments; the text tells what is left."""


@contextmanager
def short_errors(*, files: bool = False) -> Iterator[None]:
    """Turn the errors a user can cause into one message on stderr, without a traceback.

    files: whether the command loads all libraries and reads or writes results, for which a limited
    address space must have room.
    """
    try:
        if files:
            buffers = BLAS_BUFFER * 2 * (blas_threads() - 1)  # of NumPy's and of SciPy's
            require_address_space("the command", LIBRARIES + buffers)
        yield
    except KeyboardInterrupt as stop:
        click.echo("interrupted", err=True)
        raise SystemExit(exit_code(stop)) from None
    except StoppedEarlyError as stopped:
        cause = stopped.__cause__
        assert isinstance(cause, Exception)
        message, _ = _told(cause)
        click.echo(f"error: {message or f'{type(cause).__name__}: {cause}'}\n{stopped}", err=True)
        if not message:  # no error that a user can cause
            raise cause from None
        raise SystemExit(FAILED) from None
    except BrokenPipeError:
        raise
    except Exception as error:
        message, code = _told(error)
        if not message:
            raise
        click.echo(f"error: {escaped(message)}", err=True)
        raise SystemExit(code) from None


def tell_partial(
    write: Callable[[str], object], error: BaseException, what: str, directory: Path
) -> str:
    """Write what an error has left of a run; the text for those who wait for it.

    Parameters
    ----------
    write : callable
        Writes results, then figures, given why they are not complete.
    error : Exception
    what : str
        How much there is.
    directory : Path
        Of the results.
    """
    reason = f"{type(error).__name__}: {error}"
    told = f"{what} are in {directory}, marked as incomplete"
    try:
        write(reason)
    except Exception as another:
        told = f"{what} are done, but not all could be written: {another}"
    return told


def to_try_on(told: str, directory: Path) -> str:
    """The text with how to go on."""
    return f"{told}; to try on:\n  samcontact resume {directory}"


def _told(error: Exception) -> tuple[str, int]:
    """What the user is told of an error, and the exit code; no text for those of this program."""
    from .._core import ConvergenceError

    if isinstance(error, ConvergenceError):
        return f"no convergence: {error}", FAILED
    if isinstance(error, ValueError):
        return str(error), BAD_INPUT
    if isinstance(error, Warning):  # PYTHONWARNINGS=error
        return f"a warning, which the environment makes an error: {error}", FAILED
    if _is_short_of_memory(error):
        return _no_memory(error), FAILED
    if isinstance(error, OSError):
        return _of_system(error), FAILED
    if isinstance(error, ModuleNotFoundError):
        return str(error), FAILED
    return "", FAILED


_REMEDIES = {
    errno.EFBIG: "raise the limit of the size of files (ulimit -f)",
    errno.ENOSPC: "free some space, or give another --output",
    errno.EDQUOT: "free some of the quota, or give another --output",
    errno.EACCES: "allow it, or choose another path",
    errno.EROFS: "choose a path that can be written",
}


def _of_system(error: OSError) -> str:
    """Message of an operating-system error: file, reason and remedy, without the errno."""
    parts = [error.filename, error.strerror or str(error), _REMEDIES.get(error.errno or 0)]
    return ": ".join(str(part) for part in parts if part)


def _is_short_of_memory(error: Exception) -> bool:
    """Also where a library has its own words for it: the loader, HDF5."""
    if isinstance(error, MemoryError) or getattr(error, "errno", None) == errno.ENOMEM:
        return True
    words = ("failed to map segment", "cannot allocate memory", "memory allocation failed")
    return isinstance(error, (ImportError, OSError, RuntimeError)) and any(
        text in str(error).lower() for text in words
    )


def _no_memory(error: Exception) -> str:
    told = str(error) if isinstance(error, MemoryError) else ""
    if "memory" in told:
        return told
    return "not enough memory: take fewer cells, end other programs or raise the limit (ulimit -v)"
