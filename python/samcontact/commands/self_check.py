# SPDX-License-Identifier: GPL-3.0-or-later
"""Versions of the components of an installation, and a self-test that takes a few seconds."""

from __future__ import annotations

import ctypes
import importlib.util
import os
import platform
import re
import tempfile
from collections.abc import Callable, Iterator
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np

from .. import hertz, surfaces
from .._util.check import Check
from .._util.version import version
from ..bodies.material import Material
from ..problem.grid import Grid
from ..simulation.simulation import Simulation

__all__ = ["installation", "self_check"]

REQUIRED_PACKAGES = (
    "numpy", "scipy", "matplotlib", "pydantic", "xarray", "h5netcdf", "h5py", "jinja2", "pandas",
    "click", "rich", "tqdm",
)  # fmt: skip
# library: (extra of samcontact that installs the library, purpose of the library)
OPTIONAL_PACKAGES = {"vtk": ("vtk", "export for ParaView")}
# CPU flags required for each x86-64 level for which the core has compiled loops.
SIMD_LEVELS = {
    "x86-64-v4 (AVX-512)": {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"},
    "x86-64-v3 (AVX2)": {"avx2", "bmi1", "bmi2", "f16c", "fma", "abm", "movbe"},
}
R, E, NU = 7.5e-3, 210e9, 0.3  # radius [m], Young's modulus [Pa], Poisson's ratio of the self-test


def installation() -> list[tuple[str, str]]:
    """Return versions and settings, as pairs of name and text.

    Returns
    -------
    list of (str, str)
        Package, Python, machine, compiler, FFTW, SIMD level, threads, and versions of libraries.
    """
    core = Path(_core_file())
    library = ctypes.CDLL(str(core))  # already loaded; used to look up symbols only
    return [
        ("samcontact", version),
        ("Python", f"{platform.python_version()} ({platform.python_implementation()})"),
        ("machine", f"{platform.system()} {platform.machine()}"),
        ("compiler", _compiler(core)),
        ("FFTW", f"{_fftw(library)}, plans by estimate"),
        ("SIMD", _simd()),
        ("threads", _threads(library)),
        *(
            (name, _version(name) or "missing: pip install samcontact")
            for name in REQUIRED_PACKAGES
        ),
        *_optional(),
    ]


def _core_file() -> str:
    found = importlib.util.find_spec("samcontact._core")
    if found is None or found.origin is None:  # not expected: the import would have failed before
        raise FileNotFoundError("the compiled core is missing: reinstall samcontact")
    return found.origin


def _compiler(core: Path) -> str:
    """Return the version of the compiler, which is read from the file of the compiled core."""
    pattern = rb"GCC: \([^)\0]*\) [\d.]+|clang version [\d.]+"
    found = sorted({text.decode() for text in re.findall(pattern, core.read_bytes())})
    return ", ".join(found) or "unknown"


def _fftw(library: ctypes.CDLL) -> str:
    try:
        version = (ctypes.c_char * 64).in_dll(library, "fftw_version").value
    except ValueError:  # statically linked without exported symbols
        return "unknown"
    return version.decode().removeprefix("fftw-")


def _simd() -> str:
    """Return the x86-64 level (SIMD instructions) of the compiled loops that this machine uses."""
    if platform.machine() not in ("x86_64", "AMD64"):
        return "one level only"
    try:
        text = Path("/proc/cpuinfo").read_text()
    except OSError:
        return "unknown"
    line = re.search(r"^flags\s*:(.*)$", text, re.MULTILINE)
    if line is None:
        return "unknown"
    flags = set(line.group(1).split())
    needed: set[str] = set()
    best = "x86-64 (SSE2)"
    for level, own in reversed(SIMD_LEVELS.items()):
        needed |= own
        if needed <= flags:
            best = level
    return best


def _threads(library: ctypes.CDLL) -> str:
    try:
        count = min(library.omp_get_max_threads(), library.omp_get_thread_limit())
    except AttributeError:
        return "1 (built without OpenMP)"
    given = os.environ.get("OMP_NUM_THREADS")
    source = f"OMP_NUM_THREADS={given}" if given else "OMP_NUM_THREADS not set"
    return f"{count} of {os.cpu_count()} processors ({source})"


def _version(name: str) -> str | None:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return None


def _optional() -> Iterator[tuple[str, str]]:
    for name, (extra, purpose) in OPTIONAL_PACKAGES.items():
        missing = f"absent ({purpose}): pip install samcontact[{extra}]"
        yield name, _version(name) or missing


def self_check() -> Iterator[Check]:
    """Solve small contacts and compare them with known results.

    Yields
    ------
    Check
        Each check as soon as it is computed. If a test raises an exception, a failed check is
        yielded, whose name contains the error.
    """
    for part in (_hertz, _plastic, _checkpoint):
        yield from _guarded(part)


def _guarded(part: Callable[[], Iterator[Check]]) -> Iterator[Check]:
    try:
        yield from part()
    except Exception as error:  # any error is reported as a failed check
        text = f"{part.__name__.strip('_')}: {type(error).__name__}: {error}"
        yield Check(text, float("nan"), 0.0)


def _hertz() -> Iterator[Check]:
    """Compare an elastic contact, solved with 14 cells per contact radius, with Hertz theory."""
    steel = Material.elastic(E, NU)
    exact = hertz.point(R, hertz.effective_modulus(steel, steel), load=1000.0)
    step = exact.a / 14.0
    grid = Grid(35, 35, step, step)
    state = Simulation(grid, steel, steel, surfaces.paraboloid(grid, R)).step(load=1000.0)
    pressure = abs(float(state.pressure.max()) / exact.p0 - 1.0)
    # limits: a few times the discretisation error known from validation at this resolution
    yield Check("Hertz: relative error of the maximum pressure", pressure, 5e-3)
    approach = abs(state.approach / exact.approach - 1.0)
    yield Check("Hertz: relative error of the approach", approach, 2e-3)


def _plastic_simulation() -> Simulation:
    ball, flat = Material.elastic(E, NU), Material.swift(E, NU, 945e6, 20.0, 0.121)
    grid = Grid(15, 15, 60e-6, 60e-6, 12, 60e-6)
    return Simulation(grid, ball, flat, surfaces.paraboloid(grid, R))


def _plastic() -> Iterator[Check]:
    simulation = _plastic_simulation()
    state = simulation.step(load=600.0)
    tol = simulation.tol
    strain = state.max_equivalent_plastic_strain(body=2)
    yield Check("elastic-plastic: maximum plastic strain", strain, 1e-5, at_least=True)
    yield Check("elastic-plastic: plastic-strain residual", state.plastic_strain_residual, tol)
    yield Check("elastic-plastic: violation of the yield condition", state.yield_violation, tol)
    total = float(state.pressure.sum()) * simulation.grid.cell_area
    yield Check("elastic-plastic: load balance", abs(total / 600.0 - 1.0), tol)


def _checkpoint() -> Iterator[Check]:
    """Compare a simulation continued from a checkpoint with an uninterrupted simulation."""
    straight = _plastic_simulation()
    straight.step(load=500.0)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "checkpoint.h5"
        straight.save(file)
        resumed = Simulation.load(file)
    states: list[Any] = [simulation.step(load=0.0) for simulation in (straight, resumed)]
    first, second = (state.residual_displacement(body=2) for state in states)
    difference = float(np.max(np.abs(first - second)))
    yield Check("checkpoint: difference in residual displacement [m]", difference, 0.0)
