# SPDX-License-Identifier: GPL-3.0-or-later
"""Every kind of run goes on to the same bits after a kill, Ctrl-C or a full disk, one at a time."""

import contextlib
import random
import shutil
import signal

import pytest
from faulting import Nursery, tried
from killed_runs import ANY, BODIES


@pytest.fixture(scope="module")
def nursery():
    with contextlib.closing(Nursery(ANY)) as made:
        yield made


@pytest.fixture(scope="module", params=BODIES)
def whole(request, nursery, tmp_path_factory):
    """A kind, its digest, the time that it takes, and its largest file."""
    folder = tmp_path_factory.mktemp("whole")
    digest, _ = nursery.run(f"{request.param}||{folder / 'first'}")
    again, seconds = nursery.run(f"{request.param}||{folder / 'run'}")
    assert digest == again
    assert len(digest) == 64
    files = [path.stat().st_size for path in folder.rglob("*") if path.is_file()]
    return request.param, digest, seconds, max(files)


@tried("kill: kinds of runs")
def test_killed_and_interrupted(whole, nursery, tmp_path, count):
    kind, digest, seconds, _ = whole
    times = random.Random(f"stopped {kind}")
    for trial in range(count):
        folder = tmp_path / f"trial{trial}"
        argument = f"{kind}||{folder / 'run'}"
        for number in times.sample([signal.SIGKILL, signal.SIGINT], 2):
            moment = (trial + times.random()) / count * seconds
            nursery.run(argument, moment, number)
        assert nursery.run(argument)[0] == digest, nursery.told()
        shutil.rmtree(folder)


def test_full_disk(whole, nursery, tmp_path):
    kind, digest, _, largest = whole
    stopped, _ = nursery.run(f"{kind}|{largest // 2}|{tmp_path / 'run'}")
    assert stopped is None
    assert nursery.run(f"{kind}||{tmp_path / 'run'}")[0] == digest


def test_one_at_a_time(whole, nursery, tmp_path):
    kind, digest, *_ = whole
    found, _ = nursery.run(f"{kind}|twice|{tmp_path / 'run'}")
    assert found.startswith(f"{digest} another run of samcontact writes to")
