# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that exceed memory are refused in advance, and the memory estimates are correct."""

import contextlib
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from faulting import TRIALS, Nursery, with_trials

import samcontact as sc
from samcontact import operators, surfaces
from samcontact._util import memory

ELASTIC, OTHER = sc.Material.elastic(210e9, 0.3), sc.Material.elastic(300e9, 0.2)
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
WARM = ELASTIC.with_thermal(50.0, 1e-5, 1.4e-5)
LENGTH = 2e-3

MEASURED = (
    f"TESTS = {str(Path(__file__).parents[1])!r}"
    + """
import sys, warnings
import numpy as np
import scipy.ndimage, scipy.optimize, scipy.special  # loaded once, by the first that needs them
import samcontact as sc
from samcontact._util import memory
from samcontact.simulation import increment_errors
increment_errors.estimated = lambda *_, **__: None  # whose solves ask for memory of their own
sys.path.insert(0, TESTS)
import rough_setups
warnings.simplefilter("ignore")
elastic, other = sc.Material.elastic(210e9, 0.3), sc.Material.elastic(300e9, 0.2)
warm = elastic.with_thermal(50.0, 1e-5, 1.4e-5)
steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
kinematic = sc.Material.perfect_plastic(210e9, 0.3, 1e9).with_kinematic_hardening(20e9)
BODIES = {
    "plastic": steel, "mirrored": steel, "repeated": steel, "backstress": kinematic,
    "layered_field": sc.Layered([(other, 1e-4)], elastic),
    "layered_plastic": sc.Layered([(steel, 1e-4)], steel), "field": elastic,
}

def status(name):
    with open("/proc/self/status") as lines:
        return next(1024 * int(line.split()[1]) for line in lines if line.startswith(name))

requested = [0.0]
memory._MAX_UNCHECKED_BYTES = 0.0
memory.require = lambda what, needed, remedy="": requested.append(needed)

def computed(problem):
    kind, n, nz = problem.split()
    n, nz = int(n), int(nz)
    ends = "xy" if kind == "repeated" else ""
    grid = sc.Grid(n, n, 2e-3 / n, 2e-3 / n, nz, 1e-3 / nz if nz else None, ends)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    flat = 1e-9 * np.random.default_rng(1).random(gap.shape)
    pull = dict(load=300.0, tangential_load=(30.0, 10.0))
    field = np.ones((n, n))
    if kind in ("exact", "fast"):
        strain = np.zeros((6, n, n, nz))
    if kind in BODIES:
        sim = sc.Simulation(grid, elastic, BODIES[kind], gap, residual_stress="fast",
                            on_border="warn")
        r2 = (grid.x[:, None] ** 2 + 0.9 * grid.y**2) / 1e-6
        tilt = 0 if kind == "mirrored" else 100
        pressure = np.sqrt(np.maximum(0, 1 - r2)) * (1 + tilt * (grid.x[:, None] + grid.y))
        if "field" in kind:
            state = sim.step(pressure=1e9 * pressure)
    if kind == "zones":
        sim = rough_setups.simulation(grid=sc.Grid(n, n, 1e-6, 1e-6, nz, 1e-6),
                                      gap=rough_setups.rough_gap(grid=sc.Grid(n, n, 1e-6, 1e-6)))
        sim.step(load=1e-6)
    requested.clear()
    before = status("VmHWM")
    if kind == "contact":
        sc.ContactSolver(grid, elastic, elastic).solve(gap, load=300.0)
    elif kind == "coupled":
        sc.ContactSolver(grid, elastic, other, 0.3).solve(gap, load=300.0)
    elif kind == "heated":
        heat = dict(heat=sc.Heat(1e-3, [1.0, 0.0]))
        sc.ContactSolver(grid, sc.Material.rigid(), warm, 0.1, **heat).solve(gap, load=300.0)
    elif kind == "simulation":
        sc.Simulation(grid, elastic, elastic, gap).step(load=300.0)
    elif kind == "layered":
        sc.Simulation(grid, elastic, BODIES["layered_field"], gap, 0.3).step(load=300.0)
    elif kind == "sticking":
        sc.Simulation(grid, elastic, other, gap, sc.Coulomb(0.3)).step(**pull)
    elif kind == "sticking_all_over":
        sc.Simulation(grid, elastic, other, flat, sc.Coulomb(0.3), on_border="warn").step(**pull)
    elif kind == "partial_slip":
        sc.ContactSolver(grid, elastic, elastic, sc.Coulomb(0.3)).solve(gap, **pull)
    elif kind == "rolling":
        sc.rolling.steady(grid, elastic, elastic, gap, load=300.0, friction=sc.Coulomb(0.3),
                          creepage=(1e-3, 0.0))
    elif kind == "zones":
        state = sim.step(load=0.01 * 4.2e9 * (n * 1e-6) ** 2)
        assert len(state.zones(2)) > 3
    elif kind == "displacement":
        sc.operators.surface_displacement(grid, field, 2e11, 0.3)
    elif kind == "stress":
        sc.operators.surface_stress(grid, field, grid.z, 0.3)
    elif kind in ("exact", "fast"):
        sc.operators.residual_stress(grid, strain, 2e11, 0.3, method=kind)
    elif "field" in kind:
        state.stress()
    elif kind in BODIES:
        state = sim.step(pressure=(2e9 if kind == "backstress" else 3e9) * pressure)
        assert (state.max_equivalent_plastic_strain() > 0)
    return status("VmHWM") - before, sum(requested)
"""
)
SETUPS = [
    "contact 700 0",
    "coupled 500 0",
    "heated 300 0",
    "simulation 600 0",
    "displacement 1000 0",
    "stress 100 50",
    "exact 48 24",
    "fast 90 40",
    "field 100 40",
    "plastic 60 36",
    "mirrored 100 40",
    "repeated 60 40",
    "backstress 50 30",
    "layered 400 0",
    "layered_field 60 40",
    "layered_plastic 60 40",
    "zones 192 12",
    "sticking 400 0",
    "sticking_all_over 200 0",
    "partial_slip 500 0",
    "rolling 400 0",
]
FEW_SETUPS, ALL_SETUPS = TRIALS["memory: estimates"]
assert (len(SETUPS[::2]), len(SETUPS)) == (FEW_SETUPS, ALL_SETUPS)


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@with_trials("memory: estimates")
def test_memory_estimates_agree_with_measurements(count):
    with contextlib.closing(Nursery(MEASURED)) as nursery:
        ratios = {}
        for problem in SETUPS if count == ALL_SETUPS else SETUPS[::2]:
            result, _ = nursery.run(problem)
            measured, requested = map(float, result.strip("()").split(","))
            assert measured > 15e6, problem  # otherwise the test proves nothing
            ratios[problem] = requested / measured
    assert {problem: r for problem, r in ratios.items() if not 0.7 < r < 1.5} == {}


