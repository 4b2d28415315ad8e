# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings of under-resolved contacts and of pressures beyond linear elasticity."""

import math
import re
import warnings

import numpy as np
import pytest
import scipy.ndimage

import samcontact as sc
from case_texts import MINIMAL
from samcontact import _core, report, results
from samcontact.cases import parse_case
from samcontact.diagnostics import hertz_estimate, resolution

ELASTIC = re.sub("n?[zBCn] = .*\n|dz = .*\n", "", MINIMAL).replace("swift", "elastic")
STEEL = sc.Material.elastic(210e9, 0.3)
YIELDING = sc.Material.linear_hardening(210e9, 0.3, 2e9, 20e9)
R, LOAD = 7.5e-3, 1500.0
HERTZ = sc.hertz.point(R, sc.hertz.effective_modulus(STEEL, STEEL), load=LOAD)


def problem(cells, layers=12.0, depth=1.6, body2=YIELDING, **settings):
    """Return a simulation with these numbers of cells and layers per contact radius."""
    dx, dz = HERTZ.a / cells, HERTZ.a / layers
    n = 2 * math.ceil(1.4 * cells) + 1
    grid = sc.Grid(n, n, dx, dx, nz=max(1, round(depth * layers)), dz=dz)
    return sc.Simulation(grid, STEEL, body2, sc.surfaces.paraboloid(grid, R), **settings)


