# SPDX-License-Identifier: GPL-3.0-or-later
"""Loading of the compiled core with a limited number of OpenMP threads that spin only briefly.

Waking a sleeping thread takes as long as a small Fourier transform, especially on virtual machines.
A spinning thread takes processor time from other processes. Waiting threads therefore spin for a
few tenths of a millisecond and then sleep. OpenMP reads its environment variables once, when its
library is loaded. Valid settings of the user have priority, and the environment is restored
afterwards.
"""

import os
import sys
import warnings
from collections.abc import Callable, Iterator

_BYTES_PER_UNIT = {"b": 1, "k": 2**10, "m": 2**20, "g": 2**30}
MIN_STACK_BYTES = 2**20
"""Minimum stack of a thread [bytes]: an increment crashed with 16 kB and passed with 32 kB."""


def max_threads() -> int:
    """Return the maximum number of threads, eight per processor; more would only wait."""
    return 8 * (os.cpu_count() or 1)


def _count(text: str) -> int | None:
    return int(text) if text.isdecimal() and int(text) > 0 else None


def _number_of_threads(given: str) -> str | None:
    """Return a valid value of OMP_NUM_THREADS; None if the given text is not valid."""
    if not given.strip():
        return None
    counts = [
        _count(part.strip()) for part in given.split(",")
    ]  # further numbers are for nested loops
    if None in counts:
        warnings.warn(
            f"OMP_NUM_THREADS must be a whole number >= 1, got {given[:40]!r}: it is ignored, and "
            f"{os.cpu_count()} threads are used, one per processor",
            RuntimeWarning,
            stacklevel=2,
        )
        return None
    return ",".join(str(min(count or 1, max_threads())) for count in counts)


def _limit(given: str) -> str:
    return str(min(_count(given.strip()) or max_threads(), max_threads()))


def _stack(given: str) -> str | None:
    """Return a value of OMP_STACKSIZE that suffices for the core; None: remove the variable."""
    text = given.strip().lower()
    number, unit = (text[:-1], text[-1]) if text[-1:] in _BYTES_PER_UNIT else (text, "k")
    count = _count(number.strip())
    if count is not None and count * _BYTES_PER_UNIT[unit] >= MIN_STACK_BYTES:
        return given
    return _default_stack() if not text or count is None else "1M"


def _default_stack() -> str | None:
    """Return "1M" as stack size of the threads if `ulimit -s` is too small; otherwise None."""
    if sys.platform == "win32":
        return None
    import resource

    soft, _ = resource.getrlimit(resource.RLIMIT_STACK)
    return "1M" if 0 <= soft < MIN_STACK_BYTES else None


def _settings() -> Iterator[tuple[str, str | None]]:
    """Iterate over environment variables (name, value) for loading the core; value None: unset."""
    usable: dict[str, Callable[[str], str | None]] = {
        "OMP_NUM_THREADS": _number_of_threads,
        "OMP_THREAD_LIMIT": _limit,
        "OMP_STACKSIZE": _stack,
        "GOMP_STACKSIZE": _stack,
    }
    for name, made in usable.items():
        if name in os.environ:
            yield name, made(os.environ[name])
    defaults = {
        "OMP_WAIT_POLICY": "passive",
        "GOMP_SPINCOUNT": "10000",
        "OMP_THREAD_LIMIT": str(max_threads()),
    }
    for name, value in defaults.items():
        if name not in os.environ:
            yield name, value
    if not {"OMP_STACKSIZE", "GOMP_STACKSIZE"} & os.environ.keys():
        yield "OMP_STACKSIZE", _default_stack()


_before = {}
for _name, _value in list(_settings()):
    _before[_name] = os.environ.pop(_name, None)
    if _value is not None:
        os.environ[_name] = _value
try:
    from .. import _core  # noqa: F401  (loading it is the purpose)
finally:
    for _name, _value in _before.items():
        os.environ.pop(_name, None)
        if _value is not None:
            os.environ[_name] = _value
