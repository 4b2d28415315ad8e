# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic strain in several subdomains compared with a single box."""

import pickle
import warnings

import numpy as np
import pytest

import samcontact as sc
from openmp import outputs_with
from rough_setups import (
    CELLS,
    ELASTIC,
    GAP,
    KINEMATIC,
    LAYERS,
    NU,
    PERCENT,
    PERFECT,
    RIGID,
    SIZE,
    SOFT,
    STEEL,
    E,
    assert_few_errors,
    rms,
    rough_gap,
    same,
    simulation,
    zone_counts,
    zones_of,
)
from samcontact import _core, operators
from samcontact.solutions.strained_cells import strained_extent

pytestmark = pytest.mark.filterwarnings(
    "ignore::samcontact.GridTooSmallWarning", "ignore::samcontact.PlasticStrainWarning"
)
METAL = 45.0, 12e-6, 12e-6
HOT = STEEL.with_thermal(*METAL).with_softening(sc.softening.JohnsonCook(melting=1800.0, m=1.0))
HEAT = sc.Heat([0.0, 1.0])
MOVING = sc.Heat([0.5, 1.0], velocity=[[30.0, 0.0], [-30.0, 0.0]], time=1e-6)
ALONG_Y = sc.Heat([0.0, 1.0], velocity=[0.0, 30.0], time=1e-6)
OBLIQUE = sc.Heat([0.0, 1.0], velocity=[-10.0, 25.0], time=1e-6)
PATH = (2, 3, 0.5)
"""Percent of the surface in contact; what is prescribed for the third unloads."""


def both(*bodies, **options):
    """A contact solved with subdomains and with one box."""
    return [simulation(*bodies, zones=zones, **options) for zones in ("auto", "one")]


def plastic(sim):
    return [body for body, law in ((1, sim.body1), (2, sim.body2)) if law.is_plastic]


def assert_close(state, expected, bodies, tol=1e-3):
    assert_few_errors(state, expected, bodies, tol)
    assert state.contact_area == pytest.approx(expected.contact_area, rel=1e-3)
    assert state.gap.mean() == pytest.approx(expected.gap.mean(), rel=1e-4)


@pytest.mark.parametrize(
    ("body1", "body2", "options"),
    [
        (RIGID, STEEL, {}),
        (ELASTIC, KINEMATIC, {"friction": 0.2}),
        (RIGID, PERFECT, {}),
        (SOFT, STEEL, {}),
        (STEEL, STEEL, {}),
        (ELASTIC, HOT, {"friction": 0.2, "heat": HEAT}),
        (SOFT.with_thermal(*METAL), STEEL.with_thermal(*METAL), {"friction": 0.2, "heat": MOVING}),
        # oblique heat is also tested under a prescribed pressure
        pytest.param(RIGID, HOT, {"friction": 0.2, "heat": OBLIQUE}, marks=pytest.mark.slow),
        pytest.param(RIGID, HOT, {"friction": 0.2, "heat": ALONG_Y}, marks=pytest.mark.slow),
    ],
    ids=[
        *("hardening", "kinematic", "perfect", "unlike", "equal"),
        *("softening", "heat along x", "heat across", "heat along y"),
    ],
)
def test_subdomains_give_the_fields_of_one_box(body1, body2, options):
    sims = both(body1, body2, **options)
    bodies = plastic(sims[0])
    heated = "heat" in options
    again = (3.5,) if len(bodies) == 2 and not heated else ()
    for step, percent in enumerate((*(PATH[1:] if heated else PATH), *again)):
        zones, one = (sim.step(load=percent * PERCENT) for sim in sims)
        assert_close(zones, one, bodies)
        many, single = (zone_counts(sim) for sim in sims)
        assert max(many) > 1 or step > 0
        assert max(single) == 1


@pytest.mark.parametrize("options", [{}, {"heat": OBLIQUE}], ids=["cold", "hot"])
def test_under_a_prescribed_pressure(options):
    pressure = simulation(friction=0.2).step(load=2 * PERCENT).pressure
    sims = both(RIGID, STEEL.with_thermal(*METAL), friction=0.2, **options)
    for factor in (1.0, 1.05, 0.2):
        zones, one = (sim.step(pressure=factor * pressure) for sim in sims)
        assert_close(zones, one, [2])
    assert zone_counts(sims[0])[1] > 1 == zone_counts(sims[1])[1]


