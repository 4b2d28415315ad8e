# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases of elastic contact, sliding, heat and hardening laws, in any system of units."""

import numpy as np

import samcontact as sc

HISTORY = {"tol": 1e-11, "on_border": "warn"}


class Setup:
    """One ball on a flat body, in one system of units."""

    def __init__(self, unit):
        metre, newton, second, kelvin = unit.m, unit.N, unit.s, unit.K
        self.metre, self.second, self.newton = metre, second, newton
        self.pascal = newton / metre**2
        self.speed = metre / second
        E, Pa = 210e9 * self.pascal, self.pascal
        watt = newton * metre / second
        thermal = (50 * watt / (metre * kelvin), 12e-6 / kelvin, 1.4e-5 * metre**2 / second)
        perfect = sc.Material.perfect_plastic(E, 0.3, 1e9 * Pa)
        self.other = sc.Material.elastic(300e9 * Pa, 0.2).with_thermal(*thermal)
        self.laws = {
            "elastic": sc.Material.elastic(E, 0.3),
            "linear": sc.Material.linear_hardening(E, 0.3, 1e9 * Pa, 20e9 * Pa),
            "swift": sc.Material.swift(E, 0.3, 600e6 * Pa, 20.0, 0.121),
            "kinematic": perfect.with_kinematic_hardening([50e9 * Pa, 20e9 * Pa], [100.0, 0.0]),
        }
        self.laws = {name: law.with_thermal(*thermal) for name, law in self.laws.items()}
        self.grid = sc.Grid(21, 19, 40e-6 * metre, 45e-6 * metre, 8, 60e-6 * metre)
        self.gap = sc.surfaces.paraboloid(self.grid, 7.5e-3 * metre, 9e-3 * metre)
        self.load = 300 * newton

    def contact(self, friction=0.0, heat=None):
        solver = sc.ContactSolver(
            self.grid, self.other, self.laws["elastic"], friction, tol=1e-12, heat=heat
        )
        found = solver.solve(self.gap, load=self.load)
        return {
            "pressure": found.pressure / self.pascal,
            "gap": found.gap / self.metre,
            "approach": np.array(found.approach / self.metre),
            "stress": solver.stress(found.pressure, self.grid.z) / self.pascal,
        }

    def heated(self, **more):
        factors = (0.01 * self.speed, 0.02 * self.speed)
        return self.contact(0.1, sc.Heat(factors, **more))

    def plastic(self, law, advance=0.0, **settings):
        simulation = sc.Simulation(
            self.grid, self.other, self.laws[law], self.gap, 0.1, **HISTORY, **settings
        )
        duration = {"duration": 1e-3 * self.second} if "heat" in settings else {}
        moved = (advance * self.metre, -0.5 * advance * self.metre)
        simulation.step(load=self.load, **duration)
        state = simulation.step(load=0.3 * self.load, advance=moved, **duration)
        assert state.max_equivalent_plastic_strain() > 1e-4
        return {
            "pressure": state.pressure / self.pascal,
            "gap": state.gap / self.metre,
            "approach": np.array(state.approach / self.metre),
            "plastic strain": state.plastic_strain(),
            "equivalent plastic strain": state.equivalent_plastic_strain(),
            "stress": state.stress() / self.pascal,
            "print": state.residual_displacement() / self.metre,
        }

    def marched(self):
        factor = (0.01 * self.speed, 0.02 * self.speed)
        history = (1e-4 * self.second, 1e-2 * self.second)
        return self.plastic("linear", heat=sc.Heat(factor, history=history))

    def moving(self):
        dent = sc.dents.spherical(self.grid, 1e-6 * self.metre, 1e-4 * self.metre)
        return self.plastic("linear", advance=100e-6, relief2=dent)


SCENES = {
    "elastic": Setup.contact,
    "friction": lambda scene: scene.contact(0.5),
    "heat, steady and moving": lambda scene: scene.heated(
        velocity=((0.0, 0.0), (0.1 * scene.speed, 0.05 * scene.speed)),
        reference=1.0 * scene.metre,
    ),
    "heat of finite duration": lambda scene: scene.heated(time=1e-3 * scene.second),
    "load and unload, linear hardening": lambda scene: scene.plastic("linear"),
    "load and unload, Swift": lambda scene: scene.plastic("swift"),
    "load and unload, kinematic": lambda scene: scene.plastic("kinematic"),
    "load and unload, fast sweeps": lambda scene: scene.plastic("linear", residual_stress="fast"),
    "load and unload, transient heating": Setup.marched,
    "moving over a dent": Setup.moving,
}
