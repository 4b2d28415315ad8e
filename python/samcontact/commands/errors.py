# SPDX-License-Identifier: GPL-3.0-or-later
"""Error handling of the commands: one message on stderr and an exit code."""

from __future__ import annotations

import errno
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import click

from .._util.memory import BLAS_BUFFER_BYTES, LIBRARY_BYTES, blas_threads, require_address_space
from .._util.short_text import escaped
from .signals import exit_code

EXIT_BAD_INPUT = 2
EXIT_FAILED = 1


class StoppedEarlyError(Exception):
    """Error for a run that stopped early; the results of its completed increments were written.

    The message describes these results. The attribute `__cause__` is the original error.
    """


@contextmanager
def short_errors(*, files: bool = False) -> Iterator[None]:
    """Context manager that reports errors caused by the user as messages, without traceback.

    The message is printed on stderr, and SystemExit is raised with the exit code. files: whether
    the command reads or writes results. Such a command loads all libraries, so the available
    address space is checked first.
    """
    try:
        if files:
            buffers = BLAS_BUFFER_BYTES * 2 * (blas_threads() - 1)  # for NumPy and for SciPy
            require_address_space("the command", LIBRARY_BYTES + buffers)
        yield
    except KeyboardInterrupt as stop:
        click.echo("interrupted", err=True)
        raise SystemExit(exit_code(stop)) from None
    except StoppedEarlyError as stopped:
        cause = stopped.__cause__
        assert isinstance(cause, Exception)
        message, _ = _message_and_code(cause)
        click.echo(f"error: {message or f'{type(cause).__name__}: {cause}'}\n{stopped}", err=True)
        if not message:  # an internal error
            raise cause from None
        raise SystemExit(EXIT_FAILED) from None
    except BrokenPipeError:
        raise
    except Exception as error:
        message, code = _message_and_code(error)
        if not message:
            raise
        click.echo(f"error: {escaped(message)}", err=True)
        raise SystemExit(code) from None


def write_partial_results(
    write: Callable[[str], object], error: BaseException, what: str, directory: Path
) -> str:
    """Write the results obtained before an error, and return a message for the user.

    Parameters
    ----------
    write : callable
        Function that writes results and then figures; its argument is the reason why the results
        are incomplete.
    error : Exception
        Error that stopped the run.
    what : str
        Description of the results that exist, e.g. "3 of 12 increments".
    directory : Path
        Folder of the results.
    """
    reason = f"{type(error).__name__}: {error}"
    text = f"{what} are in {directory}, marked as incomplete"
    try:
        write(reason)
    except Exception as another:
        text = f"{what} were completed, but could not all be written: {another}"
    return text


def with_resume_hint(text: str, directory: Path) -> str:
    """Return a message followed by the command that resumes the run in `directory`."""
    return f"{text}; resume with:\n  samcontact resume {directory}"


def _message_and_code(error: Exception) -> tuple[str, int]:
    """Return the message for an error ("" for an internal error), and the exit code."""
    from .._core import ConvergenceError

    if isinstance(error, ConvergenceError):
        return f"did not converge: {error}", EXIT_FAILED
    if isinstance(error, ValueError):
        return str(error), EXIT_BAD_INPUT
    if isinstance(error, Warning):  # PYTHONWARNINGS=error
        return f"warning treated as an error (PYTHONWARNINGS): {error}", EXIT_FAILED
    if _is_short_of_memory(error):
        return _no_memory(error), EXIT_FAILED
    if isinstance(error, OSError):
        return _system_message(error), EXIT_FAILED
    if isinstance(error, ModuleNotFoundError):
        return str(error), EXIT_FAILED
    return "", EXIT_FAILED


_REMEDIES = {
    errno.EFBIG: "raise the file size limit (ulimit -f)",
    errno.ENOSPC: "free some space, or use another --output",
    errno.EDQUOT: "free some of the disk quota, or use another --output",
    errno.EACCES: "change the permissions, or use another path",
    errno.EROFS: "use a writable path",
}


def _system_message(error: OSError) -> str:
    """Return the message for an operating-system error: file, reason and remedy."""
    parts = [error.filename, error.strerror or str(error), _REMEDIES.get(error.errno or 0)]
    return ": ".join(str(part) for part in parts if part)


def _is_short_of_memory(error: Exception) -> bool:
    """Whether an error of any type was caused by a lack of memory."""
    if isinstance(error, MemoryError) or getattr(error, "errno", None) == errno.ENOMEM:
        return True
    words = ("failed to map segment", "cannot allocate memory", "memory allocation failed")
    return isinstance(error, (ImportError, OSError, RuntimeError)) and any(
        text in str(error).lower() for text in words
    )


def _no_memory(error: Exception) -> str:
    text = str(error) if isinstance(error, MemoryError) else ""
    if "memory" in text:
        return text
    return "not enough memory: use fewer cells, close other programs or raise the limit (ulimit -v)"