@pytest.mark.parametrize(
    ("friction", "heat", "motion"),
    [
        (0.2, sc.Heat([0.0, 0.5], [0.0, 20.0], history=(2e-7, 1e-5)), {}),
        (sc.Coulomb(0.3), sc.Heat(partition=0.5, time=1e-6), {"shift": (8e-7, 5e-7)}),
    ],
    ids=["of earlier steps", "of slip"],
)
def test_heat_not_proportional_to_the_pressure(friction, heat, motion, tmp_path):
    zones, one = both(ELASTIC.with_thermal(*METAL), HOT, friction=friction, heat=heat)
    for percent in (2, 1.0):
        step = {"load": percent * PERCENT, "duration": 5e-7, **motion}
        state, expected = zones.step(**step), one.step(**step)
        assert_close(state, expected, [2])
        assert rms(state.temperature(), expected.temperature()) < 1e-4
        if percent == 2:
            zones.save(tmp_path / "state.h5")
            again = sc.Simulation.load(tmp_path / "state.h5")
        else:
            assert same(again.step(**step), state)
    assert zone_counts(zones) == zone_counts(again) != zone_counts(one) == [0, 1]
    flows = state.equivalent_plastic_strain() > 0
    assert state.zones()[0].stress().any()
    found, expected = field_of_zones(state, 2, "stress"), state.stress()
    assert rms(found[:, flows], expected[:, flows]) < 2e-3
    assert rms(found[:, flows], state.residual_stress()[:, flows]) > 0.1
    assert state.temperature().max() > 10.0


def test_iterations_are_counted_where_zones_grow():
    sim = simulation(RIGID, PERFECT)
    states = sim.run([{"load": 2 * PERCENT}, {"load": 4 * PERCENT}], progress=False)
    assert sum(state.iterations for state in states) == sim.counters["plastic_iterations"]


def test_a_spot_at_the_grid_edge_agrees_with_a_wider_grid():
    """A contact whose subdomain extends beyond the grid."""
    margin, inside = 12, slice(12, -12)
    gap = rough_gap(bowl=0.0)  # periodic
    i, _ = np.unravel_index(np.argmin(gap), gap.shape)
    gap = np.roll(gap, 1 - i, axis=0)
    wide = sc.Grid(CELLS + 2 * margin, CELLS + 2 * margin, SIZE, SIZE, LAYERS, SIZE)
    sims = [
        simulation(gap=gap, friction=0.3),
        simulation(grid=wide, gap=np.pad(gap, margin, constant_values=1e-3), friction=0.3),
    ]
    for percent in PATH:
        state, wider = (sim.step(load=percent * PERCENT) for sim in sims)
        assert state.pressure[0].any()
        strain = wider.equivalent_plastic_strain()
        assert strain[:margin].any()
        assert rms(state.pressure, wider.pressure[inside, inside]) < 3e-4
        assert rms(state.equivalent_plastic_strain(), strain[inside, inside]) < 3e-4
        print_ = wider.residual_displacement()[..., inside, inside]
        assert rms(state.residual_displacement(), print_) < 3e-4
    assert min(zone_counts(sim)[1] for sim in sims) > 1


def test_a_grid_without_nz_changes_no_digit():
    opened = simulation(grid=sc.Grid(CELLS, CELLS, SIZE, SIZE, dz=SIZE))
    for sim in (opened, layered := simulation()):
        sim.run([{"load": percent * PERCENT} for percent in PATH], progress=False)
    layers = len(opened.state.depths)
    np.testing.assert_array_equal(opened.state.pressure, layered.state.pressure)
    np.testing.assert_array_equal(
        opened.state.plastic_strain(), layered.state.plastic_strain()[..., :layers]
    )
    assert zone_counts(opened) == zone_counts(layered)


@pytest.mark.parametrize(
    ("bodies", "options"),
    [
        ((RIGID, STEEL), {"residual_stress": "exact"}),
        ((RIGID, STEEL), {"grid": sc.Grid(CELLS, CELLS, SIZE, SIZE, 10, SIZE, "xy")}),
        ((RIGID, STEEL), {"gap": GAP + GAP[::-1]}),
    ],
    ids=["exact", "periodic", "mirrors"],
)
def test_what_cannot_be_split_stays_in_one_box(bodies, options):
    sims = both(*bodies, **options)
    zones, one = (sim.step(load=2 * PERCENT) for sim in sims)
    assert same(zones, one)
    assert zone_counts(sims[0]) == zone_counts(sims[1]) == [0, 1]


