# SPDX-License-Identifier: GPL-3.0-or-later
"""Every kind of run resumes with bit-identical results, with one run at a time per folder."""

import contextlib
import random
import re
import shutil
import signal

import pytest
from faulting import Nursery, with_trials
from killed_runs import ANY, BODIES


@pytest.fixture(scope="module")
def nursery():
    with contextlib.closing(Nursery(ANY)) as made:
        yield made


SLOW_RUNS = {"periodic zones", "found load", "creepage", "periodic", "heat of slip",
             "adhesion", "creep", "inclusion"}  # fmt: skip
"""Kinds that take seconds or whose parts other kinds also have; the rest are in every run."""


@pytest.fixture(
    scope="module",
    params=[pytest.param(kind, marks=[pytest.mark.slow] * (kind in SLOW_RUNS)) for kind in BODIES],
)
def whole(request, nursery, tmp_path_factory):
    """Return a kind of run, its digest, its duration, its largest file and its maximum memory."""
    folder = tmp_path_factory.mktemp("whole")
    message, _ = nursery.run(f"{request.param}|memory inf|{folder / 'first'}")
    assert message is not None, nursery.message()
    digest, maximum = message.split()
    again, seconds = nursery.run(f"{request.param}||{folder / 'run'}")
    assert digest == again
    assert len(digest) == 64
    files = [path.stat().st_size for path in folder.rglob("*") if path.is_file()]
    return request.param, digest, seconds, max(files), float(maximum)


@with_trials("kill: kinds of runs")
def test_killed_and_interrupted(whole, nursery, tmp_path, count):
    kind, digest, seconds, *_ = whole
    times = random.Random(f"stopped {kind}")
    for trial in range(count):
        folder = tmp_path / f"trial{trial}"
        argument = f"{kind}||{folder / 'run'}"
        for number in times.sample([signal.SIGKILL, signal.SIGINT, signal.SIGTERM], 3):
            moment = (trial + times.random()) / count * seconds
            nursery.run(argument, moment, number)
        assert nursery.run(argument)[0] == digest, nursery.message()
        shutil.rmtree(folder)


def test_full_disk(whole, nursery, tmp_path):
    kind, digest, _, largest, _ = whole
    stopped, _ = nursery.run(f"{kind}|disk {largest // 2}|{tmp_path / 'run'}")
    assert stopped is None
    assert nursery.run(f"{kind}||{tmp_path / 'run'}")[0] == digest


def test_not_enough_memory(whole, nursery, tmp_path):
    """The folder with results is reported, and its run resumes with bit-identical results."""
    kind, digest, *_, maximum = whole
    # A search skips loads whose runs do not fit, and reports if none fits.
    there = 0.0 if kind == "found load" else 0.99 * maximum
    message, _ = nursery.run(f"{kind}|memory {there}|{tmp_path / 'run'}")
    assert re.search(r"requires about [\d.e+-]+ GB of memory, [\d.e+-]+ GB available", message)
    assert nursery.run(f"{kind}||{tmp_path / 'run'}")[0] == digest


def test_one_at_a_time(whole, nursery, tmp_path):
    kind, digest, *_ = whole
    found, _ = nursery.run(f"{kind}|twice|{tmp_path / 'run'}")
    assert found.startswith(f"{digest} another run of samcontact writes to")
