# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenMP environment variables: invalid settings neither crash nor change a digit."""

import os
import subprocess
import sys
import warnings

import pytest

import samcontact as sc
from samcontact._util import load_core

SOLVE = """
import hashlib, os
import samcontact as sc
grid = sc.Grid(100, 100, 2e-5, 2e-5)
steel = sc.Material.elastic(210e9, 0.3)
gap = sc.surfaces.paraboloid(grid, 7.5e-3)
solution = sc.ContactSolver(grid, steel, steel).solve(gap, load=300.0)
threads = len(os.listdir("/proc/self/task"))
print(hashlib.sha256(solution.pressure.tobytes()).hexdigest(), threads)
"""


def solved(**environment):
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("OMP_", "GOMP_"))}
    own = {"OMP_DYNAMIC": "false", "OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run(
        [sys.executable, "-c", SOLVE],
        env=clean | own | environment,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    digits, threads = done.stdout.split()
    return digits, int(threads), done.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_invalid_openmp_settings_do_no_harm():
    digits, threads, stated = solved(OMP_NUM_THREADS="1")
    assert (threads, stated) == (1, "")
    maximum = 8 * os.cpu_count()
    for environment, expected in (
        # 2^31 and 2^32 + 1 do not fit an int
        ({"OMP_NUM_THREADS": "2147483648", "OMP_STACKSIZE": "16k"}, maximum),
        ({"OMP_NUM_THREADS": "4294967297"}, maximum),
        ({"OMP_NUM_THREADS": "3", "OMP_THREAD_LIMIT": "1"}, 1),
        ({"OMP_NUM_THREADS": "3", "OMP_THREAD_LIMIT": "2147483648"}, 3),
    ):
        assert solved(**environment) == (digits, expected, ""), environment
    other, threads, stated = solved(OMP_NUM_THREADS="-1")
    assert (other, threads) == (digits, os.cpu_count())
    assert "OMP_NUM_THREADS must be a whole number >= 1, got '-1'" in stated
    assert "libgomp" not in stated


@pytest.mark.parametrize("given", ["0", "abc", "2,x", "1" * 400 + "x", "1.5"])
def test_a_wrong_number_of_threads_is_named(given):
    with pytest.warns(RuntimeWarning, match="OMP_NUM_THREADS") as stated:
        assert load_core._number_of_threads(given) is None
    assert len(str(stated[0].message)) < 200


def test_valid_settings_are_kept():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert load_core._number_of_threads("2,1") == "2,1"
        assert load_core._number_of_threads(" ") is None
    assert [load_core._stack(given) for given in ("2m", "4096", "1G")] == ["2m", "4096", "1G"]
    assert [load_core._stack(given) for given in ("16k", "1b", "1023")] == ["1M", "1M", "1M"]
    assert sc.__version__