def stated(run, kind=sc.ResolutionWarning):
    """Return the texts of the warnings of one class."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        run()
    return [str(one.message) for one in caught if issubclass(one.category, kind)]


def test_cells_are_counted_across_the_spot_of_maximum_pressure():
    pressure = np.zeros((40, 30))
    pressure[2:30, 3:25] = 1.0  # a large spot
    pressure[33:36, 10:17] = 2.0
    pressure[36, 17] = 0.5  # joined by its corner
    assert resolution.cells_across(pressure) == 4
    pressure[33:37, 10:18] = 0.0
    assert resolution.cells_across(pressure) == 22
    assert math.isnan(resolution.cells_across(np.zeros((5, 5))))
    strip = np.zeros((40, 30))
    strip[10:20] = 1.0  # as wide as the grid, so this side is disregarded
    assert resolution.cells_across(strip) == 10


@pytest.mark.parametrize("shape", ["ring", "cross", "diagonal", "chequered"])
def test_a_contact_that_is_wide_but_thin_is_coarse(shape):
    """The spot is 19 cells long and wide, and a cell or two thick."""
    i, j = np.abs(np.indices((29, 29)) - 14)
    body = {
        "ring": np.abs(np.hypot(i, j) - 9) < 0.7,
        "cross": (np.minimum(i, j) == 0) & (np.maximum(i, j) < 10),
        "diagonal": (i == j) & (i < 10),
        "chequered": ((i + j) % 2 == 0) & (np.maximum(i, j) < 10),
    }[shape]
    solver = sc.ContactSolver(sc.Grid(29, 29, 1e-5, 1e-5), sc.Material.rigid(), STEEL)
    gap = np.where(body, 0.0, np.inf)
    (text,) = stated(lambda: solver.solve(gap, load=1.0))
    assert "at load 1 N the contact is a ring or line about " in text


def test_a_ring_of_eight_cells_is_fine():
    grid = sc.Grid(80, 80, 1e-5, 1e-5)
    gap = (np.hypot(*np.meshgrid(grid.x, grid.y, indexing="ij")) - 2.5e-4) ** 2 / 2e-3
    assert stated(lambda: sc.ContactSolver(grid, STEEL, STEEL).solve(gap, load=80.0)) == []


def test_the_limits_of_a_run_are_eight_cells_and_eight_layers():
    path = [{"load": load} for load in (0.02 * LOAD, LOAD, 0.0)]

    def texts(**grid):
        return stated(lambda: problem(**grid).run(path, progress=False))

    # the first increment has three cells across: only the largest load counts
    assert texts(cells=8) == []
    assert ["cells across" in text for text in texts(cells=3)] == [True]
    assert ["under-resolved plastic zone" in text for text in texts(cells=8, layers=4)] == [True]


def test_a_single_increment_warns_once_of_severe_under_resolution():
    simulation = problem(cells=1.4)
    (text,) = stated(lambda: [simulation.step(load=load) for load in (0.5 * LOAD, LOAD)])
    assert "is only 3 cells across" in text
    assert stated(lambda: problem(cells=5).step(load=LOAD)) == []


def test_layers_too_coarse_to_show_yield_cause_a_warning():
    soft = sc.Material.perfect_plastic(210e9, 0.3, 2.2e9)  # yields just below 0.4 radii
    run = problem(8, 0.5, 2, body2=soft)
    (text,) = stated(lambda: run.run([{"load": LOAD}], progress=False))
    assert "appears elastic" in text
    assert "too coarse" in text
    hard = sc.Material.perfect_plastic(210e9, 0.3, 9e9)
    assert stated(lambda: problem(8, 0.5, 2, body2=hard).step(load=LOAD)) == []


def test_datasets_contain_cell_counts_and_reports_fail_below_a_limit():
    for cells, passes in ((8, True), (1.4, False)):
        run = problem(cells, layers=1.5 * cells)
        dataset = results.to_dataset(run, run.run([{"load": LOAD}, {"load": 0.0}], progress=False))
        across, after = dataset["cells_across_contact"].values
        assert abs(across - 2 * cells) <= 1.5
        assert math.isnan(after)
        assert float(dataset["layers_across_plastic_zone_body2"][1]) == pytest.approx(
            1.5 * cells, rel=0.5
        )
        checks = {check.name: check for check in report.checks(dataset)}
        assert checks["cells across the contact at maximum load"].passed is passes
        assert checks["layers across the plastic zone, body 2"].passed is passes


def discs(diameter, count=9, shift=0.3):
    """Return round spots on a square lattice, at different positions within their cells."""
    side, middle = 2 * math.ceil(diameter) + 8, np.arange(count)
    field = np.zeros((count * side, side))
    for n in middle:
        x, y = np.arange(side) - 0.5 * side + shift * n, np.arange(side) - 0.5 * side - 0.7 * n % 1
        field[n * side :][:side] = np.hypot(x[:, None], y) < 0.5 * diameter
    return field


def test_the_area_uncertainty_follows_from_the_outlines():
    for diameter in (8, 20, 50):
        found = resolution.area_uncertainty(discs(diameter))
        assert found == pytest.approx(resolution.ROUND_SPOT_AREA_ERROR / diameter, rel=0.05)
        # the grid edge is no side of a spot, unless the surface is periodic
        half = discs(diameter, 1, 0.0)[diameter + 4 :]
        assert resolution.area_uncertainty(half) < resolution.area_uncertainty(half, "x")
    assert math.isnan(resolution.area_uncertainty(np.zeros((5, 5))))
    assert resolution.spots(discs(8)) == 9
    corners = np.ones((9, 9))
    corners[3:6], corners[:, 3:6] = 0.0, 0.0
    assert resolution.spots(corners) == 4
    assert resolution.spots(corners, "xy") == 1


@pytest.mark.parametrize("share", [0.01, 0.1, 0.5, 0.9, 1.0])
def test_single_spots_are_found_without_labels(share):
    """Spots and their range agree with those of SciPy for random, round and bent contacts."""
    chance = np.random.default_rng(3)
    for k in range(60):
        n, m = chance.integers(1, 12, 2)
        pressure = chance.random((n, m)) * (chance.random((n, m)) < share)
        if k % 3 == 0:  # a convex or bent band
            i, j = np.ogrid[:n, :m]
            pressure = np.maximum(0.0, 4.0 - abs(j - m // 2 - chance.integers(-1, 2) * i)) + 0.0 * i
        labels, count = scipy.ndimage.label(pressure > 0, structure=np.ones((3, 3)))
        assert resolution.spots(pressure) == count
        if count:
            at = labels.flat[pressure.argmax()]
            assert resolution.main_spot(pressure) == scipy.ndimage.find_objects(labels)[at - 1]
        else:
            assert resolution.main_spot(pressure) is None


def test_rough_contacts_with_small_spots_cause_a_warning():
    def press(cells):
        grid = sc.Grid(4 * cells, 4 * cells, 40e-6 / cells, 40e-6 / cells)
        gap = sc.surfaces.paraboloid(grid, 20e-3)
        gap += sc.surfaces.sinusoidal(grid, 0.2e-6, 40e-6, 40e-6)
        run = sc.Simulation(grid, STEEL, STEEL, gap)
        states = []
        texts = stated(lambda: states.extend(run.run([{"load": 0.3}], progress=False)))
        counted = np.count_nonzero(states[-1].pressure) * grid.cell_area
        return texts, counted, results.to_dataset(run, states)

    counts = {}
    for cells in (16, 64):
        texts, area, dataset = press(cells)
        share = float(dataset["area_uncertainty"][0])
        checks = {check.name: check.passed for check in report.checks(dataset)}
        fine = cells == 64
        assert checks["relative uncertainty of the contact area at maximum load"] is fine
        assert (share < resolution.AREA_ERROR_WARNING) is fine
        expected = [] if fine else [f"uncertain by about {100 * share:.0f} %.*: 16 spots"]
        assert len(texts) == len(expected)
        assert all(re.search(*pair) for pair in zip(expected, texts, strict=True))
        counts[cells] = area, share
    assert counts[16][0] / counts[64][0] - 1 == pytest.approx(counts[16][1], rel=0.3)


def test_a_sweep_warns_once_and_keeps_its_errors(tmp_path):
    case = parse_case(ELASTIC)
    sizes = [1e-9, 60e-6, 60e-3, 61e-3]
    values = {"grid.dx": sizes}
    (text,) = stated(lambda: sc.sweep(case, values, output=tmp_path, progress=False))
    assert "of 4 cases: 2 with fewer than 8 cells across the contact" in text
    with results.open_results(tmp_path / "sweep.nc") as stored:
        assert stored["status"].values.tolist() == ["failed", "done", "done", "done"]
        assert "µm" in str(stored["error"].values[0])  # not only ASCII


def test_a_modulus_in_gigapascals_is_named_with_hertz_and_before_the_solve():
    grid = sc.Grid(31, 31, 36e-6, 36e-6)
    gap = sc.surfaces.paraboloid(grid, R)
    slip = sc.Material.elastic(210.0, 0.3)
    text = r"reaches the edge .* Hertz: radius 418.2 mm, .* with E\* = 115.4 Pa .* 210e9"
    with pytest.raises(sc.GridTooSmallError, match=text):
        sc.ContactSolver(grid, slip, slip).solve(gap, load=LOAD)
    simulation = sc.Simulation(grid, slip, slip, gap)
    with pytest.raises(sc.GridTooSmallError, match=text):
        simulation.run([{"load": 1e-9}, {"load": LOAD}], progress=False)
    assert simulation.counters["contact_solves"] == 0


def test_hertz_estimates_are_used_for_smooth_convex_gaps_only():
    grid = sc.Grid(40, 50, 1e-5, 2e-5)
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    rotated = 0.5 * ((x + y) ** 2 / 2 / 4e-3 + (x - y) ** 2 / 2 / 9e-3) + 3e-6 + 1e-3 * x

    def setup_of(gap):
        return hertz_estimate.ContactSetup(grid, gap, (STEEL, STEEL))

    assert setup_of(rotated).radii == pytest.approx((9e-3, 4e-3), rel=1e-9)
    rough = rotated + 2e-5 * np.random.default_rng(1).standard_normal(grid.surface_shape)
    for gap in (rough, x**2, x**2 - y**2, -rotated, 0 * x, np.abs(x)):
        assert setup_of(gap).hertz(load=1.0) is None


def test_pressures_beyond_linear_elasticity_cause_a_warning():
    R_slip = 1e-3 * R
    contact = sc.hertz.point(R_slip, sc.hertz.effective_modulus(STEEL, STEEL), load=LOAD)
    grid = sc.Grid(41, 41, contact.a / 15, contact.a / 15)
    gap = sc.surfaces.paraboloid(grid, R_slip)
    solver = sc.ContactSolver(grid, STEEL, STEEL)
    (text,) = stated(lambda: solver.solve(gap, load=LOAD), sc.ElasticStrainWarning)
    assert "of the contact modulus" in text
    simulation = sc.Simulation(grid, STEEL, STEEL, gap)
    steps = [LOAD, 1.1 * LOAD]
    found = stated(lambda: [simulation.step(load=load) for load in steps], sc.ElasticStrainWarning)
    assert len(found) == 1


def test_a_resolved_smooth_contact_causes_no_warning():
    run = problem(8)
    assert stated(lambda: run.run([{"load": LOAD}, {"load": 0.0}], progress=False), Warning) == []


def test_half_a_roller_is_no_paraboloid_of_another_unit():
    """The drop of a profile resembles a parabola in the middle, and not at the end of a roller."""
    load, length = 15e3, 10e-3
    b = sc.hertz.line(5e-3, sc.hertz.effective_modulus(STEEL, STEEL), load / length).b

    def gap(grid):
        return sc.surfaces.roller(grid, 5e-3, length, "logarithmic")

    grid = sc.Grid(26, 101, b / 8, 0.5 * length / 101)
    solver = sc.ContactSolver(grid, STEEL, STEEL)
    assert stated(lambda: solver.solve(gap, load=load), Warning) == []
    assert hertz_estimate.ContactSetup(grid, gap(grid), (STEEL, STEEL)).hertz(load=load) is None


def test_a_rough_gap_is_approximated_by_the_paraboloid_of_least_squares():
    """Compared with NumPy at the 17 x 17 points from edge to edge of the grid."""
    grid = sc.Grid(33, 49, 1e-5, 2e-5)
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    gap = (x + 0.4 * y) ** 2 / 8e-3 + y**2 / 3e-2 + 1e-3 * x + 5e-6
    gap += 0.01 * np.ptp(gap) * np.random.default_rng(2).uniform(-1, 1, gap.shape)
    x, y, heights = (field[::2, ::3].ravel() for field in (x, y, gap))
    terms = np.stack([np.ones_like(x), x, y, 0.5 * x**2, x * y, 0.5 * y**2], axis=1)
    found = np.linalg.lstsq(terms / np.abs(terms).max(axis=0), heights)[0]
    xx, xy, yy = (found / np.abs(terms).max(axis=0))[3:]
    curvatures, planes = np.linalg.eigh([[xx, xy], [xy, yy]])
    deviation = np.abs(terms @ (found / np.abs(terms).max(axis=0)) - heights).max()

    larger, smaller, cosine, reach = _core.paraboloid_of(gap, grid._core, 0.03, 0.1)
    assert (larger, smaller) == pytest.approx(1 / curvatures, rel=1e-11)
    assert abs(cosine) == pytest.approx(abs(planes[0, 0]), rel=1e-11)
    # along each axis, the deviation grows with the fourth power of the distance from the edge
    for far, side, curvature in zip(reach, (grid.x[-1], grid.y[-1]), (xx, yy), strict=True):
        assert deviation * (far / side) ** 4 == pytest.approx(0.1 * 0.5 * curvature * far**2)
    assert _core.paraboloid_of(gap, grid._core, 0.99 * deviation / np.ptp(heights), 0.1) is None
