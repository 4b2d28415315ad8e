# SPDX-License-Identifier: GPL-3.0-or-later
"""Two spheres that slide past each other: kinematics, forces, energy."""

import itertools
import math
import subprocess
import sys

import numpy as np
import pytest
import xarray as xr

import samcontact as sc
from samcontact.asperities import Collision, collide
from samcontact.asperities.passes import CollisionPasses

STEEL = sc.Material.perfect_plastic(200e9, 0.32, 0.9115e9)
ELASTIC = sc.Material.elastic(200e9, 0.32)
HARD = sc.Material.linear_hardening(210e9, 0.3, 1.2e9, 10e9)
CRITICAL = sc.critical.green(0.5, sc.hertz.effective_modulus(STEEL, STEEL), 0.32, 0.9115e9)


def collision(relative, R1=1.0, R2=1.0):
    return Collision(R1, R2, relative * CRITICAL.interference)


def quick(which, body1, body2, increments=16, **arguments):
    grid = which.grid(increments, width=1.5)
    return collide(which, body1, body2, grid, progress=False, **arguments)


def test_critical_values_of_the_thesis():
    assert CRITICAL.interference == pytest.approx(2.2143e-4, rel=1e-4)
    assert CRITICAL.load == pytest.approx(3.461e5, rel=1e-4)
    assert CRITICAL.energy == pytest.approx(30.654, rel=1e-4)


def test_geometry():
    which = Collision(0.7, 1.9, 0.003)
    touching = which.half_angle
    assert math.cos(touching) == pytest.approx(which.height / 2.6, rel=1e-14)
    assert which.half_distance**2 == pytest.approx(2.6**2 - which.height**2, rel=1e-12)
    assert which.approach(touching) == pytest.approx(0, abs=1e-17)
    assert which.approach(0.0) == 0.003
    for angle in (-0.04, 0.01, 0.06):
        centres = np.array([which.offset(angle), which.height])
        assert np.linalg.norm(centres) == pytest.approx(which.separation(angle), rel=1e-14)
        assert which.approach(angle) == pytest.approx(2.6 - np.linalg.norm(centres), abs=1e-15)


def test_surfaces_advance_with_the_contact_point():
    """Advances agree with the nearest points of the spheres, by plane geometry."""
    which = Collision(0.7, 1.9, 0.003)
    start, end = -0.03, -0.0299
    moved = []
    for angle in (start, end):
        centres = np.array([which.offset(angle), which.height])
        normal = centres / np.linalg.norm(centres)
        moved.append((-0.7 * normal, 1.9 * normal))  # from the centre of 1, of 2: no rotation
    middle = 0.5 * (start + end)
    tangent = np.array([math.cos(middle), -math.sin(middle)])
    over = [(moved[1][n] - moved[0][n]) @ tangent for n in (0, 1)]
    # if the contact moves over a surface in +x, the surface moves through the contact in -x
    np.testing.assert_allclose(which.advance(end - start), [-w for w in over], rtol=1e-8)