def test_continuation_from_a_file_or_a_pickle_changes_no_digit(tmp_path):
    sim = simulation(SOFT, KINEMATIC, friction=0.1)
    sim.step(load=PERCENT)
    assert min(zone_counts(sim)) > 1
    sim.save(tmp_path / "state.h5")
    others = [sc.Simulation.load(tmp_path / "state.h5"), pickle.loads(pickle.dumps(sim))]
    for percent in (2, 0.2):
        state = sim.step(load=percent * PERCENT)
        for other in others:
            assert same(other.step(load=percent * PERCENT), state, [1, 2])
    assert [zone_counts(other) for other in others] == [zone_counts(sim)] * 2
    assert [other.counters for other in others] == [sim.counters] * 2


THREADS = """
import hashlib, warnings
warnings.simplefilter("ignore")
from rough_setups import *
sim = simulation(SOFT, PERFECT, friction=0.2)
for percent in (1, 1.5):
    state = sim.step(load=percent * PERCENT)
    assert min(zone_counts(sim)) > 1, zone_counts(sim)
    parts = [state.stress(2), *fields(state, (1, 2)).values()]
    print(state.iterations, hashlib.sha256(b"".join(x.tobytes() for x in parts)).hexdigest())
"""


def test_the_number_of_threads_changes_no_digit():
    """Loops in the loop over subdomains share work space, also if OpenMP has threads for them."""
    alone, *others = outputs_with(THREADS, 1, 3, "1,3", "3,2")
    assert others == [alone] * 3
    assert len(alone.splitlines()) == 2


@pytest.mark.parametrize("cycles", [7, pytest.param(100, marks=pytest.mark.slow)])
def test_cycles_shake_down_in_subdomains_as_in_one_box(cycles):
    """Perfect plasticity does not oppose drift, so accumulating errors would be visible."""
    sums = []
    for sim in both(RIGID, PERFECT, friction=0.1):
        strains = []
        for _ in range(cycles):
            state = sim.step(load=3 * PERCENT)
            strains.append(state.equivalent_plastic_strain().sum())
            sim.step(load=2.4 * PERCENT)
        sums.append(strains)
    zones, one = np.array(sums)
    np.testing.assert_allclose(zones, one, rtol=1e-3)
    assert zones[-1] / zones[0] - 1 < 1e-3
    assert zones[-1] / zones[-4] - 1 < 1e-5


def two_balls(grid):
    x, y, radius = grid.x[:, None], grid.y, 150e-6
    heights = [(x - sign * 12e-6) ** 2 + (y - sign * 6e-6) ** 2 for sign in (-1, 1)]
    return np.minimum(heights[0], 1.3 * heights[1]) / (2 * radius)


def halves(state):
    """Boxes around the plastic strain at x < 0 and x > 0."""
    boxes = []
    for side in (-1, 1):
        cells = np.nonzero(
            state.equivalent_plastic_strain() * (side * state.grid.x > 0)[:, None, None]
        )
        first = [cells[0].min(), cells[1].min()]
        boxes.append(
            [*first, *(at.max() + 1 - i for at, i in zip(cells, [*first, 0], strict=True))]
        )
    return np.array(boxes)


@pytest.fixture(scope="module", params=[2, pytest.param(10, marks=pytest.mark.slow), "balls"])
def solved(request):
    """Return a state, and the boxes of its subdomains within the grid.

    The contact is a rough surface with a contact fraction of some percent, or two balls.
    """
    grid = sc.Grid(128, 128, SIZE, SIZE, 14, SIZE)
    balls = request.param == "balls"
    gap = two_balls(grid) if balls else rough_gap(0.0, grid)
    sim = simulation(grid=grid, gap=gap, friction=0.2)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        state = sim.step(load=(5 if balls else 4 * request.param) * PERCENT)
    zones = halves(state) if balls else zones_of(sim, 2)
    begin, end = np.maximum(zones[:, :2], 0), zones[:, :2] + zones[:, 2:4]
    zones = np.hstack([begin, np.minimum(end, 128) - begin, np.minimum(zones[:, 4:], 14)])
    assert len(zones) > (1 if balls else 10)
    return state, zones.tolist()


