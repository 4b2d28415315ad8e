# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic-plastic half-space against axisymmetric finite elements (reference/fem).

Tolerances are those that the finite element data themselves support (reference/fem/README.md):
p_max 0.5 %, approach 0.2 %, maximum plastic strain 1 %, loaded von Mises stress 1 %, residual von
Mises stress 2 %, imprint depth 2 %, profiles 2 % rms of their maximum. They are met with 16 cells
per Hertz radius and 16 load increments. The differences of finer runs, marked slow, decrease
further.
"""

import numpy as np
import pytest

import samcontact as sc
from reference import fem

ELASTIC = sc.Material.elastic(210e9, 0.3)
STEEL_52100 = sc.Material.swift(210e9, 0.3, B=945e6, C=20, n=0.121)
STEEL_M50 = sc.Material.swift(210e9, 0.3, B=1280e6, C=4, n=0.095)
BILINEAR = sc.Material.linear_hardening(210e9, 0.3, 1e9, 21e9)

CONTACT = {  # upper body, lower body, equivalent radius [m], load [N]
    "2a": (sc.Material.rigid(), STEEL_M50, 10e-3, 800.0),
    "2b1500": (ELASTIC, STEEL_52100, 7.5e-3, 1500.0),
}
PRESCRIBED = {  # lower body, p0 [Pa], width and depth of the volume in units of a
    "1b": (STEEL_52100, 6.5e9, 1.6, 2.2),
    "1c": (BILINEAR, 3.0e9, 1.3, 1.7),
}
RADIUS_1 = 1e-3  # of the prescribed pressure [m]


class Run:
    """One loading and unloading, and differences from finite elements."""

    def __init__(self, name, cells, increments, **settings):
        self.name, self.mesh = name, f"a/{cells}, {increments} increments"
        self.case = fem.load(name)
        self.summary = self.case.summary
        if name in CONTACT:
            self._contact(name, cells, increments, settings)
        else:
            self._prescribed(name, cells, increments, settings)
        self.grid = self.loaded.grid
        self.axis = (self.grid.nx // 2, self.grid.ny // 2)

    def _grid(self, radius, cells, width, depth):
        n = 2 * int(width * cells) + 1
        d = radius / cells
        self.radius = radius
        return sc.Grid(n, n, d, d, int(depth * cells), d)

    def _contact(self, name, cells, increments, settings):
        upper, lower, R, load = CONTACT[name]
        hertz = sc.hertz.point(R=R, E_star=sc.hertz.effective_modulus(upper, lower), load=load)
        grid = self._grid(hertz.a, cells, 1.25, 1.6)
        simulation = sc.Simulation(grid, upper, lower, self._gap(grid, R), **settings)
        for step in sc.paths.ramp(load=load, increments=increments):
            self.loaded = simulation.step(**step)
        self.unloaded = simulation.step(load=0.0)

    def _gap(self, grid, R):
        return sc.surfaces.paraboloid(grid, R)

    def _prescribed(self, name, cells, increments, settings):
        lower, p0, width, depth = PRESCRIBED[name]
        grid = self._grid(RADIUS_1, cells, width, depth)
        # Cell means of the semi-ellipsoid: point values would lose load at the edge.
        inner = (np.arange(10) - 4.5) / 10 * grid.dx
        x, y = (c[:, None] + inner for c in (grid.x, grid.y))
        r2 = x[:, :, None, None] ** 2 + y[None, None] ** 2
        pressure = p0 * np.sqrt(np.maximum(0, 1 - r2 / RADIUS_1**2)).mean(axis=(1, 3))
        flat = np.zeros((grid.nx, grid.ny))
        simulation = sc.Simulation(grid, ELASTIC, lower, flat, **settings)
        for k in range(1, increments + 1):
            self.loaded = simulation.step(pressure=pressure * (k / increments))
        self.unloaded = simulation.step(pressure=0 * pressure)

    def scalars(self):
        """Return scalar results of the simulation and of finite elements."""
        loaded, unloaded = self.summary["loaded"], self.summary["unloaded"]
        von_mises = self.loaded.von_mises()[self.axis].max()
        residual = self.unloaded.von_mises()[self.axis].max()
        print_ = self.unloaded.residual_displacement()[self.axis]
        centre = self.loaded.surface_displacement()[self.axis]
        found = {
            "γ": (self.loaded.equivalent_plastic_strain().max(), loaded["max_gamma_p"]),
            "von Mises stress": (von_mises, loaded["max_vm_Pa"]),
            "residual von Mises stress": (residual, unloaded["max_vm_Pa"]),
            "imprint depth": (print_, self.summary["uz_center_residual_m"]),
            "u_z under load": (centre, self.summary["uz_center_loaded_m"]),
        }
        if "p_max_Pa" in self.summary:
            found["p_max"] = (self.loaded.pressure.max(), self.summary["p_max_Pa"])
            found["approach"] = (self.loaded.approach, self.summary["approach_max_m"])
        return found

    def record(self, measured, table, tolerances):
        for name, (ours, reference) in self.scalars().items():
            if name in tolerances:
                unit, scale = UNIT[name]
                measured.close(table, f"{self.name}: {name}", scale * ours, scale * reference,
                               unit=unit, rel=tolerances[name], mesh=self.mesh)  # fmt: skip

    def profiles(self):
        return profiles(self.case, self.loaded, self.unloaded, self.radius)


def profiles(case, loaded, unloaded, radius):
    """Return the largest rms difference of each kind of profile, relative to its maximum."""
    grid, found = loaded.grid, {}
    z, i, j = grid.z, grid.nx // 2, grid.ny // 2
    for kind, state, table in (
        ("stress under load", loaded, case.axis_loaded),
        ("residual stress", unloaded, case.axis_unloaded),
    ):
        stress, g = state.stress(), state.equivalent_plastic_strain()
        # The table's rows at z = 0 are extrapolated; below 1.5 a little is left to compare.
        rows = (z > table["z_m"][1]) & (z < 1.5 * radius)
        # Unloaded, szz is small everywhere: the scale is the largest residual stress.
        scale = np.abs(table["srr_Pa"]).max()
        for column, values, unit in (
            ("srr_Pa", stress[0], scale),
            ("szz_Pa", stress[2], scale),
            ("gamma_p", g, table["gamma_p"].max()),
        ):
            reference = np.interp(z[rows], table["z_m"], table[column])
            name = "γ" if column == "gamma_p" else kind
            difference = rms(values[i, j][rows] - reference) / unit
            found[name] = max(difference, found.get(name, 0.0))
    r, surface = grid.x[i:], case.surface_uz
    reference = np.interp(r, surface["r_m"], surface["uz_residual_m"])
    difference = unloaded.residual_displacement()[i:, j] - reference
    found["residual u_z"] = rms(difference) / np.abs(surface["uz_residual_m"]).max()
    if case.pressure_r.size:
        # Near the edge the finite elements' own pressure is not to be trusted.
        inside = r < 0.9 * radius
        reference = np.interp(r[inside], case.pressure_r["r_m"], case.pressure_r["p_Pa"])
        difference = loaded.pressure[i:, j][inside] - reference
        found["pressure"] = rms(difference) / case.pressure_r["p_Pa"].max()
    return found


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


TOLERANCE = {
    "p_max": 0.005,
    "approach": 0.002,
    "γ": 0.01,
    "von Mises stress": 0.01,
    "residual von Mises stress": 0.02,
    "imprint depth": 0.02,
    "u_z under load": 0.005,
}
# Of quantities that feel the plastic strain; 12 cells are below what the tolerances above ask for.
PLASTIC = ("γ", "residual von Mises stress", "imprint depth")
COARSE_TOLERANCE = dict.fromkeys(PLASTIC, 0.02)
FINE_TOLERANCE = TOLERANCE | dict.fromkeys(PLASTIC, 0.005)
UNIT = {
    "p_max": ("GPa", 1e-9),
    "approach": ("µm", 1e6),
    "γ": ("%", 100.0),
    "von Mises stress": ("MPa", 1e-6),
    "residual von Mises stress": ("MPa", 1e-6),
    "imprint depth": ("µm", 1e6),
    "u_z under load": ("µm", 1e6),
}
CASES = [*CONTACT, *PRESCRIBED]


@pytest.fixture(scope="module", params=CASES)
def run(request):
    return Run(request.param, cells=16, increments=16)


def test_headline_numbers(run, measured):
    run.record(measured, "Finite elements", TOLERANCE)


def test_profiles(run, measured):
    for name, difference in run.profiles().items():
        measured.close("Finite elements, profiles", f"{run.name}: {name}", 100 * difference, 0,
                       unit="%", abs=2.0, mesh=run.mesh)  # fmt: skip


def test_unloading_is_elastic(run):
    before = run.loaded.equivalent_plastic_strain()
    assert np.array_equal(before, run.unloaded.equivalent_plastic_strain())


class Shallow(Run):
    """Run with few output layers; plastic flow extends below them."""

    def _grid(self, radius, cells, width, depth):
        return super()._grid(radius, cells, width, 0.5)


class Open(Run):
    """Run without a given number of layers."""

    def _grid(self, radius, cells, width, depth):
        grid = super()._grid(radius, cells, width, depth)
        return sc.Grid(grid.nx, grid.ny, grid.dx, grid.dy, dz=grid.dz)


class Growing(Open):
    """Run with a small initial grid, which is enlarged automatically."""

    def _grid(self, radius, cells, width, depth):
        return super()._grid(radius, cells, 0.3, depth)

    def _gap(self, grid, R):
        self.first = grid
        return lambda grid: sc.surfaces.paraboloid(grid, R)


@pytest.mark.parametrize("name", CONTACT)
def test_grid_width_need_not_be_known(name):
    wide, small = (kind(name, cells=8, increments=6) for kind in (Open, Growing))
    assert small.first.nx < 6 < wide.grid.nx <= small.grid.nx
    expected = wide.scalars()
    for quantity, (value, _) in small.scalars().items():
        assert value == pytest.approx(expected[quantity][0], rel=1e-4), quantity


@pytest.mark.filterwarnings("ignore:.*plastic strain:samcontact.GridTooSmallWarning")
@pytest.mark.parametrize("name", ["2b1500", "1b"])
def test_depth_need_not_be_known(name):
    deep, without, shallow = (kind(name, cells=8, increments=6) for kind in (Run, Open, Shallow))
    expected = deep.scalars()
    for quantity, (value, _) in without.scalars().items():
        assert value == pytest.approx(expected[quantity][0], rel=1e-4), quantity
    assert without.loaded.depths[-1] > shallow.loaded.depths[-1] == shallow.grid.z[-1]
    for ours, theirs in ((shallow.loaded, deep.loaded), (shallow.unloaded, deep.unloaded)):
        for quantity in ("max_equivalent_plastic_strain", "max_plastic_strain_magnitude"):
            assert getattr(ours, quantity)() == pytest.approx(getattr(theirs, quantity)(), rel=1e-4)
        np.testing.assert_allclose(
            ours.residual_displacement(), theirs.residual_displacement(), rtol=0, atol=1e-11
        )


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_differences_fall_with_refinement(name, measured):
    coarse, fine = (Run(name, cells=cells, increments=cells) for cells in (12, 24))
    coarse.record(measured, "Finite elements, refined", COARSE_TOLERANCE)
    fine.record(measured, "Finite elements, refined", FINE_TOLERANCE)
    one, other = coarse.scalars(), fine.scalars()
    for quantity in PLASTIC:
        errors = [abs(ours / reference - 1) for ours, reference in (one[quantity], other[quantity])]
        assert errors[1] < 0.6 * errors[0]


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_exact_and_fast_residual_stress(name, measured):
    """Both methods differ less from each other than from the finite elements on this mesh."""
    runs = [Run(name, 12, 12, residual_stress=method) for method in ("exact", "fast")]
    exact, fast = (run.scalars() for run in runs)
    largest = max(abs(exact[quantity][0] / fast[quantity][0] - 1) for quantity in PLASTIC)
    measured.close("Finite elements, exact residual stress",
                   f"{name}: largest change of {', '.join(PLASTIC)}",
                   100 * largest, 0, unit="%", abs=0.25, mesh=runs[0].mesh)  # fmt: skip


class TestPerfectPlasticity:
    """Case 2d: a rigid paraboloid loaded to ten critical interferences and unloaded."""

    CRITICAL, RADIUS = 1.10909e-6, 10e-3
    TABLE = "Perfect plasticity"

    @pytest.fixture(
        scope="class",
        name="pressed",
        params=[(12, 20), pytest.param((24, 40), marks=pytest.mark.slow)],
        ids=["coarse", "fine"],
    )
    @staticmethod
    def pressed_and_released(request):
        """Return the mesh, states at equal steps of the approach, and the unloaded state."""
        critical, radius = TestPerfectPlasticity.CRITICAL, TestPerfectPlasticity.RADIUS
        cells, increments = request.param
        d = np.sqrt(10 * critical * radius) / cells
        n = 2 * int(1.6 * cells) + 1
        grid = sc.Grid(n, n, d, d, int(2.75 * cells), d)
        simulation = sc.Simulation(
            grid,
            sc.Material.rigid(),
            sc.Material.perfect_plastic(200e9, 0.32, 0.9115e9),
            sc.surfaces.paraboloid(grid, radius),
        )
        top = 10 * critical
        states = [simulation.step(approach=top * k / increments) for k in range(1, increments + 1)]
        mesh = f"sqrt(R ω)/{cells}, {increments} increments"
        return mesh, states, simulation.step(load=0.0)

    @pytest.mark.parametrize(
        ("interference", "tolerances"),
        [(3, (0.01, 0.025, 0.025)), (5, (0.01, 0.02, 0.015)), (10, (0.01, 0.01, 0.01))],
    )
    def test_loading(self, pressed, interference, tolerances, measured):
        curve = fem.load("2d").load_displacement
        rising = curve[: int(np.argmax(curve["approach_m"])) + 1]
        mesh, states, _ = pressed
        state = states[interference * len(states) // 10 - 1]
        assert state.substeps == 1
        found = (
            ("load", "load_N", "N", 1.0, state.load),
            ("p_max", "p_max_Pa", "GPa", 1e-9, state.pressure.max()),
            ("γ", "gamma_p_max", "%", 100.0, state.equivalent_plastic_strain().max()),
        )
        for (name, column, unit, scale, ours), rel in zip(found, tolerances, strict=True):
            expected = scale * np.interp(state.approach, rising["approach_m"], rising[column])
            measured.close(self.TABLE, f"ω/ω_c = {interference}: {name}", scale * ours, expected,
                           unit=unit, rel=rel, mesh=mesh)  # fmt: skip

    def test_unloaded(self, pressed, measured):
        summary = fem.load("2d").summary
        mesh, _, unloaded = pressed
        print_ = unloaded.residual_displacement()
        centre = print_[print_.shape[0] // 2, print_.shape[1] // 2]
        expected = 1e6 * summary["uz_center_residual_m"]
        measured.close(self.TABLE, "unloaded: imprint depth", 1e6 * centre, expected, unit="µm",
                       rel=0.01, mesh=mesh)  # fmt: skip
        largest = 1e-6 * unloaded.von_mises().max()
        expected = 1e-6 * summary["unloaded"]["max_vm_Pa"]
        measured.close(self.TABLE, "unloaded: residual von Mises stress", largest, expected,
                       unit="MPa", rel=0.04, mesh=mesh)  # fmt: skip

    def test_profiles(self, pressed, measured):
        radius = np.sqrt(10 * self.CRITICAL * self.RADIUS)
        mesh, states, unloaded = pressed
        found = profiles(fem.load("2d"), states[-1], unloaded, radius)
        assert "pressure" in found
        for name, difference in found.items():
            measured.close("Perfect plasticity, profiles", name, 100 * difference, 0, unit="%",
                           abs=4.0 if len(states) == 20 else 1.0, mesh=mesh)  # fmt: skip
