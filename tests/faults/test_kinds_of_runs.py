# SPDX-License-Identifier: GPL-3.0-or-later
"""Every kind of run resumes with bit-identical results, with one run at a time per folder."""

import contextlib
import os
import random
import re
import shutil
import signal
import subprocess

import pytest
from faulting import Nursery, with_trials
from killed_runs import ANY, BODIES


@pytest.fixture(scope="module")
def nursery():
    with contextlib.closing(Nursery(ANY)) as made:
        yield made


SLOW_RUNS = {"periodic zones", "found load", "creepage", "periodic", "heat of slip",
             "adhesion", "creep", "inclusion", "coated"}  # fmt: skip
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


@contextlib.contextmanager
def small_disk(folder, size):
    """Mount a file system of this many bytes, which only the root user may."""
    folder.mkdir()
    words = ["mount", "-t", "tmpfs", "-o", f"size={size}", "none", str(folder)]
    if os.getuid() != 0 or subprocess.run(words, capture_output=True).returncode:
        pytest.skip("file systems cannot be mounted here")
    try:
        yield folder
    finally:
        subprocess.run(["umount", str(folder)], check=True)


def test_full_file_system(whole, nursery, tmp_path):
    """The run resumes when there is space again; what it had written fills most of the disk."""
    kind, digest, _, largest, _ = whole
    with small_disk(tmp_path / "disk", largest * 3 // 4) as disk:
        stopped, _ = nursery.run(f"{kind}||{disk / 'run'}")
        assert stopped is None
        subprocess.run(["mount", "-o", "remount,size=1g", str(disk)], check=True)
        assert nursery.run(f"{kind}||{disk / 'run'}")[0] == digest, nursery.message()


def test_clock_set_back(whole, nursery, tmp_path):
    """The files of a killed run are of the future."""
    kind, digest, seconds, *_ = whole
    nursery.run(f"{kind}||{tmp_path / 'run'}", 0.7 * seconds, signal.SIGKILL)
    for path in tmp_path.rglob("*"):
        os.utime(path, (4e9, 4e9))
    assert nursery.run(f"{kind}|clock 1e9|{tmp_path / 'run'}")[0] == digest, nursery.message()


@pytest.fixture(scope="module")
def german(tmp_path_factory):
    """Return a folder with the compiled locale de_DE."""
    folder = tmp_path_factory.mktemp("locale")
    words = ["localedef", "-i", "de_DE", "-f", "UTF-8", str(folder / "de_DE.UTF-8")]
    if not shutil.which("localedef") or subprocess.run(words, capture_output=True).returncode:
        pytest.skip("locales cannot be compiled here")
    return folder


def test_locale_with_decimal_comma(whole, nursery, tmp_path, german):
    kind, digest, seconds, *_ = whole
    argument = f"{kind}|locale {german}|{tmp_path / 'run'}"
    nursery.run(argument, 0.7 * seconds, signal.SIGKILL)
    assert nursery.run(argument)[0] == digest, nursery.message()


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
