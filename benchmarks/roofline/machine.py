# SPDX-License-Identifier: GPL-3.0-or-later
"""Rates of one core: bytes moved by a copy, operations of a matrix product and of transforms."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import scipy.fft

MEMORY = 2**26  # bytes of a working set that no cache contains
TRIES = 30
MIN_TIME = 3e-3  # s of one try


class Machine(NamedTuple):
    """Largest rates that were measured in this process."""

    product: float
    """Operations of the product of two matrices [1/s]."""
    transform: float
    """Operations of real transforms that fit into the cache [1/s]."""
    copy: float
    """Bytes that a copy of the given size reads and writes [1/s]."""

    def best(self, other: Machine) -> Machine:
        """Return the larger of each pair of rates."""
        return Machine(*map(max, self, other))


def rate(work: Callable[[], object], amount: float) -> float:
    """Return the amount per time of the fastest try [1/s]."""
    work()
    start = time.process_time()
    work()
    repeats = max(1, math.ceil(MIN_TIME / max(time.process_time() - start, 1e-7)))
    best = math.inf
    for _ in range(TRIES):
        start = time.process_time()
        for _ in range(repeats):
            work()
        best = min(best, (time.process_time() - start) / repeats)
    return amount / best


def measured(working_set: float) -> Machine:
    """Return the rates of one core; the copy has a working set of this size [bytes]."""
    n = 256
    a = np.random.default_rng(1).random((n, n))
    b, out = a.T.copy(), np.empty((n, n))
    rows, length = 32, 512
    block = np.random.default_rng(2).random((rows, length))
    count = max(1024, int(min(working_set, MEMORY) / 16))
    source, target = np.ones(count), np.zeros(count)
    return Machine(
        product=rate(lambda: np.matmul(a, b, out=out), 2.0 * n**3),
        transform=rate(
            lambda: scipy.fft.rfft(block, axis=1), 2.5 * rows * length * math.log2(length)
        ),
        copy=rate(lambda: np.copyto(target, source), 16.0 * count),
    )
