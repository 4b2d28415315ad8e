# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of V. Boucly's thesis (INSA Lyon 2008, section 2.3.1 and Table 2.1).

Where the thesis states a number it is named; the targets asserted are those of independent
computations of the same cases (finite elements, a fine elastic solution, a separate prototype of
the method), because the thesis reads its maxima off a coarse mesh.
"""

from pathlib import Path

import numpy as np
import pytest

import samcontact as sc
from reference import fem
from samcontact.cases import load_case

CASES = Path(__file__).parents[2] / "cases"
ELASTIC = sc.Material.elastic(210e9, 0.3)
STEEL_52100 = sc.Material.swift(210e9, 0.3, B=945e6, C=20, n=0.121)
RADIUS = 7.5e-3
MICRO_YIELD = 1476.7e6  # of 52100 at 20 microstrain: the thesis's "onset of yield"


def two_balls(cells, body1=ELASTIC, body2=STEEL_52100, load=1500.0, size=(1.3, 1.6), **settings):
    hertz = sc.hertz.point(R=RADIUS, E_star=sc.hertz.effective_modulus(body1, body2), load=load)
    n, d = 2 * int(size[0] * cells) + 1, hertz.a / cells
    grid = sc.Grid(n, n, d, d, int(size[1] * cells), d)
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    return sc.Simulation(grid, body1, body2, gap, **settings)


@pytest.fixture(
    scope="module", params=["case", pytest.param("fine", marks=pytest.mark.slow)], name="run"
)
def pressed_and_released(request):
    """Return the mesh, and the states at the largest load and after unloading."""
    if request.param == "case":
        simulation, path = load_case(CASES / "t1_two_balls.toml").build()
        mesh = "a/16, 12 increments"
    else:
        simulation, path = two_balls(32), sc.paths.load_unload(load=1500.0, increments=24)
        mesh = "a/32, 24 increments"
    states = simulation.run(path, progress=False)
    peak = max(range(len(states)), key=lambda k: states[k].load)
    return mesh, states[peak], states[-1]


@pytest.fixture(scope="module")
def load_driven():
    simulation, path = load_case(CASES / "v1_nano_indentation.toml").build()
    return simulation, simulation.run(path, progress=False)


class TestTwoBallsAt1500N:
    """Table 2.1: R = 7.5 mm, 1500 N, AISI 52100, no heat; finite elements: case 2b1500."""

    TABLE = "Two balls of steel 52100"
    FEM = fem.load("2b1500").summary

    def test_elastic_maximum(self, measured):
        simulation = two_balls(16, ELASTIC, ELASTIC)
        von_mises = simulation.step(load=1500.0).von_mises()
        depth = simulation.grid.z[np.unravel_index(von_mises.argmax(), von_mises.shape)[2]]
        # exact: 0.62004 p0 at 0.4809 a = 201 um
        for source, expected in (("closed form", 2539.4), ("thesis", 2537.9)):
            measured.close(self.TABLE, "elastic: maximum von Mises stress", 1e-6 * von_mises.max(),
                           expected, unit="MPa", rel=2e-3, source=source, mesh="a/16")  # fmt: skip
        measured.close(self.TABLE, "elastic: depth of this maximum", 1e6 * depth, 200, unit="µm",
                       abs=1e6 * simulation.grid.dz, source="thesis", mesh="a/16")  # fmt: skip

    def test_loaded(self, run, measured):
        mesh, loaded, _ = run
        von_mises = loaded.von_mises()
        depth = loaded.grid.z[np.unravel_index(von_mises.argmax(), von_mises.shape)[2]]
        found = 1e-9 * loaded.pressure.max()
        measured.close(self.TABLE, "maximum pressure", found, 1e-9 * self.FEM["p_max_Pa"],
                       unit="GPa", rel=5e-3, source="FEM", mesh=mesh)  # fmt: skip
        largest = 1e-6 * self.FEM["loaded"]["max_vm_Pa"]
        for source, expected in (("FEM", largest), ("thesis", 2349.1)):
            measured.close(self.TABLE, "maximum von Mises stress", 1e-6 * von_mises.max(), expected,
                           unit="MPa", rel=1.5e-3, source=source, mesh=mesh)  # fmt: skip
        measured.close(self.TABLE, "depth of this maximum", 1e6 * depth, 202, unit="µm", abs=20,
                       source="FEM", mesh=mesh)  # fmt: skip
        strain = 100 * loaded.equivalent_plastic_strain().max()
        largest = 100 * self.FEM["loaded"]["max_gamma_p"]
        # the thesis gives two digits
        for source, expected, rel in (("FEM", largest, 0.01), ("thesis", 0.18, 0.03)):
            measured.close(self.TABLE, "maximum γ", strain, expected, unit="%", rel=rel,
                           source=source, mesh=mesh)  # fmt: skip

    def test_unloaded(self, run, measured):
        mesh, _, unloaded = run
        residual = 1e-6 * unloaded.von_mises().max()
        largest = 1e-6 * self.FEM["unloaded"]["max_vm_Pa"]
        for source, expected, rel in (("FEM", largest, 0.02), ("thesis", 135.5, 0.05)):
            measured.close(self.TABLE, "residual von Mises stress", residual, expected, unit="MPa",
                           rel=rel, source=source, mesh=mesh)  # fmt: skip
        assert np.allclose(unloaded.stress(), unloaded.residual_stress(), atol=1e-3)

    def test_onset_of_yield(self, measured):
        # Elastic stress grows with the cube root of the load, so one solution gives the onset; the
        # parabola through the largest layer and its neighbours removes the error of the layers'
        # spacing.
        simulation = two_balls(20, ELASTIC, ELASTIC, load=296.0)
        state = simulation.step(load=296.0)
        profile = state.von_mises().max(axis=(0, 1))
        k = int(profile.argmax())
        below, top, above = profile[k - 1 : k + 2]
        largest = top + (below - above) ** 2 / (8 * (2 * top - below - above))
        onset = 296.0 * (MICRO_YIELD / largest) ** 3
        for source, expected, rel in (("fine grid", 296, 5e-3), ("thesis", 298, 1.5e-2)):
            measured.close(self.TABLE, "load at first yield", onset, expected, unit="N", rel=rel,
                           source=source, mesh="a/20")  # fmt: skip


def test_one_increment_and_many_increments_agree():
    # Backward Euler with the consistent total increment: converges for any step.
    found = []
    for increments in (1, 6, 12):
        simulation = two_balls(10)
        state = simulation.run(sc.paths.ramp(load=1500.0, increments=increments), progress=False)[
            -1
        ]
        assert state.converged
        assert state.substeps == 1
        found.append((state.pressure.max(), state.equivalent_plastic_strain().max()))
    at_once, coarse, fine = np.array(found)
    assert np.all(np.abs(coarse / fine - 1) < 5e-3)
    assert np.all(np.abs(at_once / fine - 1) < 2e-2)


class TestWork:
    """Number of fixed-point evaluations, each with one residual stress, to tol 1e-6."""

    @staticmethod
    def contact_iterations_per_evaluation(simulation):
        return simulation.counters["contact_iterations"] / simulation.counters["contact_solves"]

    def test_increments_of_five_per_cent(self):
        simulation = two_balls(16)
        states = simulation.run(sc.paths.ramp(load=1500.0, increments=20), progress=False)
        assert max(state.iterations for state in states) <= 8
        assert self.contact_iterations_per_evaluation(simulation) <= 5

    def test_the_whole_load_at_once(self):
        simulation = two_balls(16)
        assert simulation.step(load=1500.0).iterations <= 10
        assert self.contact_iterations_per_evaluation(simulation) <= 5

    def test_8_GPa_at_once(self):
        simulation = two_balls(16, load=11179.0, size=(1.8, 2.4))
        state = simulation.step(load=11179.0)
        assert state.iterations <= 14
        assert state.substeps == 1
        assert self.contact_iterations_per_evaluation(simulation) <= 5


@pytest.fixture(scope="module")
def many():
    """Load to 8 GPa and unload in 200 increments; return the peak and the unloaded state."""
    load = TestIncrementTolerance.LOAD
    simulation = two_balls(8, load=load, size=(1.8, 2.4), body1=STEEL_52100)
    path = sc.paths.load_unload(load=load, increments=100)
    states = simulation.run(path, progress=False)
    assert len(states) == 200
    return states[99], states[-1]


@pytest.fixture(scope="module")
def tight():
    """Return the same two states of two increments that are divided to the tolerance."""
    return divided(increment_tol=TestIncrementTolerance.TOL)


def divided(**options):
    load = TestIncrementTolerance.LOAD
    simulation = two_balls(8, load=load, size=(1.8, 2.4), body1=STEEL_52100, **options)
    return [simulation.step(load=load), simulation.step(load=0.0)]


class TestIncrementTolerance:
    """Two elastic-plastic balls loaded to a Hertz pressure of 8 GPa and unloaded."""

    LOAD = 11179.0
    TOL = 2e-3

    def errors(self, found, expected):
        loaded = found[0].pressure.max() / expected[0].pressure.max() - 1
        strains = [f.equivalent_plastic_strain().max() / e.equivalent_plastic_strain().max() - 1
                   for f, e in zip(found, expected, strict=True)]  # fmt: skip
        return np.abs([loaded, *strains])

    def test_the_increment_tolerance_is_met_in_few_sub_increments(self, tight, many):
        assert (self.errors(tight, many) < self.TOL).all()
        assert sum(state.substeps for state in tight) <= 14
        for state in tight:
            assert state.yield_violation <= 1e-6

    def test_one_increment_without_tolerance_is_inaccurate(self, many):
        assert (self.errors(divided(), many)[:1] > 0.02).all()

    def test_a_looser_tolerance_needs_fewer_sub_increments(self, tight):
        loose = divided(increment_tol=0.05)
        assert sum(s.substeps for s in loose) < sum(s.substeps for s in tight)


class TestNanoIndentation:
    """Rigid sphere of 105 um on nitrided steel, 0.650 N: largest interference 372 nm."""

    TABLE = "Nano-indentation"

    def test_largest_interference(self, load_driven, measured):
        simulation, states = load_driven
        largest = 1e9 * max(s.approach for s in states)
        measured.close(self.TABLE, "maximum interference", largest, 372, unit="nm", rel=5e-3,
                       mesh=self.mesh(simulation))  # fmt: skip
        assert max(s.load for s in states) == pytest.approx(0.650)

    def test_displacement_driven_gives_the_same_curve(self, load_driven, measured):
        simulation, states = load_driven
        other = sc.Simulation(
            simulation.grid, simulation.body1, simulation.body2, simulation.initial_gap
        )
        # As many increments, but at other points of the curve: half-way between those of the load.
        approach = np.array([0.0, *(s.approach for s in states)])
        load = np.array([0.0, *(s.load for s in states)])
        top = int(approach.argmax())
        up = np.append(0.5 * (approach[1:top] + approach[2 : top + 1]), approach[top])
        driven = other.run([{"approach": float(d)} for d in up], progress=False)
        expected = np.interp(up**1.5, approach[: top + 1] ** 1.5, load[: top + 1])
        found = np.array([s.load for s in driven])
        difference = 100 * np.abs(found - expected).max() / load[top]
        measured.close(self.TABLE, "load and displacement control, largest difference of the load",
                       difference, 0, unit="%", abs=0.2, mesh=self.mesh(simulation))  # fmt: skip

    @staticmethod
    def mesh(simulation):
        return "x".join(str(count) for count in simulation.grid.volume_shape)


@pytest.mark.parametrize(
    ("body1", "inelastic", "target", "stated"),
    [
        (ELASTIC, "one body elastic-plastic", 1572.0, 1649.0),
        (STEEL_52100, "both bodies elastic-plastic", 1695.0, 1743.0),
    ],
    ids=["one body elastic-plastic", "both elastic-plastic"],
)
def test_load_at_conventional_yield(body1, inelastic, target, stated, measured):
    """Load at which the plastic strain reaches 0.2 %. The thesis states 1649 and 1743 N, 5 and 3 %
    more, but its own 0.18 % at 1500 N agrees with the lower values."""
    simulation = two_balls(12, body1, load=1750.0)
    load = np.concatenate([np.linspace(400, 1400, 6), np.linspace(1500, 1750, 6)])
    strain = [
        max(s.equivalent_plastic_strain(body=b).max() for b in (1, 2))
        for s in simulation.run([{"load": w} for w in load], progress=False)
    ]
    reached = float(np.interp(2e-3, strain, load))
    references = (("separate implementation", target, 2e-2), ("thesis", stated, 6e-2))
    for source, expected, rel in references:
        measured.close("Load at a plastic strain of 0.2 %", inelastic, reached, expected, unit="N",
                       rel=rel, source=source, mesh="a/12, 12 increments")  # fmt: skip
    assert reached < stated
