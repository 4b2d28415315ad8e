# SPDX-License-Identifier: GPL-3.0-or-later
"""Path, contact and heat sections of random cases."""

import math

from drawn_setups import Setup, chance, power, uniform


def contact(scene):
    """Return the section [contact]."""
    draw = scene.draw
    found = {"on_border": "warn"} if chance(draw, 0.7) else {}
    if scene.sticks:
        mu = float(draw.choice([0.0, 0.02, 0.2, 0.5, 1.0, 2.0, math.inf]))
        found["friction"] = {"coulomb": mu}
    elif chance(draw, 0.5):
        found["friction"] = uniform(draw, 0, 1)
    if chance(draw, 0.3):
        found["tol"] = power(draw, 1e-9, 1e-4)
    if scene.yields:
        plain = not (scene.periodic or scene.layered)
        if plain and chance(draw, 0.3):
            found["residual_stress"] = "exact"
        elif chance(draw, 0.1):
            found["image_tol"] = power(draw, 1e-5, 1e-2)
        if chance(draw, 0.1):
            found["increment_tol"] = 0.05
    return found


class Driven:
    """Segments of a path, and heat consistent with their motion."""

    def __init__(self, scene: Setup, mu: float):
        self.scene, self.draw, self.mu = scene, scene.draw, min(mu, 1.0)
        self.firm = scene.sticks and mu > 0
        # a source that strains a body as much as its pressure does
        strains = scene.conductivity / (scene.a * scene.expansion * scene.E)
        self.speed = strains * power(self.draw, 0.01, 1)
        self.heat = None
        if scene.heated:
            self.heat = self.kind_of_heat()
        self.timed = self.heat is not None and ("history" in self.heat or "partition" in self.heat)
        self.loads = scene.load * self.draw.uniform(0.2, 1.2, 3)

    def kind_of_heat(self):
        draw, scene = self.draw, self.scene
        if scene.sticks:
            heat = {"partition": uniform(draw, 0, 1)}
        else:
            heat = {"factor": (self.speed * draw.uniform(0, 0.3, 2)).tolist()}
        kind = draw.integers(3)
        moment = scene.a / self.speed
        if kind == 0 and not scene.sticks:
            heat["history"] = [moment * uniform(draw, 0.02, 0.5), moment * uniform(draw, 1, 20)]
        elif kind == 1 or scene.periodic:
            heat["time"] = moment * power(draw, 0.1, 10)
        if chance(draw, 0.3):
            heat["reference"] = 10 * scene.a
        return heat

    def timing(self, way=None):
        """Return the duration of a ramp, if the case depends on time."""
        if not self.timed:
            return {}
        return {"duration": (abs(way) if way else self.scene.a) / self.speed}

    def press(self, load):
        many = int(self.draw.integers(1, 3))
        return {"load": float(load), "increments": many} | self.timing()

    def along(self, load):
        """Return a tangential displacement, a force or a rotation under the current load."""
        draw, scene = self.draw, self.scene
        small = self.mu * scene.a**2 / scene.R
        step = {"load": float(load), "increments": int(draw.integers(1, 3))} | self.timing()
        kind = draw.integers(5)
        if kind == 0:
            step |= dict(zip(("shift_x", "shift_y"), (draw.normal(size=2) * small), strict=True))
        elif kind == 1:
            force = draw.uniform(-0.65, 0.65, 2) * self.mu * load
            step |= dict(zip(("tangential_load_x", "tangential_load_y"), force, strict=True))
        elif kind == 2:
            step["twist"] = float(draw.normal() * small / scene.a)
        elif kind == 3:
            step["fret"] = {"shift_x": float(draw.normal() * small) or small, "cycles": 1}
            step["increments"] = 1
        else:
            step["fret"] = {"tangential_load_x": 0.8 * self.mu * load, "cycles": 1}
            step["increments"] = 1
        return step

    def passing(self, load):
        """Return rolling or sliding with unloaded ends; friction pulls body 2 towards +x."""
        draw, size = self.draw, self.scene.size
        distance = size * uniform(draw, 1, 4)
        over = {"distance": distance, "step": size * float(draw.choice([0.5, 1.0, 1.3]))}
        over["step"] = min(over["step"], distance)
        if self.timed:
            over["speed"] = self.speed
        segment = {"load": float(load), "increments": 1}
        if chance(draw, 0.4):
            slider = int(draw.integers(1, 3))
            if slider == 2 and not self.firm:
                over["distance"] *= -1
            return segment | {"slide": over | {"slider": slider}}
        if self.firm:
            over["slide_to_roll"] = uniform(draw, -0.02, 0.02)
            over["lateral_creepage"] = float(draw.choice([0.0, 1e-3]))
            over["spin"] = float(draw.choice([0.0, 0.01])) / self.scene.a
        elif chance(draw, 0.5):
            over["slide_to_roll"] = -uniform(draw, 0, 2)
        return segment | {"roll": over}

    def still(self):
        """Return whether heat excludes motion, so that no segment may move."""
        return self.heat is not None

    def segments(self):
        draw = self.draw
        if not self.still() and chance(draw, 0.35) and "x" not in self.scene.periodic:
            return [self.passing(self.loads[0])]
        path = [self.press(self.loads[0])]
        if self.firm:
            path += [self.along(self.loads[0])]
            if chance(draw, 0.3) and "fret" not in path[-1]:
                path += [{"load": float(self.loads[0]), "increments": 1,
                          "tangential_load_x": 0.0, "tangential_load_y": 0.0} | self.timing(),
                         {"load": float(self.loads[0]), "increments": 1,
                          "fret": {"tangential_load_y": 0.5 * self.mu * self.loads[0]}}
                         | self.timing()]  # fmt: skip
        elif chance(draw, 0.4):
            path += [self.press(self.loads[1])]
        if chance(draw, 0.5):
            path += [{"load": 0.0, "increments": 1} | self.timing()]
        return path


def drawn_case(seed):
    """Return a random case file, as a dictionary, that solves one contact."""
    scene = Setup(seed)
    draw = scene.draw
    case = {"title": f"drawn {seed}", "estimate_error": chance(draw, 0.1)}
    bodies = [scene.body(False), scene.body(scene.yields)]
    if scene.yields and chance(draw, 0.3):
        bodies[0] = scene.body(True)
    elif chance(draw, 0.2) and not scene.heated:
        bodies[0] = {"law": "rigid"}
    case |= {"body1": bodies[0], "body2": bodies[1], "contact": contact(scene)}
    friction = case["contact"].get("friction", 0.0)
    driven = Driven(scene, friction["coulomb"] if isinstance(friction, dict) else friction)
    case |= {"grid": scene.grid(), "surface": scene.surface(), "path": driven.segments()}
    if driven.heat is not None:
        case["heat"] = driven.heat
    for body in (1, 2):
        if chance(draw, 0.15):
            case[f"relief{body}"] = scene.relief()
    return case
