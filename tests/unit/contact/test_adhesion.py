# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts with adhesion that depends on the gap: against closed forms and their conditions."""

import math
import warnings

import numpy as np
import pytest

import samcontact as sc
from benchmarks.adhesive_spheres import TRANSITIONS, maugis_error

pytestmark = pytest.mark.filterwarnings("ignore:the attraction at the edge")
R, W, E = 1e-6, 0.05, 1e9
TIP, SOFT = sc.Material.rigid(), sc.Material.elastic(E, 0.0)
JKR = sc.adhesion.jkr(R, W, E)
FORCE = math.pi * W * R
RADIUS = JKR.radius_at_pull_off
LENGTH = float(-JKR.approach(RADIUS / 3 ** (2 / 3)))  # approach of pull-off at given approach


def ball(n, box, law, **more):
    """Return solver and gap of a ball on n x n cells over a box, in radii at pull-off."""
    grid = sc.Grid(n, n, box * RADIUS / n, box * RADIUS / n)
    solver = sc.ContactSolver(grid, TIP, SOFT, adhesion=law, tol=1e-9, **more)
    return solver, sc.surfaces.paraboloid(grid, R)


def loads_along(solver, gap, approaches):
    solution, loads = None, []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for approach in approaches:
            start = None if solution is None else solution.pressure
            solution = solver.solve(gap, approach=approach, initial_pressure=start)
            loads.append(solution.load)
    return np.array(loads)


def branch_of_jkr(approaches):
    """Return the loads of JKR on the branch of retraction."""
    radii = np.linspace(RADIUS / 3 ** (2 / 3) * 1.0001, 4 * RADIUS, 4000)
    return np.interp(approaches, JKR.approach(radii), JKR.load(radii))


def test_a_refined_range_converges_to_jkr():
    """The error is of first order in the cell size, like the length of the cohesive zone."""
    approaches = np.arange(0.6, -0.6, -0.06) * LENGTH
    curves = [loads_along(*ball(n, 4.2, sc.Adhesion.jkr(W)), approaches) / FORCE for n in (48, 96)]
    extrapolated = 2 * curves[1] - curves[0]
    expected = branch_of_jkr(approaches) / FORCE
    assert np.abs(curves[1] - expected).max() < 0.07
    assert np.abs(extrapolated - expected).max() < 0.05
    assert -extrapolated.min() == pytest.approx(1.5, rel=0.02)


@pytest.mark.slow
def test_a_finely_refined_range_equals_jkr():
    approaches = np.arange(0.6, -0.6, -0.04) * LENGTH
    curves = [
        loads_along(*ball(n, 4.2, sc.Adhesion.jkr(W)), approaches) / FORCE for n in (100, 200)
    ]
    extrapolated = 2 * curves[1] - curves[0]
    assert np.abs(extrapolated - branch_of_jkr(approaches) / FORCE).max() < 0.02
    assert -extrapolated.min() == pytest.approx(1.5, rel=0.02)


def wavy_sphere_errors(cells):
    """Return the largest errors of the load of a wavy sphere relative to pi w R, by cells.

    The reference follows the branch of retraction, with its jumps over unstable radii.
    """
    length, amplitude = 0.8 * RADIUS, 0.05 * LENGTH
    wave = 2 * math.pi / length
    radii = np.linspace(0.05, 2.2, 3000) * RADIUS
    exact = sc.adhesion.jkr_profile(
        lambda r: r / R + amplitude * wave * np.sin(wave * r), radii, W, E
    )
    path = np.arange(0.8, -0.95, -0.1) * LENGTH
    last = np.array([np.flatnonzero(exact.approach < approach)[-1] for approach in path])
    between = (path - exact.approach[last]) / (exact.approach[last + 1] - exact.approach[last])
    expected = exact.load[last] + between * (exact.load[last + 1] - exact.load[last])
    curves = []
    for n in cells:
        solver, gap = ball(n, 4.6, sc.Adhesion.jkr(W), on_border="warn")
        r = np.hypot(solver.grid.x[:, None], solver.grid.y[None])
        curves.append(loads_along(solver, gap + amplitude * (1 - np.cos(wave * r)), path))
    curves.append(2 * curves[-1] - curves[-2])
    return [np.abs(curve - expected).max() / FORCE for curve in curves]


def test_a_wavy_sphere_converges_to_the_theory_of_guduru():
    """The waves change the load by up to 0.27 pi w R. The last error is extrapolated."""
    coarse, fine, extrapolated = wavy_sphere_errors((48, 96))
    assert fine < 0.75 * coarse < 0.12
    assert extrapolated < 0.07