HUGE = sc.Grid(60_000, 60_000, 1e-6, 1e-6, 1000, 1e-6)
FLAT = np.broadcast_to(0.0, HUGE.surface_shape)
REFUSED = {
    "contact": lambda: sc.ContactSolver(HUGE, ELASTIC, ELASTIC),
    "coupled": lambda: sc.ContactSolver(HUGE, ELASTIC, OTHER, 0.3),
    "heated": lambda: sc.ContactSolver(HUGE, ELASTIC, WARM, heat=sc.Heat(1e-3, reference=1.0)),
    "elastic": lambda: sc.Simulation(HUGE, ELASTIC, ELASTIC, FLAT),
    "plastic": lambda: sc.Simulation(HUGE, ELASTIC, STEEL, FLAT),
}


@pytest.mark.parametrize("name", REFUSED)
def test_huge_grids_are_refused(name, monkeypatch):
    monkeypatch.setattr(memory, "available", lambda: 16e9)
    message = r"ny = 60000, nz = 1000 requires about [\d.e+]+ GB of memory, 16 GB available"
    with pytest.raises(MemoryError, match=message):
        REFUSED[name]()


GRID = sc.Grid(120, 120, LENGTH / 120, LENGTH / 120, 80, 1e-3 / 80)
PRESSURE = np.ones(GRID.surface_shape)
FIELDS = {
    "stress of tractions": lambda: operators.surface_stress(GRID, PRESSURE, np.arange(80.0), 0.3),
    "residual stress": lambda: operators.residual_stress(
        GRID, np.zeros((6, *GRID.volume_shape)), 2e11, 0.3
    ),
    "print": lambda: operators.residual_displacement(GRID, np.zeros((6, *GRID.volume_shape)), 0.3),
    "stress of a solution": lambda: sc.ContactSolver(GRID, ELASTIC, ELASTIC).stress(
        PRESSURE, np.arange(80.0)
    ),
    "temperature": lambda: sc.ContactSolver(
        GRID, ELASTIC, WARM, heat=sc.Heat(1e-3, [1.0, 0.0])
    ).temperature(PRESSURE, np.arange(160.0)),
    "field of a state": lambda: sc.Simulation(
        GRID, ELASTIC, ELASTIC, np.zeros(GRID.surface_shape)
    ).state.stress(),
}
assert len(REFUSED) + len(FIELDS) + 1 == TRIALS["memory: refusals"][0]


@pytest.mark.parametrize("name", FIELDS)
def test_fields_beyond_the_memory_are_refused(name, monkeypatch):
    monkeypatch.setattr(memory, "available", lambda: 60e6)
    with pytest.raises(MemoryError, match=r"requires about \d\.\d+ GB of memory, 0\.06 GB"):
        FIELDS[name]()