def test_elastic_spheres_dissipate_nothing():
    for relative in (1, 15):
        series = quick(collision(relative), ELASTIC, ELASTIC).series
        assert abs(float(series.net_energy[0])) < 1e-6 * CRITICAL.energy
        fx, fz = series.force_x.values[0], series.force_z.values[0]
        np.testing.assert_allclose(fx, -fx[::-1], atol=1e-6 * fx.max())
        np.testing.assert_allclose(fz, fz[::-1], atol=1e-6 * fz.max())
        # Hertz when aligned; resisting force before, driving force after
        hertz = sc.hertz.point(0.5, sc.hertz.effective_modulus(ELASTIC, ELASTIC),
                               approach=relative * CRITICAL.interference)  # fmt: skip
        assert fz.max() == pytest.approx(hertz.load, rel=0.01)
        assert fx[: len(fx) // 2].min() >= 0


@pytest.fixture(scope="module")
def plastic():
    """Solve a coarse and a fine collision at nine times the critical interference."""
    return [quick(collision(9), STEEL, STEEL, n) for n in (16, 22)]


def test_energy_is_dissipated_or_stored(plastic):
    shares = [abs(float(t.series.energy_imbalance[0] / t.series.net_energy[0])) for t in plastic]
    assert shares[0] < 0.05
    assert shares[1] < 0.025
    for t in plastic:
        assert float(t.series.dissipation[0]) > 4 * float(t.series.residual_energy[0]) > 0


def test_plastic_spheres_resist_more_than_they_drive(plastic):
    series = plastic[1].series.isel({"pass": 0})
    half = series.sizes["increment"] // 2
    fx = series.force_x.values
    assert fx[half] > 0.05 * fx.max()  # aligned
    assert fx.max() > 2 * -fx.min()
    assert series.force_z.values[half - 3] > series.force_z.values[half + 3]
    for body in (1, 2):
        depth = float(series.residual_displacement.sel(body=body))
        assert 0.2 < depth / plastic[1].collision.interference < 0.3


def test_asymmetry_grows_with_the_interference():
    shares = []
    for relative in (1, 1.15, 2, 5):
        series = quick(collision(relative), STEEL, STEEL).series.isel({"pass": 0})
        fx, x = series.force_x.values, series.offset.values
        shares.append(np.abs(fx + np.interp(-x, x, fx)).max() / fx.max())
    assert shares[1] < 0.01
    assert np.all(np.diff(shares) > 0)
    assert shares[3] > 0.2


def test_identical_spheres_are_rotated_images_of_each_other(plastic):
    for t in plastic:
        state = t.unloaded[0]
        one, two = (state.track(body) for body in (1, 2))
        a, b = one.residual_displacement(), two.residual_displacement()
        x = np.linspace(-0.05, 0.05, 21)
        middle = a.shape[1] // 2
        np.testing.assert_allclose(
            np.interp(x, one.x, a[:, middle]),
            np.interp(x, -two.x[::-1], b[::-1, middle]),
            atol=1e-3 * a.max(),
        )


@pytest.mark.parametrize(
    ("body1", "body2", "R1", "R2", "increments"),
    [
        (STEEL, HARD, 1.0, 2.0, 32),
        (ELASTIC, STEEL, 2.0, 1.0, 20),
        pytest.param(STEEL, ELASTIC, 1.3, 1.0, 20, marks=pytest.mark.slow),
    ],
)
def test_unequal_spheres(body1, body2, R1, R2, increments):
    """The tangential force follows equally from both surfaces, each with its own curvature."""
    which = collision(6, R1, R2)
    result = quick(which, body1, body2, increments)
    series = result.series
    assert abs(float(series.energy_imbalance[0])) < 0.03 * float(series.net_energy[0])
    grid = result.simulation.grid
    simulation = sc.Simulation(grid, body1, body2, sc.surfaces.paraboloid(grid, which.R))
    step = grid.dx / R2
    simulation.step(load=0.0, advance=which.advance(-8 * step))
    for n in range(-8, 1):
        state = simulation.step(
            approach=which.approach(n * step), advance=which.advance(step if n > -8 else 0.0)
        )
    forces = []
    moment = float((state.pressure * (grid.x - state.origin)[:, None]).sum())
    for body, R, sign in ((1, R1, 1), (2, R2, -1)):
        plastic = body1.is_plastic if body == 1 else body2.is_plastic
        slope = np.gradient(state.residual_displacement(body), grid.dx, axis=0) if plastic else 0.0
        forces.append(sign * (float((state.pressure * slope).sum()) + moment / R) * grid.cell_area)
    assert forces[0] == pytest.approx(forces[1], abs=0.06 * max(map(abs, forces)))
    run = CollisionPasses(which, result.simulation, step, None, None)
    run.state = state
    lever = (R1 * forces[0] + R2 * forces[1]) / (R1 + R2)
    assert run._tangential(which.separation(0.0))[0] == pytest.approx(lever, rel=0.01)


def test_repeated_passes_dissipate_less_energy():
    series = quick(collision(6), HARD, STEEL, 10, passes=3).series
    net = series.net_energy.values
    assert net[0] > 5 * net[1] > 5 * net[2]
    assert series.sizes["pass"] == 3
    np.testing.assert_array_less(0, np.diff(series.residual_displacement.values[:, 1]) + 1e-9)


def test_back_and_forth_mirrors_the_second_pass():
    series = quick(collision(3), ELASTIC, ELASTIC, passes=2, back_and_forth=True).series
    first, second = (series.isel({"pass": n}) for n in (0, 1))
    np.testing.assert_allclose(second.offset, -first.offset)
    np.testing.assert_allclose(second.force_x, -first.force_x, atol=1e-5 * CRITICAL.load)


def relief(grid, height, first=None):
    rows = 3 * grid.nx
    cells = sc.Grid(rows, grid.ny, grid.dx, grid.dy)
    waves = -sc.surfaces.sinusoidal(cells, height, 12 * grid.dx, 12 * grid.dy)
    waves = np.roll(waves, (1, 2), axis=(0, 1))  # no mirror plane
    return sc.Relief(waves, first=-grid.nx if first is None else first)


def test_rough_elastic_spheres_dissipate_nothing_on_a_fine_mesh():
    net = []
    for increments in (16, 32, 64):
        which = collision(3)
        grid = which.grid(increments, width=1.5)
        rough = relief(grid, 0.02 * which.interference * 16 / increments)
        series = collide(which, ELASTIC, ELASTIC, grid, relief2=rough, progress=False).series
        start = series.force_y.values[0]
        assert np.abs(start).max() > 1e-6 * CRITICAL.load  # it pushes aside
        net.append(abs(float(series.net_energy[0])))
    assert net[2] < 0.25 * net[0] < 5e-3 * CRITICAL.energy


def test_rough_spheres_touch_earlier():
    which = collision(3)
    grid = which.grid(16, width=1.5)
    lifted = sc.Relief(
        np.full((4 * grid.nx, grid.ny), 0.3 * which.interference), first=-2 * grid.nx
    )
    lower = collide(which, ELASTIC, ELASTIC, grid, progress=False).series
    higher = collide(which, ELASTIC, ELASTIC, grid, relief1=lifted, progress=False).series
    assert higher.sizes["increment"] > lower.sizes["increment"]
    assert float(higher.normal_force[0, 0]) == 0 == float(higher.normal_force[0, -1])
    assert float(higher.normal_force.max()) > 1.3 * float(lower.normal_force.max())


SCRIPT = """
import os, signal, sys
import samcontact as sc
from samcontact.simulation import journal
from samcontact.asperities import Collision, collide
add = journal.Journal.add
def counted(self):
    add(self)
    if self.count == int(sys.argv[1]):
        os.kill(os.getpid(), signal.SIGKILL)
journal.Journal.add = counted
steel = sc.Material.perfect_plastic(200e9, 0.32, 0.9115e9)
which = Collision(1.0, 1.0, 8e-4)
grid = which.grid(8, width=1.5)
collide(which, steel, steel, grid, passes=2, checkpoint=sys.argv[2], progress=False)
"""


def test_a_resumed_run_is_bit_identical(tmp_path):
    which = Collision(1.0, 1.0, 8e-4)
    grid = which.grid(8, width=1.5)
    plain = collide(which, STEEL, STEEL, grid, passes=2, progress=False)
    for count in (7, 16):
        command = [sys.executable, "-c", SCRIPT, str(count), str(tmp_path / "kept")]
        assert subprocess.run(command, check=False).returncode == -9
    resumed = collide(
        which, STEEL, STEEL, grid, passes=2, progress=False, checkpoint=tmp_path / "kept"
    )
    xr.testing.assert_identical(plain.series, resumed.series)
    with pytest.raises(
        ValueError, match=r"is a checkpoint of another run \(passes 3\.0 instead of 2\.0\)"
    ):
        collide(which, STEEL, STEEL, grid, passes=3, progress=False, checkpoint=tmp_path / "kept")


def test_the_series_has_labels_and_units():
    series = quick(collision(1), ELASTIC, ELASTIC, 8).series
    for name, field in series.data_vars.items():
        assert field.attrs["units"], name
        assert field.attrs["long_name"], name
    assert series.attrs["interference"] == CRITICAL.interference
    assert np.isnan(series.load_ratio.values[0, 0])  # before contact
    assert float(series.work[0, -1]) == float(series.net_energy[0])


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ((1.0, 1.0, 1.5), r"interference must be less than the smaller radius \(1.0 m\), got 1.5"),
        ((1.0, 1e-3, 2e-3), "interference must be less than the smaller radius"),
        ((1.0, 1.0, 0.0), "interference must be"),
        ((-1.0, 1.0, 1e-3), "R1 must be"),
    ],
)
def test_bad_collisions(arguments, text):
    with pytest.raises(ValueError, match=text):
        Collision(*arguments)


