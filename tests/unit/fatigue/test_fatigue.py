# SPDX-License-Identifier: GPL-3.0-or-later
"""Fatigue criteria: closed forms, independent searches, and invariances."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import samcontact as sc
from samcontact.fatigue import (
    crossland,
    dang_van,
    fatemi_socie,
    findley,
    orthogonal_shear,
    steady_cycle,
)

STEEL = sc.Material.elastic(210e9, 0.3)
PHASES = 2 * np.pi * np.arange(48) / 48


def reversed_stress(**components):
    """Return the reversed stress of one point with these amplitudes."""
    stress = np.zeros((len(PHASES), 6, 1))
    for name, amplitude in components.items():
        number = ("xx", "yy", "zz", "yz", "xz", "xy").index(name)
        stress[:, number, 0] = amplitude * np.sin(PHASES)
    return stress


def random_paths(points, moments=17, seed=3):
    return np.random.default_rng(seed).standard_normal((moments, 6, points))


def tensors(stress):
    """Convert (moments, 6, n) to (moments, n, 3, 3)."""
    xx, yy, zz, yz, xz, xy = np.moveaxis(stress, 1, 0)
    rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def components(tensor):
    parts = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
    return np.stack([tensor[..., i, j] for i, j in parts], axis=1)


def test_bending_and_torsion_have_their_closed_forms():
    """Reversed tension f and shear t have values stated in all sources."""
    bending, torsion = reversed_stress(xx=2.0), reversed_stress(xz=1.5)
    assert dang_van(bending, slope=0.3).max_value == pytest.approx(
        2.0 / 2 + 0.3 * 2.0 / 3, rel=1e-12
    )
    assert dang_van(torsion, slope=0.3).max_value == pytest.approx(1.5, rel=1e-12)
    assert crossland(bending, slope=0.4).max_value == pytest.approx(
        2.0 / np.sqrt(3) + 0.4 * 2.0 / 3, rel=1e-12
    )
    assert crossland(torsion, slope=0.4).max_value == pytest.approx(1.5, rel=1e-12)
    # the largest of sin(2a)/2 + k cos(a)^2, and of cos(2a) + k sin(2a)
    assert findley(bending, k=0.3).max_value == pytest.approx(0.3 + np.hypot(1, 0.3), rel=1e-6)
    assert abs(findley(bending, k=0.3).normal[0]) == pytest.approx(
        np.cos(np.arctan(1 / 0.3) / 2), abs=2e-3
    )
    assert findley(torsion, k=0.3).max_value == pytest.approx(1.5 * np.hypot(1, 0.3), rel=1e-6)
    assert orthogonal_shear(torsion).max_value == 1.5
    assert orthogonal_shear(torsion, axis="y").max_value == 0.0
    strain = fatemi_socie(torsion, k=0.0, yield_stress=1.0, material=STEEL)
    assert strain.max_value == pytest.approx(1.5 * 2 * 1.3 / 210e9, rel=1e-6)
    assert strain.unit == "-"


def test_rotating_shear_has_the_amplitude_of_its_circle():
    """Shear that turns in its plane has the amplitude of its circle, not of its components."""
    stress = reversed_stress(xz=1.0)
    stress[:, 3, 0] = np.cos(PHASES)
    assert findley(stress, k=0.0).max_value == pytest.approx(1.0, rel=1e-6)
    assert crossland(stress, slope=0.0).max_value == pytest.approx(1.0, rel=1e-12)


def test_tresca_uses_the_smallest_ball_around_the_path():
    """The centre is a mean of points at the radius, which proves that no ball is smaller."""
    from scipy.optimize import nnls

    stress = random_paths(40)
    tensor = tensors(stress)
    mean = np.trace(tensor, axis1=2, axis2=3)[..., None, None] * np.eye(3) / 3
    deviator = tensor - mean
    radius = crossland(stress, slope=0.0).values
    message = dang_van(stress, slope=0.25).values
    for n in range(40):
        path = deviator[:, n].reshape(-1, 9)
        # weights of a mean that is as far from its own points as the radius says
        lift = np.column_stack([path, np.ones(len(path))])
        centre = _centre(path)
        away = np.sqrt(((path - centre) ** 2).sum(axis=1) / 2)
        assert away.max() == pytest.approx(radius[n], rel=1e-10)
        at_rim = away > away.max() * (1 - 1e-7)
        _, missing = nnls(lift[at_rim].T, np.append(centre, 1.0))
        assert missing < 1e-6
        principal = np.linalg.eigvalsh(deviator[:, n] - centre.reshape(3, 3))
        tau = (principal[:, 2] - principal[:, 0]) / 2
        expected = (tau + 0.25 * mean[:, n, 0, 0]).max()
        assert message[n] == pytest.approx(expected, rel=1e-7)


def _centre(points):
    """Smallest ball from its dual, by a general solver of quadratic programs."""
    from scipy.optimize import minimize

    gram, squares = points @ points.T, (points**2).sum(axis=1)
    start = np.full(len(points), 1.0 / len(points))
    found = minimize(
        lambda w: w @ gram @ w - squares @ w, start, jac=lambda w: 2 * gram @ w - squares,
        bounds=[(0, 1)] * len(points), method="SLSQP",
        constraints={"type": "eq", "fun": lambda w: w.sum() - 1, "jac": np.ones_like},
        options={"ftol": 1e-15, "maxiter": 500},
    )  # fmt: skip
    held = found.x > 1e-6
    # exact solution: equal distances from a centre in the span of the points
    base, edges = points[held][0], points[held][1:] - points[held][0]
    part = np.linalg.lstsq(edges, (edges**2).sum(axis=1) / 2, rcond=None)[0]
    return base + part


def brute_force(shear, stress, combine, planes):
    """Return the maximum over many evenly spread planes; circles by their extent."""
    n = np.arange(planes) + 0.5
    polar, azimuth = np.arccos(1 - n / planes), np.pi * (1 + 5**0.5) * n
    normal = np.stack([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth),
                       np.cos(polar)])  # fmt: skip
    across = np.stack([-np.sin(azimuth), np.cos(azimuth), 0 * azimuth])
    third = np.cross(normal.T, across.T).T
    traction = np.einsum("tij,jp->tip", shear, normal)
    x, y = ((traction * axis).sum(axis=1) for axis in (across, third))
    most = np.einsum("tij,ip,jp->tp", stress, normal, normal).max(axis=0)
    # below the radius: half the width, above it: half the diagonal
    turns = np.linspace(0, np.pi, 24, endpoint=False)
    widths = [np.ptp(x * np.cos(a) + y * np.sin(a), axis=0) for a in turns]
    likely = combine(np.hypot(np.ptp(x, axis=0), np.ptp(y, axis=0)) / 2, most)
    floor = combine(np.max(widths, axis=0) / 2, most).max()
    best = -np.inf
    for p in np.flatnonzero(likely > floor):
        best = max(best, combine(_circle(np.stack([x[:, p], y[:, p]], axis=1)), most[p]))
    return best


def _circle(points):
    """Radius of the smallest circle, the largest of those that two or three points force."""
    centre = points.mean(axis=0)
    for step in 0.5 ** np.arange(1, 24, 0.25):
        apart = points - centre
        far = np.hypot(*apart.T).argmax()
        centre = centre + step * apart[far]
    return np.hypot(*(points - centre).T).max()


def test_critical_planes_are_those_of_a_brute_search():
    """Agreement to the stated error; both searches approach the maximum from below."""
    stress = random_paths(4, moments=9, seed=8)
    found = findley(stress, k=0.3)
    strain = fatemi_socie(1e8 * stress, k=0.6, yield_stress=4e8, material=STEEL)
    for n in range(4):
        path = tensors(stress)[:, n]
        expected = brute_force(path, path, lambda a, b: a + 0.3 * b, planes=1500)
        assert expected * (1 - 1e-6) < found.values[n] < expected * (1 + 1e-2)
        half = path * 1e8 * 1.3 / 210e9

        def combine(a, b):
            return 2 * a * np.maximum(1 + 0.6 * b / 4e8, 0)

        expected = brute_force(half, 1e8 * path, combine, planes=1500)
        assert expected * (1 - 1e-6) < strain.values[n] < expected * (1 + 1e-2)


def test_criteria_are_independent_of_the_axes():
    """A rotated body has equal values; critical planes agree within the stated error."""
    stress = random_paths(200, seed=5)
    turn = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()
    turned = components(turn @ tensors(stress) @ turn.T)
    for criterion, digits in ((dang_van, 1e-9), (crossland, 1e-12)):
        one, other = (criterion(s, slope=0.3).values for s in (stress, turned))
        np.testing.assert_allclose(one, other, rtol=digits)
    one, other = findley(stress, k=0.3), findley(turned, k=0.3)
    np.testing.assert_allclose(one.values, other.values, rtol=0.01)
    assert np.quantile(np.abs(one.values / other.values - 1), 0.98) < 1e-4
    assert np.median(np.abs(one.values / other.values - 1)) < 1e-6
    same = np.abs(np.einsum("in,ij,jn->n", other.normals, turn, one.normals))
    assert np.median(same) > 1 - 1e-5


def test_a_constant_stress_and_the_order_of_moments():
    stress = random_paths(20)
    pressed = stress.copy()
    pressed[:, :3] -= 5.0
    np.testing.assert_allclose(
        dang_van(pressed, slope=0.3).values, dang_van(stress, slope=0.3).values - 1.5, rtol=1e-12
    )
    np.testing.assert_array_equal(
        findley(np.concatenate([stress, stress[:4]]), k=0.2).values.shape, (20,)
    )
    shuffled = stress[np.random.default_rng(1).permutation(len(stress))]
    for criterion in (dang_van, crossland):
        np.testing.assert_allclose(
            criterion(shuffled, slope=0.3).values, criterion(stress, slope=0.3).values, rtol=1e-12
        )
    np.testing.assert_allclose(
        findley(1e9 * stress, k=0.3).values, 1e9 * findley(stress, k=0.3).values, rtol=1e-9
    )


def test_stress_that_does_not_change_has_no_amplitude():
    still = np.repeat(random_paths(5, moments=1), 6, axis=0)
    np.testing.assert_array_equal(crossland(still, slope=0.0).values, 0.0)
    mean = still[0, :3].mean(axis=0)
    np.testing.assert_allclose(dang_van(still, slope=0.5).values, 0.5 * mean, rtol=1e-12)
    np.testing.assert_array_equal(dang_van(np.zeros((2, 6, 3)), slope=0.3).values, 0.0)


def line_stress(x, z, nu=0.3):
    """Stress under the pressure sqrt(1 - x^2), by complex potentials; (6, x, z)."""
    x, z = np.meshgrid(x, z, indexing="ij")
    root = np.sqrt(x + 1j * z - 1) * np.sqrt(x + 1j * z + 1)
    inner = 1 / (x + 1j * z + root)
    total, difference = 2 * inner.imag, 2 * z * (inner / root).real
    xx, zz = (total - difference) / 2, (total + difference) / 2
    return np.stack([xx, nu * (xx + zz), zz, 0 * x, z * (inner / root).imag, 0 * x])


def test_line_contact():
    """Rolling without friction: limits over p0, lengths in half-widths."""
    x, z = np.arange(-25, 25.01, 0.02), np.arange(0.01, 1.2, 0.01)
    lines = steady_cycle(line_stress(x, z)[:, :, None, :])
    for slope, value, depth in ((0.3, 0.171, 0.62), (0.0, 0.25, 0.49)):
        found = dang_van(lines, slope=slope)
        assert found.max_value == pytest.approx(value, rel=0.005)
        # the maximum is flat
        there = found.values[0, np.abs(z - depth).argmin()]
        assert there == pytest.approx(found.max_value, rel=0.002)
        assert z[found.index[-1]] == pytest.approx(depth, abs=0.05)
    shear = orthogonal_shear(lines)
    assert shear.max_value == pytest.approx(0.25, rel=2e-4)
    assert z[shear.index[-1]] == pytest.approx(0.5, abs=0.011)


def test_point_contact():
    """Orthogonal shear of a Hertz contact and its position, from the closed-form stress."""
    hertz = sc.hertz.point(R=1.0, E_star=1.0, load=4 / 3)
    x, z = np.arange(-4, 4.001, 0.008), np.arange(0.3, 0.4, 0.001)
    X, Y, Z = np.meshgrid(hertz.a * x, [0.0], hertz.a * z, indexing="ij")
    stress = hertz.stress(X, Y, Z, 0.3)
    found = orthogonal_shear(steady_cycle(stress))
    assert found.max_value / hertz.p0 == pytest.approx(0.21389, abs=1e-5)
    depth = found.index[-1]
    assert z[depth] == pytest.approx(0.351, abs=0.002)
    assert abs(x[np.abs(stress[4, :, 0, depth]).argmax()]) == pytest.approx(0.848, abs=0.005)


def lundberg_palmgren(ratio):
    """tau_0 over p0 and its depth over the semi-axis in rolling direction, which is shorter."""
    from scipy.optimize import brentq

    t = brentq(lambda t: (t * t - 1) * (2 * t - 1) - 1 / ratio**2, 1.0, 2.0, xtol=1e-14)
    return np.sqrt(2 * t - 1) / (2 * t * (t + 1)), 1 / ((t + 1) * np.sqrt(2 * t - 1))


def test_elliptic_contact_of_a_simulation():
    """tau_0 of Lundberg and Palmgren (1947) on two grids, the error falling with the cell."""
    value, depth = lundberg_palmgren(5.0)
    assert value == pytest.approx(0.24759, abs=5e-5)
    hertz = sc.hertz.elliptic(1e-2, 1e-2 * 11.81, 115e9, load=400.0)
    value, depth = lundberg_palmgren(hertz.k)
    assert hertz.k == pytest.approx(5.0, rel=0.02)
    errors = []
    for cells in (40, 80):
        dx, dy = 4 * hertz.a_x / cells, 4 * hertz.a_y / cells
        grid = sc.Grid(cells, cells, dx, dy)
        solver = sc.ContactSolver(grid, STEEL, STEEL)
        gap = sc.surfaces.paraboloid(grid, 1e-2, 1e-2 * 11.81)
        pressure = solver.solve(gap, load=400.0).pressure
        z = hertz.a_x * np.linspace(0.4, 0.6, 41)
        found = orthogonal_shear(steady_cycle(solver.stress(pressure, z=z)))
        errors.append(abs(found.max_value / pressure.max() / value - 1))
        assert z[found.index[-1]] / hertz.a_x == pytest.approx(depth, abs=0.02)
    assert errors[1] < 0.004
    assert errors[1] < 0.6 * errors[0]