@pytest.mark.slow
def test_a_finely_resolved_wavy_sphere_equals_the_theory_of_guduru():
    coarse, fine, extrapolated = wavy_sphere_errors((96, 192))
    assert fine < 0.75 * coarse
    assert extrapolated < 0.04


def test_constant_attraction_equals_maugis():
    assert maugis_error(1.0, 64, 0.15) < 0.012


@pytest.mark.slow
@pytest.mark.parametrize("transition", TRANSITIONS)
def test_constant_attraction_approaches_maugis(transition):
    coarse, middle, fine = (maugis_error(transition, n) for n in (64, 128, 256))
    assert middle < 0.01
    assert fine < 0.7 * middle < 0.49 * coarse


def test_the_pull_off_of_stiff_spheres_is_that_of_maugis():
    """Tabor number 0.1: the law of Maugis, and the exponential law of equal work and peak."""
    reach = (R * (W / E) ** 2 / 0.1**3) ** (1 / 3)
    theory = sc.adhesion.maugis(R, W, E, W / reach).pull_off
    for law, cells, box, tol in (
        (sc.Adhesion.dugdale(W, W / reach), 96, 8.0, 3e-3),
        (sc.Adhesion.exponential(W, reach), 64, 24.0, 0.01),
    ):
        solver, gap = ball(cells, box, law)
        loads = loads_along(solver, gap, np.arange(0.1, -0.85, -0.1) * LENGTH)
        assert 1 < loads.argmin() < len(loads) - 1
        assert -loads.min() == pytest.approx(theory, rel=tol)
    assert theory == pytest.approx(1.942 * FORCE, rel=1e-3)  # 3 % less than 2 pi w R
    assert -loads.min() == pytest.approx(1.959 * FORCE, rel=1e-3)


def test_the_limit_of_long_ranges_is_that_of_dmt():
    """Pull-off force 2 pi w R at the Tabor number 0.03, with all the attraction on the grid."""
    law = sc.Adhesion.exponential(W, (R * (W / E) ** 2 / 0.03**3) ** (1 / 3))
    solver, gap = ball(96, 44.0, law)
    pulled = -loads_along(solver, gap, np.arange(0.1, -0.4, -0.1) * LENGTH).min()
    assert pulled == pytest.approx(sc.adhesion.dmt(R, W), rel=5e-3)


def wave_error(alpha, share):
    """Return the relative error of the pull-off pressure of a wave.

    share: length of the cohesive zone over the wavelength.
    """
    length, amplitude = 1e-6, 1e-8
    flattening = math.pi * E * amplitude / length
    work = (alpha * flattening) ** 2 * length / (2 * E)
    law = sc.Adhesion.exponential(work, math.sqrt(4 * share * length * work / (math.pi * E)))
    cells = round(10.24 / share)
    grid = sc.Grid(cells, 1, length / cells, length / cells, periodic="xy")
    assert law.on(grid, TIP, SOFT).kappa < 0.4
    gap = amplitude * (1 - np.cos(2 * math.pi * grid.x / length))[:, None]
    solver = sc.ContactSolver(grid, TIP, SOFT, adhesion=law, tol=1e-9)
    loads = loads_along(solver, gap, amplitude * np.arange(0.94, -0.4, -0.02))
    expected = sc.adhesion.wave(length, amplitude, work, E).pull_off
    return -loads.min() / (length * grid.dy) / expected - 1


def test_waves_converge_to_johnson():
    """Errors of first order in the length of the cohesive zone, pi/4 range^2 E*/w."""
    errors = np.array([wave_error(0.4, share) for share in (0.04, 0.02, 0.01)])
    assert np.all(errors < 0)
    assert abs(errors[0]) < 0.025
    assert abs(errors[-1]) < 0.005
    assert np.all(errors[1:] / errors[:-1] < 0.5)


def test_approach_and_retraction_agree_on_one_branch():
    """Equal loads of approach and retraction: the contact edge does not stick to cells."""
    law = sc.Adhesion.exponential(W, 1.0e-9)
    solver, gap = ball(36, 4.2, law)
    assert law.on(solver.grid, TIP, SOFT).kappa < 0.6
    path = np.linspace(-0.2, 0.6, 9) * LENGTH
    up = loads_along(solver, gap, path)
    down = loads_along(solver, gap, path[::-1])[::-1]
    assert np.abs(up - down).max() < 1e-6 * FORCE


