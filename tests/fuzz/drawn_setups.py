# SPDX-License-Identifier: GPL-3.0-or-later
"""Random cases drawn from a seed, with all features of case files and consistent sizes."""

import math

import numpy as np

WEAR, ASPERITIES = "wear", "asperities"


def uniform(draw, low, high):
    return float(draw.uniform(low, high))


def power(draw, low, high):
    """Draw a number with a uniform logarithm."""
    return float(10 ** draw.uniform(math.log10(low), math.log10(high)))


def chance(draw, share):
    return bool(draw.random() < share)


class Setup:
    """Sizes on which all sections of a random case are based: radius, contact spot, cells."""

    def __init__(self, seed):
        self.draw = draw = np.random.default_rng(seed)
        self.seed = int(seed)
        self.R = power(draw, 1e-6, 1.0)
        self.a = self.R * power(draw, 5e-4, 5e-2)  # radius of the spot
        self.E = power(draw, 1e9, 1e12)
        self.p0 = 2 * self.E * self.a / (math.pi * self.R)
        self.load = 2 / 3 * math.pi * self.a**2 * self.p0
        self.size = self.a / uniform(draw, 1.5, 4.0)
        self.sticks = chance(draw, 0.4)
        self.heated = chance(draw, 0.3)
        self.yields = chance(draw, 0.6)
        self.periodic = str(draw.choice(["", "", "", "", "x", "y", "xy"]))
        self.heated = self.heated and not self.periodic
        self.layered = not self.heated and chance(draw, 0.25)
        self.expansion = self.conductivity = 1.0
        self.volume = self.yields or chance(draw, 0.5)

    def elastic(self, spread=1.0):
        return {
            "law": "elastic",
            "E": self.E * power(self.draw, 1 / (1 + spread), 1 + spread),
            "nu": float(self.draw.choice([0.0, 0.499, *self.draw.uniform(0.05, 0.45, 4)])),
        }

    def inelastic(self):
        """Draw a body that yields at a fraction of the pressure, or not at all."""
        draw, body = self.draw, self.elastic()
        limit = self.p0 * power(draw, 0.15, 1.5)
        laws = {
            "perfect_plastic": {"yield_stress": limit},
            "linear_hardening": {
                "yield_stress": limit, "tangent_modulus": body["E"] * power(draw, 1e-3, 0.9),
            },
            "swift": {"B": limit / 20**0.12, "C": 20.0, "n": uniform(draw, 0.0, 0.3)},
            "voce": {
                "yield_stress": limit, "saturation_stress": limit * uniform(draw, 1, 3),
                "rate": power(draw, 1, 1000),
            },
            "tabulated": {
                "plastic_strain": [0.0, 1e-4, 2e-3, 0.03],
                "stress": np.cumsum([limit, *(limit * draw.uniform(0, 0.5, 3))]).tolist(),
            },
        }  # fmt: skip
        law = str(draw.choice(list(laws)))
        body |= {"law": law} | laws[law]
        if chance(draw, 0.3):
            terms = int(draw.integers(1, 3))
            body["kinematic"] = {
                "modulus": [body["E"] * power(draw, 1e-3, 0.5) for _ in range(terms)],
                "recovery": [float(draw.choice([0.0, 50.0, 500.0])) for _ in range(terms)],
            }
        if chance(draw, 0.15):
            z = np.cumsum([0.0, *draw.uniform(0.2, 1.5, 2)]) * self.a
            body["yield_profile"] = {"z": z.tolist(), "factor": draw.uniform(0.5, 2, 3).tolist()}
        if chance(draw, 0.15):
            small = (0.15 * limit * draw.uniform(-1, 1, (3, 2))).tolist()
            z = [0.0, 2 * self.a]
            body["residual_stress"] = {"z": z, "sxx": small[0], "syy": small[1], "sxy": small[2]}
        return body

    def body(self, inelastic):
        draw = self.draw
        body = self.inelastic() if inelastic else self.elastic()
        if self.layered and chance(draw, 0.6):
            body["layers"] = [self.layer(inelastic) for _ in range(draw.integers(1, 3))]
        if self.heated:
            body["thermal"] = self.thermal()
            if inelastic and chance(draw, 0.2):
                body["softening"] = {"kind": "johnson_cook", "melting": 1800.0, "m": 1.0}
        return body

    def layer(self, inelastic):
        """Draw layers 1/50 to 50 times as stiff; a whole number of cells thick if they yield."""
        draw = self.draw
        layer = self.elastic()
        if inelastic and chance(draw, 0.5):
            layer = self.elastic() | {"law": "perfect_plastic", "yield_stress": 0.6 * self.p0}
        layer["E"] *= power(draw, 1 / 50, 50)
        return layer | {"thickness": self.size * int(draw.integers(1, 5))}

    def thermal(self):
        """Draw thermal constants for which the heat of a path strains less than the pressure."""
        self.expansion = float(self.draw.choice([1e-6, 1e-5]))
        self.conductivity = power(self.draw, 1, 200)
        return {
            "conductivity": self.conductivity,
            "expansion": self.expansion,
            "diffusivity": power(self.draw, 1e-6, 1e-4),
        }

    def grid(self):
        draw, even = self.draw, 2 if self.periodic else 1
        cells = [even * int(n) for n in draw.integers(6, 13, 2) // even]
        size = self.size
        grid = {"nx": cells[0], "ny": cells[1], "dx": size, "dy": size * uniform(draw, 0.5, 2)}
        if self.volume:
            grid["dz"] = size
            if chance(draw, 0.3):
                grid["nz"] = int(draw.integers(3, 10))
        return grid | ({"periodic": self.periodic} if self.periodic else {})

    def surface(self):
        draw = self.draw
        shape = {"shape": "paraboloid", "Rx": self.R, "Ry": self.R * power(draw, 0.3, 3)}
        kind = draw.integers(5)
        if kind == 0:
            shape = {"shape": "sphere", "R": self.R * 2}
        elif kind == 1 and self.periodic in ("x", "y"):
            across = "x" if self.periodic == "y" else "y"
            shape = {"shape": "paraboloid", f"R{across}": self.R}
            shape = {"Rx": math.inf, "Ry": math.inf} | shape
        high, size = self.a**2 / self.R, self.size
        rough = draw.integers(5)
        if rough == 0:
            shape["roughness"] = {
                "kind": "sinusoidal", "amplitude": high * uniform(draw, 0, 0.3),
                "wavelength_x": size * uniform(draw, 4, 8),
                "wavelength_y": size * uniform(draw, 4, 8),
            }  # fmt: skip
        elif rough == 1:
            shape["roughness"] = {
                "kind": "self_affine", "rms_height": high * uniform(draw, 0, 0.2),
                "hurst": uniform(draw, 0, 1), "seed": int(draw.integers(100)),
            }  # fmt: skip
        return shape

    def relief(self):
        draw, high = self.draw, self.a**2 / self.R
        depth = high * uniform(draw, 0.05, 0.5) * float(draw.choice([-1, 1]))
        x, y = (draw.uniform(-3, 3, 2) * self.size).tolist()
        kind = draw.integers(3)
        if kind == 0:
            return {"kind": "dent", "depth": depth, "radius": 2 * self.size, "x": x, "y": y}
        if kind == 1:
            furrow = {"kind": "furrow", "depth": depth, "half_width": 2 * self.size}
            return furrow | {"along": str(draw.choice(["x", "y"])), "position": x}
        rough = {"kind": "self_affine", "rms_height": 0.1 * abs(depth), "hurst": 0.7}
        return rough | {"seed": int(draw.integers(100))}
