# SPDX-License-Identifier: GPL-3.0-or-later
"""Retractions in paths: their increments follow from the states, also after a restart."""

import numpy as np
import pytest

import samcontact as sc

pytestmark = pytest.mark.filterwarnings("ignore:the attraction at the edge")
W, RANGE = 0.05, 1.6e-9
TIP, SOFT = sc.Material.rigid(), sc.Material.elastic(1e9, 0.3)
PATH = [{"approach": 1e-9}, {"pull_off": sc.paths.Retraction()}, {"approach": 0.0}]
COARSE_PATH = [PATH[0], {"pull_off": sc.paths.Retraction(1.5e-9)}, PATH[2]]


def tip(body=SOFT, **more):
    grid = sc.Grid(20, 20, 9e-9, 9e-9)
    law = more.pop("adhesion", sc.Adhesion.exponential(W, RANGE))
    return sc.Simulation(
        grid, TIP, body, sc.surfaces.paraboloid(grid, 0.5e-6), adhesion=law, **more
    )


def test_a_path_retracts_as_pull_off_does():
    """The default step is a quarter of the range; the machine gives way."""
    states = tip(stiffness=30.0).run(PATH, progress=False)
    simulation = tip(stiffness=30.0)
    simulation.step(approach=1e-9)
    found = sc.paths.pull_off(simulation, step=0.25 * RANGE)
    assert len(states) == len(found.states) + 1
    for state, other in zip(states, found.states, strict=False):
        np.testing.assert_allclose(state.load, other.load, rtol=1e-6, atol=1e-16)
    assert not states[-2].in_contact.any()
    assert states[-1].in_contact.any()


def test_a_stopped_retraction_goes_on_without_a_change(tmp_path):
    folder = tmp_path / "run"
    whole = tip().run(COARSE_PATH, progress=False, checkpoint=folder)
    files = sorted(folder.glob("*.h5"))
    assert len(files) == len(whole) > 5
    for file in files[3:]:
        file.unlink()
    again = tip().run(COARSE_PATH, progress=False, checkpoint=folder)
    for state, other in zip(again, whole, strict=True):
        np.testing.assert_array_equal(state.pressure, other.pressure)
        assert state.approach == other.approach
    with pytest.raises(ValueError, match="different path"):
        tip().run(PATH, progress=False, checkpoint=folder)


def test_a_retraction_that_does_not_end_keeps_its_states():
    few = [PATH[0], {"pull_off": sc.paths.Retraction(max_steps=4)}]
    with pytest.raises(ValueError, match="max_steps = 4 increments") as stopped:
        tip().run(few, progress=False)
    assert len(stopped.value.states) == 5


def test_errors_of_a_retraction_are_estimated_at_its_increments():
    simulation = tip()
    states = simulation.run(COARSE_PATH, progress=False)
    found = sc.estimate_errors(simulation, COARSE_PATH, states)
    assert len(found.errors["approach"]) == len(states)
    with pytest.raises(ValueError, match="path must begin with increments"):
        sc.estimate_errors(simulation, COARSE_PATH[1:], states)


def test_the_pull_off_force_of_a_viscoelastic_body_increases_with_the_speed():
    """A slow retraction is that of an elastic body with the long-time moduli."""
    rubber = SOFT.with_relaxation([1.0], [0.5])
    forces = {}
    for name, speed in (("fast", 1.0), ("slow", 1e-13), ("medium", 2e-9)):
        simulation = tip(rubber)
        simulation.step(approach=0.0, duration=0.0)
        simulation.step(approach=0.0, duration=1e4)
        forces[name] = sc.paths.pull_off(
            simulation, step=0.4e-9, until="maximum", speed=speed
        ).pull_off
    relaxed = tip(sc.Material.elastic(0.5 * rubber.E, rubber.nu))
    relaxed.step(approach=0.0)
    slow = sc.paths.pull_off(relaxed, step=0.4e-9, until="maximum").pull_off
    assert forces["slow"] == pytest.approx(slow, rel=1e-3)
    assert forces["slow"] < forces["medium"] < forces["fast"]


@pytest.mark.parametrize(
    ("path", "error", "message"),
    [
        ([{"pull_off": 1e-9}], TypeError, "pull_off of increment 1 of path must be a"),
        ([PATH[1] | {"load": 1.0}], ValueError, "pull_off cannot be combined with load"),
        ([PATH[0], {"pull_off": sc.paths.Retraction(speed=1.0)}], ValueError, "speed must be"),
    ],
)
def test_retractions_are_checked(path, error, message):
    with pytest.raises(error, match=message):
        tip().run(path, progress=False)


@pytest.mark.parametrize(
    ("law", "message"),
    [
        (sc.HardContact(), "pull_off requires adhesion"),
        (sc.TensileLimit(1e6), "step of pull_off is required"),
    ],
)
def test_a_retraction_requires_attraction(law, message):
    with pytest.raises(ValueError, match=message):
        tip(adhesion=law).run([{"approach": 1e-9}, PATH[1]], progress=False)