SCENES = {
    "free": ({}, {}),
    "periodic": ({"periodic": "xy"}, {}),
    "strip": ({"periodic": "x"}, {}),
    "layer": ({}, {"body2": sc.Layered([(sc.Material.elastic(4e9, 0.3), 2e-8)], SOFT)}),
    "tilted": ({}, {"tilt": (2e-3, -1e-3)}),
}


@pytest.mark.parametrize("law", ["exponential", "dugdale", "lennard_jones", "tabulated"])
@pytest.mark.parametrize("scene", SCENES)
def test_rough_contacts_satisfy_their_conditions(scene, law):
    """Equilibrium of each cell, with the displacement from the solver of hard contact."""
    settings, more = SCENES[scene]
    grid = sc.Grid(24, 20, 6e-9, 7e-9, **settings)
    laws = {
        "exponential": sc.Adhesion.exponential(0.03, 1.2e-9),
        "dugdale": sc.Adhesion.dugdale(0.03, 2e7),
        "lennard_jones": sc.Adhesion.lennard_jones(0.03, 1.6e-9),
        "tabulated": sc.Adhesion.tabulated([0.0, 1e-9, 3e-9], [1.5e7, 1.5e7, 0.0]),
    }
    body = more.get("body2", SOFT)
    solver = sc.ContactSolver(grid, TIP, body, adhesion=laws[law], tol=1e-10, on_border="warn")
    gap = np.random.default_rng(3).uniform(0.0, 3e-9, grid.surface_shape)
    if not grid.periodic:
        gap += sc.surfaces.paraboloid(grid, 3e-7)
    tilt = more.get("tilt", (0.0, 0.0))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = solver.solve(gap, approach=1e-9, **({"tilt": tilt} if any(tilt) else {}))
    resolved = laws[law].on(grid, TIP, body)
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    lowered = found.approach + tilt[0] * y - tilt[1] * x
    hard = sc.ContactSolver(grid, TIP, body)
    displacement = hard.displacement(found.pressure)[2]
    largest = max(resolved.law.peak, found.pressure.max())
    stiffness = resolved.kappa / resolved.law.steepest_fall
    if grid.periodic != "xy":  # otherwise the mean displacement is arbitrary
        np.testing.assert_allclose(
            found.gap, gap + displacement - lowered, atol=1e-7 * largest * stiffness * 100
        )
    assert found.gap.min() >= 0.0
    assert found.repulsion.min() >= 0.0
    assert np.all(found.gap[found.in_contact] == 0.0)
    assert found.in_contact.any()
    assert not found.in_contact.all()
    attraction = found.adhesion_stress
    assert attraction.min() >= -1e-9 * largest
    assert attraction.max() <= resolved.law.peak * (1 + 1e-6)
    assert found.load == pytest.approx(found.pressure.sum() * grid.cell_area, rel=1e-12)


def test_without_work_of_adhesion_the_contact_is_hard():
    weak = sc.Adhesion.exponential(1e-13, 1e-9)
    grid = sc.Grid(32, 32, 1e-8, 1e-8)
    gap = sc.surfaces.paraboloid(grid, R)
    hard = sc.ContactSolver(grid, TIP, SOFT, tol=1e-11).solve(gap, load=1e-6)
    found = sc.ContactSolver(grid, TIP, SOFT, adhesion=weak, tol=1e-11).solve(gap, load=1e-6)
    np.testing.assert_allclose(found.pressure, hard.pressure, atol=1e-6 * hard.pressure.max())
    assert found.approach == pytest.approx(hard.approach, rel=1e-8)


def test_a_load_is_found_on_its_branch_and_a_larger_tension_is_refused():
    solver, gap = ball(32, 4.2, sc.Adhesion.jkr(W))
    pressed = solver.solve(gap, load=0.5 * FORCE)
    same = solver.solve(gap, approach=pressed.approach)
    assert same.load == pytest.approx(0.5 * FORCE, rel=1e-6)
    path = np.arange(0.0, -0.7, -0.01) * LENGTH
    largest = -loads_along(solver, gap, path).min()
    pulled = solver.solve(gap, load=-0.95 * largest)
    assert pulled.load == -0.95 * largest
    with pytest.raises(sc.PullOffError, match="load must be at least") as caught:
        solver.solve(gap, load=-1.05 * largest, initial_pressure=pulled.pressure)
    assert isinstance(caught.value, sc.ConvergenceError)
    assert caught.value.pull_off == pytest.approx(largest, rel=3e-3)
    assert -0.7 * LENGTH < caught.value.approach < 0.0


