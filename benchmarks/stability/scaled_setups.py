# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of partial slip, layers, periodicity and fatigue, in any system of units."""

import itertools

import numpy as np

import samcontact as sc

# Values of one metre, newton, second and kelvin in another system of units.
UNITS = {
    "millimetre, newton, megapascal": (1e3, 1.0, 1.0, 1.0),
    "micrometre, millinewton, millisecond": (1e6, 1e3, 1e3, 1.0),
    "contact radius, load, time and temperature of the case": (1 / 2.7e-4, 1 / 300, 1e4, 1 / 80),
    "kilometre, meganewton, hour": (1e-3, 1e-6, 1 / 3600, 1.0),
    "angstrom, nanonewton, nanosecond, millikelvin": (1e10, 1e9, 1e9, 1e3),
    "a million metres, meganewtons, seconds and kelvins": (1e-6, 1e-6, 1e-6, 1e-6),
}
POWERS_OF_TWO = (2.0**10, 2.0**-3, 2.0**20, 2.0**-5)
TIGHT_SETTINGS = {"tol": 1e-11, "on_border": "warn"}


class Units:
    """System of units, defined by its values of one metre, newton, second and kelvin."""

    def __init__(self, metre=1.0, newton=1.0, second=1.0, kelvin=1.0):
        self.m, self.N, self.s, self.K = metre, newton, second, kelvin
        self.Pa, self.J = newton / metre**2, newton * metre

    def grid(self, cells=12, **more):
        size = 45e-6 * self.m
        return sc.Grid(cells, cells, size, size, **more)

    def ball(self, grid):
        return sc.surfaces.paraboloid(grid, 7.5e-3 * self.m, 9e-3 * self.m)

    def elastic(self, E=210e9, nu=0.3):
        return sc.Material.elastic(E * self.Pa, nu)

    def soft(self, E=210e9):
        return sc.Material.linear_hardening(E * self.Pa, 0.3, 1e9 * self.Pa, 20e9 * self.Pa)

    def stated(self, state, bodies=(2,)):
        """Return fields of a state by name, converted to SI units."""
        found = {"pressure": state.pressure / self.Pa, "shear": state.shear / self.Pa}
        found |= {"gap": state.gap / self.m, "approach": state.approach / self.m}
        for body in bodies:
            found |= {f"stress {body}": state.stress(body) / self.Pa}
            found |= {f"strain {body}": state.plastic_strain(body)}
            found |= {f"print {body}": state.residual_displacement(body) / self.m}
        return found

    def slipped(self, state):
        """Return the results of partial slip in a state by name, converted to SI units."""
        return {
            "slip": state.slip / self.m,
            "shift": state.shift / self.m,
            "force": state.tangential_load / self.N,
            "torque": state.torque / self.J,
            "work": state.friction_work / self.J,
        }


def fretting(unit, body1, body2, *, heat=None, mu=0.3):
    """Solve a contact under normal load, tangential load, rotation and partial unloading."""
    grid = unit.grid(dz=45e-6 * unit.m)
    gap = unit.ball(grid)
    friction = sc.Coulomb(mu)
    sim = sc.Simulation(grid, body1, body2, gap, friction, heat=heat, **TIGHT_SETTINGS)
    load, more = 300 * unit.N, {"duration": 1e-3 * unit.s} if heat else {}
    sim.step(load=load, **more)
    pull = min(mu, 1.0) * load
    sim.step(load=load, tangential_load=(0.2 * pull, 0.5 * pull), **more)
    state = sim.step(load=0.8 * load, shift=(2e-7 * unit.m, 0.0), twist=1e-3, **more)
    return unit.stated(state) | unit.slipped(state), state


def plastic_fretting(unit):
    return fretting(unit, unit.elastic(300e9, 0.2), unit.soft())[0]


def without_slip(unit):
    elastic = unit.elastic()
    return fretting(unit, elastic, elastic, mu=np.inf)[0]


def heat_of_slip(unit):
    watt = unit.J / unit.s
    thermal = (50 * watt / (unit.m * unit.K), 12e-6 / unit.K, 1.4e-5 * unit.m**2 / unit.s)
    warm, heat = (
        unit.elastic().with_thermal(*thermal),
        sc.Heat(partition=0.4, reference=1e-2 * unit.m),
    )
    found, state = fretting(unit, warm, warm, heat=heat)
    return found | {"temperature": state.temperature() / unit.K}


