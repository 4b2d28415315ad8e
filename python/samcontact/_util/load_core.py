# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the core with OpenMP threads that soon sleep while they wait, and not too many of them.

A thread that sleeps takes as long to wake as a small transform takes, on virtual machines above
all; one that spins takes processor time from whoever wants it. So it spins for some tenths of a
millisecond. OpenMP reads its environment once, when its library is loaded; what the user has set
wins where OpenMP can use it, and the environment is left as it was.
"""

import os
import sys
import warnings
from collections.abc import Callable, Iterator

_UNITS = {"b": 1, "k": 2**10, "m": 2**20, "g": 2**30}
LEAST_STACK = 2**20
"""Bytes: an increment crashed with 16 kB for a thread and passed with 32 kB; this has room."""


def most_threads() -> int:
    """Eight for each processor: more, as by a slip in OMP_NUM_THREADS, only wait for each other."""
    return 8 * (os.cpu_count() or 1)


def _count(text: str) -> int | None:
    return int(text) if text.isdecimal() and int(text) > 0 else None


def _number_of_threads(given: str) -> str | None:
    """What OpenMP is told: None for nothing."""
    if not given.strip():
        return None
    counts = [_count(part.strip()) for part in given.split(",")]  # nested loops have the others
    if None in counts:
        warnings.warn(
            f"OMP_NUM_THREADS is {given[:40]!r} and must be a whole number >= 1: it is ignored, "
            f"there is a thread for each of the {os.cpu_count()} processors",
            RuntimeWarning,
            stacklevel=2,
        )
        return None
    return ",".join(str(min(count or 1, most_threads())) for count in counts)


def _limit(given: str) -> str:
    return str(min(_count(given.strip()) or most_threads(), most_threads()))


def _stack(given: str) -> str | None:
    """At least what the core needs; a number alone is in kilobytes. None: as the system has it."""
    text = given.strip().lower()
    number, unit = (text[:-1], text[-1]) if text[-1:] in _UNITS else (text, "k")
    count = _count(number.strip())
    if count is not None and count * _UNITS[unit] >= LEAST_STACK:
        return given
    return _default_stack() if not text or count is None else "1M"


def _default_stack() -> str | None:
    """A thread has what `ulimit -s` gives."""
    if sys.platform == "win32":
        return None
    import resource

    soft, _ = resource.getrlimit(resource.RLIMIT_STACK)
    return "1M" if 0 <= soft < LEAST_STACK else None


def _settings() -> Iterator[tuple[str, str | None]]:
    """Name and value, None to take it away, of what is set while the core is loaded."""
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
        "OMP_THREAD_LIMIT": str(most_threads()),
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