def test_results_scale_with_the_units():
    solver, gap = ball(24, 4.2, sc.Adhesion.exponential(W, 1.5e-9))
    found = solver.solve(gap, approach=0.3 * LENGTH)
    length, stress = 1e3, 1e-4
    grid = sc.Grid(24, 24, solver.grid.dx * length, solver.grid.dy * length)
    law = sc.Adhesion.exponential(W * length * stress, 1.5e-9 * length)
    body = sc.Material.elastic(E * stress, 0.0)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.UnitWarning)
        other = sc.ContactSolver(grid, TIP, body, adhesion=law, tol=1e-9).solve(
            gap * length, approach=0.3 * LENGTH * length
        )
    np.testing.assert_allclose(
        other.pressure,
        found.pressure * stress,
        rtol=1e-9,
        atol=1e-9 * stress * found.pressure.max(),
    )


def test_friction_acts_on_the_repulsion_only():
    """Dissimilar bodies: the shear of the cells in contact moves the surfaces."""
    grid = sc.Grid(32, 32, 8e-9, 8e-9)
    stiff = sc.Material.elastic(3e9, 0.2)
    solver = sc.ContactSolver(
        grid, stiff, SOFT, 0.4, adhesion=sc.Adhesion.exponential(W, 1.5e-9), on_border="warn"
    )
    gap = sc.surfaces.paraboloid(grid, R)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = solver.solve(gap, approach=1e-9)
        smooth = sc.ContactSolver(
            grid, stiff, SOFT, adhesion=sc.Adhesion.exponential(W, 1.5e-9), on_border="warn"
        ).solve(gap, approach=1e-9)
    shift = np.abs(found.pressure - smooth.pressure).max() / smooth.pressure.max()
    assert shift > 1e-3
    assert np.all(found.gap[found.in_contact] < 1e-12)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"law": sc.Adhesion.exponential(W, 1e-11)}, "adhesion must be resolved by the grid"),
        ({"heat": sc.Heat(1e-3)}, "heat is not supported with adhesion"),
    ],
)
def test_impossible_scenes_are_refused(change, message):
    grid = sc.Grid(16, 16, 1e-8, 1e-8)
    more = {"heat": change["heat"]} if "heat" in change else {}
    with pytest.raises(ValueError, match=message):
        sc.ContactSolver(
            grid, TIP, SOFT.with_thermal(50.0, 1e-5, 1e-5), change.get("friction", 0.0),
            adhesion=change.get("law", sc.Adhesion.jkr(W)), **more,
        ).solve(
            sc.surfaces.paraboloid(grid, R), approach=0.0
        )  # fmt: skip


def test_coarse_cells_and_a_small_grid_are_told():
    grid = sc.Grid(24, 24, 1e-8, 1e-8)
    gap = sc.surfaces.paraboloid(grid, R)
    coarse = sc.Adhesion.exponential(W, 8.6e-10)
    assert 0.6 < coarse.on(grid, TIP, SOFT).kappa < 1.0
    with pytest.warns(sc.ResolutionWarning, match="does not resolve the adhesion"):
        sc.ContactSolver(grid, TIP, SOFT, adhesion=coarse).solve(gap, approach=0.0)
    long = sc.Adhesion.exponential(W, 5e-9)
    with pytest.warns(sc.GridTooSmallWarning, match="attraction at the edge of the grid"):
        sc.ContactSolver(grid, TIP, SOFT, adhesion=long).solve(gap, approach=0.0)


def test_a_law_states_its_range_and_tabor_number_on_a_grid():
    grid = sc.Grid(9, 7, 2e-9, 3e-9)
    law = sc.Adhesion.exponential(W, 2e-9)
    found = law.on(grid, TIP, SOFT)
    assert found.modulus == pytest.approx(E, rel=1e-12)
    assert found.tabor(R) == pytest.approx(sc.adhesion.tabor(R, W, E, 2e-9), rel=1e-12)
    assert not found.is_refined
    refined = sc.Adhesion.jkr(W).on(grid, TIP, SOFT)
    assert refined.is_refined
    assert refined.kappa == pytest.approx(0.5, rel=1e-12)
    periodic = sc.Grid(16, 16, 2e-9, 2e-9, periodic="xy")
    assert law.on(periodic, TIP, SOFT).modulus == pytest.approx(E, rel=1e-12)