@pytest.mark.parametrize("name", ["offset", "separation", "approach", "advance"])
def test_bad_angles(name):
    with pytest.raises(ValueError, match="angle must be a finite number, got nan"):
        getattr(Collision(1.0, 1.0, 1e-3), name)(math.nan)


def test_bad_arguments():
    which = collision(3)
    grid = which.grid(8)
    with pytest.raises(ValueError, match=r"not supported in asperity collisions, got 0\.1"):
        collide(which, STEEL, STEEL, grid, friction=0.1)
    with pytest.raises(ValueError, match="passes must be an integer >= 1"):
        collide(which, STEEL, STEEL, grid, passes=0)
    with pytest.raises(ValueError, match="dx must be <="):
        collide(which, STEEL, STEEL, grid, cells_per_increment=4)
    with pytest.raises(TypeError, match=r"collision must be a samcontact\.Collision"):
        collide(3.0, STEEL, STEEL, grid)
    with pytest.raises(ValueError, match="increments must be an integer >= 4"):
        which.grid(2)


@pytest.mark.parametrize("increments", [8, 11, pytest.param(15, marks=pytest.mark.slow)])
def test_the_number_of_steps_is_independent_of_units(increments):
    """Scaled collisions have the same steps, because steps are counted."""
    scales = (1.0, 100.0, 7.3, 1e-6)
    one, *others = (
        quick(Collision(s, s, s * 5 * CRITICAL.interference), ELASTIC, STEEL, increments).series
        for s in scales
    )
    powers = {"force_x": 2, "normal_force": 2, "work": 3, "max_pressure": 0, "approach": 1}
    for (scale, other), (name, power) in itertools.product(
        zip(scales[1:], others, strict=True), powers.items()
    ):
        expected, found = one[name].values, other[name].values / scale**power
        assert np.abs(found - expected).max() < 1e-11 * np.abs(expected).max(), (scale, name)


def test_the_number_of_increments_is_the_given_one():
    """Elastic spheres separate at the mirrored position of first touch, without force."""
    for increments in (8, 20, 31):
        series = quick(collision(5.0), ELASTIC, ELASTIC, increments).series.isel({"pass": 0})
        whole = 2 * math.ceil(increments / 2)
        assert series.sizes["increment"] == whole + 1
        assert series["normal_force"].values[[0, -1]].tolist() == [0.0, 0.0]
        assert (series["normal_force"].values[1:-1] > 0).all()


def test_equal_spheres_are_mirror_images():
    found = quick(collision(5.0), STEEL, STEEL)
    end = found.unloaded[-1]
    upper, lower = end.track(1, margin=0), end.track(2, margin=0)
    for name in ("equivalent_plastic_strain", "residual_displacement"):
        one, other = getattr(upper, name)(), getattr(lower, name)()[::-1]
        assert one.shape == other.shape
        assert np.abs(one - other).max() < 1e-5 * np.abs(one).max(), name  # 10 tol
