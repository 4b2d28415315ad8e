# SPDX-License-Identifier: GPL-3.0-or-later
"""Section [dents]: the pass of the Python interface, dents ahead of the grid, errors, refusals."""

import copy

import numpy as np
import pytest

import samcontact as sc
from samcontact.cases import Case, CaseError
from samcontact.overrolling import Particle, indent, particles, roll_over
from samcontact.simulation.journal import describe

pytestmark = [
    pytest.mark.filterwarnings("ignore::samcontact.IncrementWarning"),
    pytest.mark.filterwarnings("ignore::samcontact.ResolutionWarning"),
]

CELL = 6e-6
PARTICLE = {"radius": 200e-6, "approach": 2.5e-6}
STEEL = {"law": "swift", "E": 210e9, "nu": 0.3, "B": 945e6, "C": 20.0, "n": 0.121}
BALL = {"law": "elastic", "E": 210e9, "nu": 0.3}
CASE = {
    "title": "t",
    "grid": {"nx": 25, "ny": 21, "dx": CELL, "dy": CELL, "dz": CELL},
    "body1": BALL,
    "body2": STEEL,
    "surface": {"shape": "paraboloid", "Rx": 4e-3},
    "dents": {"increments": 4, "particles": [PARTICLE | {"x": 12 * CELL}]},
    "path": [{"load": 4.0, "increments": 2, "roll": {"distance": 24 * CELL, "step": 3 * CELL}}],
}


def changed(**sections):
    return copy.deepcopy(CASE) | sections


def test_a_case_is_the_pass_of_the_python_interface():
    """The dent lies half the distance ahead of the contact, in the middle of the path."""
    case = Case.model_validate(CASE)
    simulation, path = case.build()
    states = simulation.run(path, progress=False)
    grid = sc.Grid(25, 21, CELL, CELL, dz=CELL)
    steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
    settings = {"tol": 1e-6, "max_iterations": 60}  # those of [contact]
    dented = indent(grid, steel, [Particle(**PARTICLE)], increments=4, **settings)
    rolled = roll_over(
        grid, sc.Material.elastic(210e9, 0.3), steel, dented,
        lambda grid: sc.surfaces.paraboloid(grid, 4e-3),
        load=4.0, distance=24 * CELL, step=3 * CELL, increments=2, **settings,
    )  # fmt: skip
    loaded = [state.pressure.max() for state in states]
    np.testing.assert_allclose(loaded, rolled.max_pressure, rtol=1e-5)
    assert max(loaded) > 1.1 * loaded[1]
    travelled = [-state.travel[1] for state in states]
    np.testing.assert_allclose(travelled, rolled.position + 12 * CELL, atol=1e-12)


def test_particles_far_apart_leave_equal_dents():
    far = [PARTICLE | {"x": place} for place in (0.3 * CELL, 60.3 * CELL)]
    simulation, _ = Case.model_validate(changed(dents={"increments": 2, "particles": far})).build()
    track = simulation.step(load=0.0).track(2)
    depth = track.residual_displacement().max(axis=1)
    first, second = (depth[np.abs(track.x - one["x"]) < 5 * CELL].max() for one in far)
    assert first > 0.3e-6
    assert second == pytest.approx(first, rel=0.02)
    assert abs(track.x[np.argmax(depth)] - far[int(first < second)]["x"]) < CELL


def test_random_particles_are_those_of_the_seed():
    drawn = {
        "length": 4e-4, "width": 4e-5, "density": 2e8, "radius": 1e-4, "spread": 0.1,
        "depth_ratio": 0.02, "seed": 5,
    }  # fmt: skip
    case = Case.model_validate(changed(dents={"random": drawn | {"x": 3e-4, "y": 1e-6}}))
    pressed = case.dents.build({}).particles
    expected = particles(**drawn)
    assert len(pressed) == len(expected) > 1
    for one, other in zip(pressed, expected, strict=True):
        assert one == Particle(
            other.radius, approach=other.approach, x=other.x + 3e-4, y=other.y + 1e-6
        )


def test_estimated_errors_include_the_dent():
    """On the coarser grid the particles are pressed in again; without them there is no imprint."""
    path = [{"load": 0.5, "increments": 1}, {"load": 0.0, "increments": 1}]
    found = sc.estimate_errors(Case.model_validate(changed(path=path)))
    share = found.errors["imprint_depth_body2"][-1] / found.values["imprint_depth_body2"][-1]
    assert 1e-3 < share < 0.4
    first = found.states[0]
    assert first.max_equivalent_plastic_strain(2) > 1e-3


def test_checkpoints_of_other_dents_are_refused():
    other = changed(dents={"increments": 4, "particles": [PARTICLE | {"x": 11 * CELL}]})
    runs = []
    for content in (CASE, CASE, other):
        simulation, path = Case.model_validate(content).build()
        runs.append(describe(simulation.engine, path=path))
    assert runs[0] == runs[1]
    assert {n for n in runs[0] if runs[0][n] != runs[2][n]} == {"preparation"}


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"body2": BALL}, r"dents requires an elastic-plastic body2.*relief2"),
        ({"dents": {}}, r"dents: exactly one of particles and random"),
        ({"dents": {"particles": []}}, r"dents\.particles: must contain at least one table"),
        ({"dents": {"particles": [{"radius": 1e-4}]}}, r"dents\.particles\[0\].*load.*approach"),
        ({"dents": {"particles": [{"radius": 1e-6, "approach": 2e-6}]}}, r"approach must be < rad"),
        ({"dents": {"particles": [PARTICLE], "E": 3e11}}, r"give both E and nu of the particles"),
        ({"dents": {"random": {"length": 1e-6, "width": 1e-6, "density": 1.0, "radius": 1e-4,
                               "seed": 1}}}, r"dents\.random: no particle was drawn"),
        ({"wear": {"threshold": 2e-3}, "path": [{"load": 1.0}, {"load": 0.0}]},
         r"dents cannot be combined with \[wear\]"),
        ({"grid": CASE["grid"] | {"nx": 24, "periodic": "x"}},
         r"dents cannot be combined with grid\.periodic"),
    ],
)  # fmt: skip
def test_refused(change, message):
    with pytest.raises(CaseError, match=message):
        Case.model_validate(changed(**change))


def test_a_particle_beyond_the_sides_of_the_grid_is_refused():
    case = Case.model_validate(changed(dents={"particles": [PARTICLE | {"y": 30 * CELL}]}))
    with pytest.raises(
        ValueError, match=r"dents: the centre of each particle must lie on the grid along y"
    ):
        case.build()


def test_first_yield_of_a_dented_body_is_not_sought():
    with pytest.raises(ValueError, match="does not support dents"):
        sc.find_load(Case.model_validate(CASE), "yield", 1.0, progress=False)