def coated(unit):
    """Solve a contact with partial slip on a stiff coating."""
    body = sc.Layered([(unit.elastic(400e9, 0.25), 90e-6 * unit.m)], unit.elastic())
    return fretting(unit, unit.elastic(300e9, 0.2), body)[0]


def pressed(unit, body, load, **step):
    grid = unit.grid(dz=45e-6 * unit.m)
    sim = sc.Simulation(grid, sc.Material.rigid(), body, unit.ball(grid), 0.2, **TIGHT_SETTINGS)
    sim.step(load=load * unit.N)
    state = sim.step(load=0.0, **step)
    assert state.max_equivalent_plastic_strain() > 1e-4
    return unit.stated(state)


def coated_steel(unit):
    """Solve a contact on a coating with growth stress, on elastic-plastic steel."""
    grown = unit.elastic(400e9, 0.25).with_residual_stress([0.0], [-1e9 * unit.Pa])
    return pressed(unit, sc.Layered([(grown, 90e-6 * unit.m)], unit.soft()), 400)


def graded(unit):
    """Solve a contact on a body whose yield stress and residual stress vary with depth."""
    m, Pa = unit.m, unit.Pa
    z = [0.0, 100e-6 * m, 300e-6 * m]
    steel = sc.Material.tabulated(
        210e9 * Pa, 0.3, [0.0, 1e-3, 1e-2], [0.9e9 * Pa, 1.1e9 * Pa, 1.3e9 * Pa]
    )
    steel = steel.with_yield_profile(z, [1.5, 1.2, 1.0])
    steel = steel.with_residual_stress(z, [-3e8 * Pa, -1e8 * Pa, 0.0])
    return pressed(unit, steel, 400, advance=(90e-6 * m, 90e-6 * m))


def rolling(unit):
    """Solve a few increments of rolling with creepage, and steady rolling."""
    grid, steel = unit.grid(), unit.elastic()
    gap, load, distance = unit.ball(grid), 60 * unit.N, 45e-6 * unit.m
    sim = sc.Simulation(grid, steel, steel, gap, sc.Coulomb(0.3), **TIGHT_SETTINGS)
    sim.step(load=load)
    state = sim.step(load=load, advance=(-1.001 * distance, -distance), twist=2 * distance / unit.m)
    steady = sc.rolling.steady(
        grid, steel, unit.elastic(150e9, 0.2), gap, load=load, friction=sc.Coulomb(0.3),
        creepage=(1e-3, 5e-4), spin=3 / unit.m, tol=1e-11,
    )  # fmt: skip
    steadily = {
        "steady shear": steady.shear / unit.Pa,
        "work": steady.friction_work_per_distance / unit.N,
    }
    return unit.stated(state, ()) | unit.slipped(state) | steadily


def periodic(unit):
    """Solve elastic-plastic contact of a periodic rough surface."""
    grid = unit.grid(dz=45e-6 * unit.m, periodic="xy")
    rough = sc.surfaces.rough_self_affine(grid, 0.5e-6 * unit.m, 0.8, seed=3)
    sim = sc.Simulation(grid, unit.elastic(), unit.soft(), rough, **TIGHT_SETTINGS)
    sim.step(load=300 * unit.N)
    state = sim.step(load=10 * unit.N)
    assert state.max_equivalent_plastic_strain() > 1e-4
    return unit.stated(state)


def zones(unit):
    """Solve asperities with small plastic zones; their boxes must be equal in all units."""
    size = 1e-6 * unit.m
    grid = sc.Grid(64, 64, size, size, 8, size)
    x, y, away = grid.x[:, None], grid.y, 16 * size
    corners = itertools.product((-away, away), repeat=2)
    gap = np.minimum.reduce(
        [np.hypot(x - a, y - b) ** 2 / (60 * size) + n * 1e-2 * size
         for n, (a, b) in enumerate(corners)]
    )  # fmt: skip
    sim = sc.Simulation(grid, sc.Material.rigid(), unit.soft(), gap, **TIGHT_SETTINGS)
    sim.step(load=0.1 * unit.N)
    state = sim.step(load=0.03 * unit.N)
    assert len(state.zones(2)) > 1
    return unit.stated(state)