def test_a_plastic_zone_beyond_the_memory_is_refused_and_the_state_is_kept(monkeypatch):
    """The size of the zone is known only during the solve; the core checks before allocation."""

    def problem():
        grid = sc.Grid(81, 81, 18e-6, 18e-6, 60, 18e-6)
        gap = surfaces.paraboloid(grid, 7.5e-3)
        return sc.Simulation(grid, ELASTIC, STEEL, gap, residual_stress="fast")

    simulation = problem()
    simulation.step(load=400.0)
    before = simulation.state.pressure.copy()
    with monkeypatch.context() as patch:
        patch.setattr(memory, "_MAX_UNCHECKED_BYTES", 0.0)
        patch.setattr(memory, "available", lambda: 20e6)
        message = r"the plastic zone, \d+ x \d+ x \d+ cells, requires about"
        with pytest.raises(MemoryError, match=message):
            simulation.step(load=1500.0)
    np.testing.assert_array_equal(simulation.state.pressure, before)
    other = problem()
    other.step(load=400.0)
    np.testing.assert_array_equal(
        simulation.step(load=1500.0).plastic_strain(), other.step(load=1500.0).plastic_strain()
    )


def test_available_memory_is_read_correctly():
    there = memory.available()
    assert there is not None
    assert 1e8 < there < 1e15


def test_a_memory_limit_of_the_process_is_respected():
    script = """
import resource
from samcontact._util import memory
def computed(_):
    used = 4096 * int(open("/proc/self/statm").read().split()[0])
    resource.setrlimit(resource.RLIMIT_AS, (used + 500_000_000, resource.RLIM_INFINITY))
    return memory.available()
"""
    with contextlib.closing(Nursery(script)) as nursery:
        assert 3e8 < float(nursery.run("")[0]) < 5.1e8


def test_the_command_reports_missing_memory(tmp_path, monkeypatch):
    from click.testing import CliRunner

    from samcontact.commands.main import main

    text = (
        'title = "t"\ngrid = {nx = 60000, ny = 60000, dx = 1e-6, dy = 1e-6}\n'
        'body1 = {law = "elastic", E = 2e11, nu = 0.3}\nbody2 = {law = "rigid"}\n'
        'surface = {shape = "paraboloid", Rx = 1.0}\npath = [{load = 1.0}]\n'
    )
    (tmp_path / "huge.toml").write_text(text)
    monkeypatch.setattr(memory, "available", lambda: 16e9)
    arguments = ["run", str(tmp_path / "huge.toml"), "--output", str(tmp_path / "out")]
    outcome = CliRunner().invoke(main, arguments)
    assert outcome.exit_code == 1
    assert re.search(r"error: .*nx = 60000, ny = 60000 requires about \d+ GB", outcome.output)


SMALL_CASE = """
title = "small plastic"
estimate_error = false
grid = {nx = 13, ny = 13, dx = 70e-6, dy = 70e-6, nz = 8, dz = 60e-6}
body1 = {law = "elastic", E = 210e9, nu = 0.3}
body2 = {law = "swift", E = 210e9, nu = 0.3, B = 945e6, C = 20, n = 0.121}
surface = {shape = "paraboloid", Rx = 7.5e-3}
path = [{load = 600.0, increments = 3}, {load = 0.0, increments = 1}]
"""


@pytest.mark.skipif(sys.platform != "linux", reason="limits the address space")
@pytest.mark.parametrize("megabytes", [300, 480])
def test_a_run_in_a_small_address_space_is_refused_immediately(megabytes, tmp_path):
    """OpenBLAS loaded after the solve requested memory without end; HDF5 crashed."""
    (tmp_path / "case.toml").write_text(SMALL_CASE)
    limited = (
        f"import resource; resource.setrlimit(resource.RLIMIT_AS, ({megabytes} << 20,) * 2)\n"
        "from samcontact.commands.main import main\n"
        "main(['run', 'case.toml', '--output', 'out', '--quiet', '--no-figures'])"
    )
    done = subprocess.run(
        [sys.executable, "-c", limited],
        env=os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"},
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 1
    assert done.stderr.startswith("error: not enough memory: the command requires about")
    assert "ulimit -v" in done.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.skipif(sys.platform != "linux", reason="limits the address space")
@pytest.mark.parametrize("use", ["scipy.special.erf(0.0)", "simulation.save('there.h5')"])
def test_libraries_that_crash_without_memory_are_not_called(use, tmp_path):
    script = f"""
import resource
import samcontact as sc
from samcontact._util.lazy_scipy import scipy
grid = sc.Grid(8, 8, 1e-4, 1e-4)
elastic = sc.Material.elastic(210e9, 0.3)
simulation = sc.Simulation(grid, elastic, elastic, sc.surfaces.paraboloid(grid, 7.5e-3))
with open("/proc/self/statm") as sizes:
    used = int(sizes.read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + (40 << 20),) * 2)
try:
    {use}
except MemoryError as error:
    print(error)
"""
    done = subprocess.run(
        [sys.executable, "-c", script], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.stdout.startswith("not enough memory: "), done.stderr
    assert list(tmp_path.iterdir()) == []
