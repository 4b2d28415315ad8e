# SPDX-License-Identifier: GPL-3.0-or-later
"""Random studies: rolling, wear by slip, shakedown cycles, fatigue, accuracy."""

import math
import warnings

import numpy as np
from balances import assert_finite
from drawn_paths import drawn_case
from drawn_setups import Setup, uniform

import samcontact as sc
from samcontact.cases import Case


def drawn_ball(seed, inelastic=False):
    """Draw a ball on a grid that contains its contact; the bodies may be identical."""
    scene = Setup(seed)
    cells = int(scene.draw.integers(9, 14))
    layers = {"dz": scene.size} if inelastic else {}
    grid = sc.Grid(cells, cells, scene.size, scene.size, **layers)
    gap = sc.surfaces.paraboloid(grid, scene.R)
    scene.heated = scene.layered = False
    case = {"body1": scene.body(False), "body2": scene.body(inelastic)}
    case |= {"title": "t", "grid": {"nx": 1, "ny": 1, "dx": 1.0, "dy": 1.0, "dz": 1.0}}
    case |= {"surface": {"shape": "sphere", "R": 1.0}, "path": [{"load": 1.0}]}
    made = Case.model_validate(case)
    return scene, grid, made.body1.build(), made.body2.build(), gap


def rolls(seed):
    """Check steady rolling with a creepage or a force."""
    scene, grid, body1, body2, gap = drawn_ball(seed)
    draw = scene.draw
    mu = float(draw.choice([0.05, 0.3, 1.0, math.inf]))
    load = scene.load * uniform(draw, 0.2, 0.8)
    creepage = (min(mu, 1.0) * scene.a / scene.R * draw.normal(size=2)).tolist()
    drive = {"creepage": creepage, "spin": 0.3 * creepage[0] / scene.a}
    if math.isfinite(mu) and draw.random() < 0.5:
        drive = {"tangential_load": (mu * load * draw.uniform(-0.6, 0.6, 2)).tolist()}
    friction = sc.Coulomb(mu)
    found = sc.rolling.steady(
        grid, body1, body2, gap, load=load, friction=friction, on_border="warn", **drive
    )
    assert found.converged
    assert_finite(pressure=found.pressure, shear=found.shear, slip=found.slip)
    assert abs(found.pressure.sum() * grid.cell_area - load) <= 1e-9 * load
    assert found.friction_work_per_distance >= -1e-6 * load * np.hypot(*found.creepage)
    if math.isfinite(mu):
        most = mu * found.pressure.max()
        assert (np.hypot(*found.shear) <= mu * found.pressure + 1e-6 * most).all()
    if "tangential_load" in drive:
        wanted = np.array(drive["tangential_load"])
        assert np.abs(found.tangential_load - wanted).max() <= 1e-4 * load


def wears(seed):
    """Check fretting wear: worn volume is friction work times the coefficient of each body."""
    scene, grid, body1, body2, gap = drawn_ball(seed)
    draw = scene.draw
    mu, load = uniform(draw, 0.1, 1.0), scene.load * uniform(draw, 0.2, 0.8)
    pulls = [q * uniform(draw, 0.3, 0.8) * mu * load for q in (0, 1, -1)]
    cycle = [{"load": load, "tangential_load": (q, 0.0)} for q in [*pulls, pulls[1]]]
    energy = 1e-3 * scene.a**2 / scene.R / (mu * load * 0.1 * scene.a**2 / scene.R) * scene.a**2
    found = sc.wear.fretting(
        grid, body1, body2, gap, cycle=cycle, friction=sc.Coulomb(mu), energy=energy, cycles=2,
        repeats=2, progress=False, on_border="warn",
    )  # fmt: skip
    assert len(found.cycles) >= 1
    for done in found.cycles:
        assert done.friction_work >= 0
        lost = energy * done.friction_work
        assert abs(done.volume[-1] - lost) <= 1e-6 * lost
    assert_finite(heights=found.heights[2])


def repeats(seed):
    """Check load cycles: a response is established, or a warning states that there is none."""
    scene, grid, body1, body2, gap = drawn_ball(seed, inelastic=True)
    simulation = sc.Simulation(grid, body1, body2, gap, on_border="warn")
    load = scene.load * uniform(scene.draw, 0.2, 0.8)
    found = sc.shakedown.run(simulation, [{"load": load}, {"load": 0.0}], cycles=4, progress=False)
    assert found.response in (
        "elastic", "elastic shakedown", "plastic shakedown", "ratcheting", "undecided",
    )  # fmt: skip
    assert_finite(**{f"strain {n}": c.net for n, c in enumerate(found.cycles)})


def tires(seed):
    """Check fatigue criteria of a random case: amplitudes are finite and not negative."""
    simulation, path = Case.model_validate(drawn_case(seed)).build()
    if not simulation.grid.has_volume or len(path) < 2:
        return
    states = simulation.run(path[:3], progress=False)
    slope = float(np.random.default_rng(seed).uniform(0, 1))
    found = [
        sc.fatigue.dang_van(states, 2, slope), sc.fatigue.crossland(states, 2, slope),
        sc.fatigue.findley(states, 2, slope), sc.fatigue.orthogonal_shear(states, 2, "x"),
    ]  # fmt: skip
    for field in found:
        assert_finite(**{field.name: np.asarray(field.values)})
    assert found[-1].values.min() >= 0


def asks(seed):
    """Check a run to an accuracy against a run to an accuracy four times as tight."""
    scene = Setup(seed)
    draw = scene.draw
    scene.heated, scene.periodic = False, ""
    body2 = scene.body(scene.yields)
    case = {"body1": {"law": "rigid"} if draw.random() < 0.3 else scene.body(False), "body2": body2}
    case["surface"] = {"shape": "paraboloid", "Rx": scene.R, "Ry": scene.R * uniform(draw, 1, 3)}
    load = scene.load * uniform(draw, 0.2, 0.8)
    if scene.sticks:
        case["contact"] = {"friction": uniform(draw, 0.0, 0.5)}
    case["path"] = [{"load": load}, {"load": 0.0}][: draw.integers(1, 3)]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.AccuracyWarning)
        loose, tight = (
            sc.to_accuracy(case, accuracy, max_memory=5e7, progress=False)
            for accuracy in (0.08, 0.02)
        )
    for found in (loose, tight):
        assert found.reached != bool(found.needs)
        assert_finite(**found.series)
        for name, error in found.errors.items():
            assert error >= 0
            if found.reached:
                most = found.accuracy[name] * abs(found.values[name])
                assert error <= most * (1 + 1e-9), name
    for name, value in loose.values.items():
        allowed = max(loose.errors[name], loose.accuracy[name] * abs(tight.values[name]))
        assert abs(value - tight.values[name]) <= allowed + tight.errors[name], name


STUDIES = {
    "steady rolling": rolls, "wear by slip": wears, "shakedown": repeats, "fatigue": tires,
    "accuracy": asks,
}  # fmt: skip