def periodic_zones(unit):
    """Solve a periodic rough surface whose contact spots yield in separate subdomains."""
    size = 1e-6 * unit.m
    grid = sc.Grid(64, 64, size, size, 5, size, periodic="xy")
    rough = sc.surfaces.rough_self_affine(
        grid, 0.1 * size, 0.8, wavelength_min=8 * size, roll_off=16 * size, seed=7
    )
    sim = sc.Simulation(
        grid, sc.Material.rigid(), unit.soft(), rough - rough.min(), zones="auto", **TIGHT_SETTINGS
    )
    sim.step(load=0.1 * unit.N)
    state = sim.step(load=0.03 * unit.N)
    assert len(state.zones(2)) > 1
    return unit.stated(state)


def yielding_layers(unit):
    """Solve a contact on an elastic-plastic coating on an elastic-plastic substrate."""
    hard = sc.Material.linear_hardening(400e9 * unit.Pa, 0.25, 1.5e9 * unit.Pa, 20e9 * unit.Pa)
    return pressed(unit, sc.Layered([(hard, 90e-6 * unit.m)], unit.soft()), 400)


def to_accuracy(unit):
    """Run a case to a prescribed accuracy, with automatic grids and increments."""
    E, m = 210e9 * unit.Pa, unit.m
    soft = {"law": "linear_hardening", "E": E, "nu": 0.3, "yield_stress": 1e9 * unit.Pa}
    found = sc.to_accuracy(
        {
            "body1": {"law": "elastic", "E": E, "nu": 0.3},
            "body2": soft | {"tangent_modulus": 20e9 * unit.Pa},
            "surface": {"shape": "paraboloid", "Rx": 7.5e-3 * m, "Ry": 9e-3 * m},
            "path": [{"load": 300.0 * unit.N}, {"load": 0.0}],
        },
        0.2, quantities=["max_pressure", "imprint_depth_body2"], progress=False,
    )  # fmt: skip
    scale = {"max_pressure": unit.Pa, "imprint_depth_body2": m}
    # An error is a difference of two values and has the absolute precision of these values.
    return {"grid": np.array([n[:3] for n in found.runs])} | {
        name: np.array([found.values[name], found.errors[name]]) / by for name, by in scale.items()
    }


def cycles(unit):
    """Repeat load cycles to shakedown, and evaluate fatigue criteria in the last cycle."""
    grid = unit.grid(cells=10, dz=45e-6 * unit.m)
    soft = sc.Material.perfect_plastic(210e9 * unit.Pa, 0.3, 1e9 * unit.Pa)
    soft = soft.with_kinematic_hardening(20e9 * unit.Pa)
    sim = sc.Simulation(grid, unit.elastic(), soft, unit.ball(grid), **TIGHT_SETTINGS)
    load = 300 * unit.N
    found = sc.shakedown.run(sim, [{"load": load}, {"load": 0.0}], cycles=3, progress=False)
    states = [sim.state, sim.step(load=load)]
    return unit.stated(sim.state) | {
        "flow": found.cycles[0].flow,
        "Dang Van": sc.fatigue.dang_van(states, 2, 0.3).values / unit.Pa,
        "Findley": sc.fatigue.findley(states, 2, 0.3).values / unit.Pa,
        "Fatemi-Socie": sc.fatigue.fatemi_socie(states, 2, 0.5).values,
    }


def worn(unit):
    """Simulate fretting wear."""
    grid, steel, load = unit.grid(), unit.elastic(), 200 * unit.N
    pulls = [{"load": load, "tangential_load": (q * load, 0.0)} for q in (0.0, 0.2, -0.2, 0.2)]
    found = sc.wear.fretting(
        grid, steel, steel, unit.ball(grid), cycle=pulls, friction=sc.Coulomb(0.4),
        archard=1e-13 / unit.Pa, cycles=2, repeats=100, progress=False, tol=1e-11,
    )  # fmt: skip
    return {"heights": found.heights[2] / unit.m, "work": found.cycles[-1].friction_work / unit.J}


CASES = {
    "plastic fretting": plastic_fretting, "infinite friction": without_slip,
    "heat due to slip": heat_of_slip,
    "coated": coated, "coated steel": coated_steel, "yield-stress profile": graded,
    "rolling": rolling,
    "periodic": periodic, "subdomains": zones, "periodic subdomains": periodic_zones,
    "elastic-plastic layers": yielding_layers, "cycles and fatigue": cycles, "wear by slip": worn,
    "to an accuracy": to_accuracy,
}  # fmt: skip