def field_of_zones(state, body, name):
    """Field on the grid, 0 outside the subdomains."""
    found = np.zeros_like(getattr(state, name)(body))
    for zone in state.zones(body):
        place = []
        for first, n, cells in zip((*zone.first, 0), zone.shape, found.shape[-3:], strict=True):
            at = first + np.arange(n)
            place.append((at[(at >= 0) & (at < cells)], (at >= 0) & (at < cells)))
        (i, inside_x), (j, inside_y), (k, inside_z) = place
        shown = getattr(zone, name)()[..., inside_x, :, :][..., inside_y, :][..., inside_z]
        found[..., i[:, None, None], j[:, None], k] = shown
    return found


@pytest.mark.parametrize("zones", ["auto", "one"])
def test_fields_of_subdomains_agree_with_the_grid_at_plastic_cells(zones):
    sim = simulation(SOFT, STEEL, friction=0.2, zones=zones)
    sim.step(load=2 * PERCENT)
    state = sim.step(load=3 * PERCENT)
    for body in (1, 2):
        assert (len(state.zones(body)) > 1) is (zones == "auto")
        for name in ("equivalent_plastic_strain", "plastic_strain", "residual_stress", "stress"):
            expected = getattr(state, name)(body)
            found = field_of_zones(state, body, name)
            flows = state.equivalent_plastic_strain(body) > 0
            exact = zones == "one" or "strain" in name
            assert rms(found[..., flows], expected[..., flows]) <= (0 if exact else 2e-3)
            if "strain" in name:
                assert np.array_equal(found, expected)
        assert_shows(state, body)


def assert_shows(state, body):
    strained = np.nonzero(state.equivalent_plastic_strain(body))
    assert strained_extent(state, body) == [(at.min(), at.max()) for at in strained]
    zone = state.zones(body)[0]
    assert np.array_equal(
        zone.x, sc.Grid(CELLS, CELLS, SIZE, SIZE).x[zone.first[0] :][: zone.shape[0]]
    )


class TestOperators:
    """Fields of subdomains at the plastic cells of a rough contact, against a single box."""

    def compared(self, solved, strain=0.0, pressure=0.0, shear=(0.0, 0.0)):
        """Return stress and reference at the plastic cells, and the surface displacements."""
        state, zones = solved
        grid, flows = state.grid, state.equivalent_plastic_strain() > 0
        strain, pressure = strain * state.plastic_strain(), pressure * state.pressure
        sheared = np.multiply.outer(shear, state.pressure)
        stress, displacement = _core.operators.zone_fields(
            grid._core, _core.Elastic.isotropic(E, NU), [zone[:5] for zone in zones],
            np.ascontiguousarray(np.moveaxis(strain, 3, 1)), pressure, *sheared, 1e-6,
        )  # fmt: skip
        expected = operators.surface_stress(grid, pressure, grid.z, NU, shear=sheared)
        if strain.any():
            expected = operators.residual_stress(grid, strain, E, NU, method="fast", image_tol=1e-6)
        return stress[:, flows], expected[:, flows], displacement

    def test_residual_stress_and_displacement(self, solved):
        stress, expected, displacements = self.compared(solved, strain=1.0)
        assert rms(stress, expected) < 1.5e-3
        assert abs(stress - expected).max() < 3e-3 * abs(expected).max()
        strain = solved[0].plastic_strain()  # without the strain outside the grid
        for axis, found in zip("xyz", displacements, strict=True):
            expected = operators.residual_displacement(solved[0].grid, strain, NU, axis=axis)
            assert rms(found, expected) < (3e-4 if axis == "z" else 1e-3), axis

    @pytest.mark.parametrize("load", [{"pressure": 1.0}, {"shear": (1.0, 0.0)}, {"shear": (0, 1)}])
    def test_stress_of_tractions(self, solved, load):
        stress, expected, _ = self.compared(solved, **load)
        assert rms(stress, expected) < 1e-3
        assert abs(stress - expected).max() < 1e-3 * abs(expected).max()
