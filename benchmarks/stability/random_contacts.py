# SPDX-License-Identifier: GPL-3.0-or-later
"""Random contacts of dissimilar bodies with friction, and an independent check of their solutions.

`python -m benchmarks.stability.random_contacts LAW FIRST LAST [check]` solves the contacts number
FIRST to LAST - 1 with one friction law ("none": no slip, "coulomb", "tresca"), prints a line for
each and a summary. With `check`, the largest residual of the conditions of contact and friction is
computed with a dense matrix.
"""

from __future__ import annotations

import hashlib
import math
import sys
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import samcontact as sc

Array = NDArray[np.float64]

RADIUS, CELL = 5e-3, 20e-6
BODIES = {
    "rigid": sc.Material.rigid(),
    "steel": sc.Material.elastic(210e9, 0.3),
    "aluminium": sc.Material.elastic(70e9, 0.33),
    "polymer": sc.Material.elastic(3e9, 0.4),
    "nu 0.05": sc.Material.elastic(20e9, 0.05),
}
DRIVES = ("press", "pull", "shift", "load", "approach", "roll", "twist", "torque", "unload", "turn")


def rough(random: np.random.Generator, shape: tuple[int, int], rms: float) -> Array:
    """Return the heights of a self-affine surface of Hurst exponent 0.8 [m]."""
    n = 2 * max(shape)
    k = np.hypot(*np.meshgrid(np.fft.fftfreq(n), np.fft.fftfreq(n), indexing="ij"))
    k[0, 0] = np.inf
    waves = k**-1.8 * np.exp(2j * np.pi * random.random((n, n)))
    height: Array = np.fft.ifft2(waves).real[: shape[0], : shape[1]]
    return height * (rms / height.std())


@dataclass(frozen=True)
class RandomContact:
    """Two bodies, their gap, and the arguments of each increment."""

    name: str
    grid: sc.Grid
    bodies: tuple[sc.Material, sc.Material]
    gap: Array
    friction: Any
    steps: list[dict[str, Any]]

    def simulation(self, **settings: Any) -> sc.Simulation:
        """Return a simulation before the first increment."""
        return sc.Simulation(
            self.grid, *self.bodies, self.gap, self.friction, on_border="warn", **settings
        )


def random_law(law: str, random: np.random.Generator, pressure: float) -> tuple[Any, float]:
    """Return a friction law, and a ratio of tangential force to load below the limit, <= 1."""
    if law == "none":
        return sc.Coulomb(math.inf), 1.0
    mu = float(10 ** random.uniform(-1, math.log10(2)))
    if law == "coulomb":
        return sc.Coulomb(mu), min(mu, 1.0)
    return sc.Tresca(mu * pressure), 0.15 * min(mu, 1.0)


def random_contact(law: str, number: int) -> RandomContact:
    """Return the random contact of this number, on a grid of 9 to 25 cells along each side."""
    random = np.random.default_rng([number, *law.encode()])
    first, second = random.permutation(len(BODIES))[:2]
    names = [list(BODIES)[first], list(BODIES)[second]]
    bodies = BODIES[names[0]], BODIES[names[1]]
    shape = (int(random.integers(9, 26)), int(random.integers(9, 26)))
    grid = sc.Grid(*shape, CELL, CELL)
    modulus = sc.hertz.effective_modulus(*bodies)
    a = 0.3 * min(shape) * CELL
    load = 4 / 3 * modulus * a**3 / RADIUS
    depth = a * a / RADIUS
    gap = sc.surfaces.paraboloid(grid, RADIUS)
    surface = str(random.choice(["smooth", "white", "self-affine"], p=[0.4, 0.3, 0.3]))
    if surface == "white":
        gap = gap + random.uniform(0.01, 0.1) * depth * random.standard_normal(shape)
    if surface == "self-affine":
        gap = gap + rough(random, shape, 0.03 * depth)
    friction, ratio = random_law(law, random, load / (math.pi * a * a))
    drive = str(random.choice(DRIVES))
    steps = steps_of(drive, load, a, depth, ratio)
    name = f"{drive} {surface} {names[0]}/{names[1]} {shape[0]}x{shape[1]}"
    return RandomContact(name, grid, bodies, gap, friction, steps)


def steps_of(drive: str, load: float, a: float, depth: float, ratio: float) -> list[dict[str, Any]]:
    """Return the increments of a drive; ratio: tangential force / load [-]; depth: a^2/R [m]."""
    force = ratio * load
    press = {"load": load}
    pull = {"load": load, "tangential_load": (0.4 * force, 0.1 * force)}
    slide = 0.3 * ratio * depth
    roll = {"load": load, "advance": (-CELL, -CELL * (1 + 1e-3))}
    return {
        "press": [press],
        "pull": [press, pull],
        "shift": [press, {"load": load, "shift": (slide, 0.0)}],
        "load": [press, {"load": 2 * load}, {"load": 0.5 * load}],
        "approach": [
            {"approach": 0.8 * depth},
            {"approach": 1.2 * depth, "shift": (slide, 0.4 * slide)},
            {"approach": 0.6 * depth, "shift": (-slide, 0.0)},
        ],
        "roll": [press, *4 * [roll]],
        "twist": [press, {"load": load, "twist": 1e-3}],
        "torque": [press, {"load": load, "torque": 0.15 * force * a}],
        "unload": [press, pull, {"load": 0.5 * load}],
        "turn": [press, pull, {"load": load, "tangential_load": (-0.2 * force, 0.3 * force)}],
    }[drive]


@dataclass(frozen=True)
class Outcome:
    """States of the solved increments, the error that ended them, and counters of the work."""

    states: list[sc.State]
    error: str
    counters: dict[str, Any]

    def digest(self) -> str:
        """Return a hash of all tractions."""
        digest = hashlib.sha256()
        for state in self.states:
            digest.update(np.ascontiguousarray(state.pressure).tobytes())
            digest.update(np.ascontiguousarray(state.shear).tobytes())
        return digest.hexdigest()[:12]


def solve(contact: RandomContact, **settings: Any) -> Outcome:
    """Solve the increments of a contact until one fails; return the outcome."""
    simulation, states, error = contact.simulation(**settings), [], ""
    try:
        for step in contact.steps:
            states.append(simulation.step(**step))
    except sc.ConvergenceError as failure:
        error = str(failure)
    return Outcome(states, error, dict(simulation.counters))


def dense_matrix(contact: RandomContact) -> Array:
    """Return the displacement (u_z, u_x, u_y) due to (p, s_x, s_y) [m/Pa] (Love, Cerruti)."""
    softness = [0.0 if body.is_rigid else 2 * (1 + body.nu) / body.E for body in contact.bodies]
    ratios = [0.0 if body.is_rigid else body.nu for body in contact.bodies]
    total = sum(softness)
    crossed = sum(soft * nu for soft, nu in zip(softness, ratios, strict=True))
    beta = 0.5 * (softness[1] * (1 - 2 * ratios[1]) - softness[0] * (1 - 2 * ratios[0]))
    x, y = (c.ravel() for c in np.meshgrid(contact.grid.x, contact.grid.y, indexing="ij"))
    dx, dy = x[:, None] - x, y[:, None] - y

    def corners(function: Callable[[Array, Array], Array]) -> Array:
        ends = [(s, t) for s in (-0.5, 0.5) for t in (-0.5, 0.5)]
        terms = [4 * s * t * function(dx + s * CELL, dy + t * CELL) for s, t in ends]
        return np.asarray(sum(terms)) / (2 * np.pi)

    along_x = corners(lambda x, y: x * np.arcsinh(y / abs(x)))
    along_y = corners(lambda x, y: y * np.arcsinh(x / abs(y)))
    across = -crossed * corners(np.hypot)

    def lifted(x: Array, y: Array) -> Array:
        return y / 2 * np.log(x * x + y * y) + x * np.arctan(y / x)

    zx, zy = beta * corners(lifted), beta * corners(lambda x, y: lifted(y, x))
    zz = (total - crossed) * (along_x + along_y)
    xx = (total - crossed) * along_x + total * along_y
    yy = total * along_x + (total - crossed) * along_y
    return np.block([[zz, zx, zy], [-zx, xx, across], [-zy, across, yy]])


def residuals(contact: RandomContact, states: list[sc.State]) -> list[float]:
    """Return the largest residual of contact and friction in each increment.

    The residual is relative to the maximum pressure, displacement or shear, and is computed only
    from the tractions and the rigid-body motion. Increments of rolling are omitted, because the
    surfaces move by fractions of a cell. Slip is checked in undivided increments, and in cells that
    were in contact before: part of the slip of a new cell occurs before it touches, unless pressure
    and shear were solved together.
    """
    matrix, n = dense_matrix(contact), contact.gap.size
    x, y = (c.ravel() for c in np.meshgrid(contact.grid.x, contact.grid.y, indexing="ij"))
    before, moved = np.zeros((3, *contact.gap.shape)), np.zeros(3)
    found = []
    for step, state in zip(contact.steps, states, strict=False):
        if "advance" in step:
            break
        tractions = np.concatenate([state.pressure[None], state.shear])
        motion = np.array([*state.shift, state.twist])
        by, moved = motion - moved, motion
        u = (matrix @ tractions.ravel()).reshape(3, n)
        gap = contact.gap.ravel() + u[0] - state.approach
        slip = (matrix @ before.ravel()).reshape(3, n)[1:] - u[1:]
        slip += np.array([by[0] - by[2] * y, by[1] + by[2] * x])
        known = (before[0].ravel() > 0) | (state.joint_steps > 0)
        known &= state.substeps == 1
        found.append(residual(contact.friction, tractions.reshape(3, n), gap, slip, u, known))
        before = tractions
    return found


def residual(
    law: Any, tractions: Array, gap: Array, slip: Array, displacement: Array, known: Array
) -> float:
    """Return the largest residual of the conditions of contact and friction.

    known: cells in which the slip is known. In a cell at zero pressure, shear is allowed only if
    the gap is closed, and only with infinite friction or a Tresca law.
    """
    pressure, shear = tractions[0], tractions[1:]
    size, largest = np.hypot(*shear), max(float(np.hypot(*shear).max()), 1e-300)
    scale, lift = float(pressure.max()), float(np.abs(displacement[0]).max())
    normal = np.abs(np.minimum(pressure / scale, gap / lift)).max()
    cap = law.limit if isinstance(law, sc.Tresca) else math.inf
    slope = 1 / law.coefficient if isinstance(law, sc.Coulomb) else 0.0
    bound = np.minimum(pressure / slope, cap) if slope else np.full(pressure.shape, cap)
    largest = max(largest, 1e-3 * min(float(bound.max()), scale))
    bound = np.where(pressure > 0, bound, np.minimum(size, cap) if slope == 0 else 0.0)
    apart = np.where((pressure <= 0) & (size > 0), np.abs(gap) / lift, 0.0).max()
    stiffness = largest / max(float(np.hypot(*displacement[1:]).max()), 1e-300)
    pulled = shear + stiffness * slip
    length = np.hypot(*pulled)
    cut = np.where(length > bound, bound / np.maximum(length, 1e-300), 1.0)
    off = np.hypot(*(shear - cut * pulled)) * known
    beyond = np.maximum(size - bound, 0.0)
    return float(max(normal, apart, off.max() / largest, beyond.max() / largest))


def main(arguments: list[str]) -> None:
    """Print the result of each contact, and a summary."""
    law, first, last = arguments[0], int(arguments[1]), int(arguments[2])
    failed, largest = 0, 0.0
    newton: list[int] = []
    for number in range(first, last):
        contact, start = random_contact(law, number), time.process_time()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = solve(contact)
        work = {name: count for name, count in found.counters.items() if name != "volume_bytes"}
        took = time.process_time() - start
        worst = max(residuals(contact, found.states), default=0.0) if "check" in arguments else 0.0
        failed += bool(found.error)
        newton += [work["joint_steps"]] if work["joint_steps"] else []
        largest = max(largest, worst)
        end = f"FAILED in increment {len(found.states)}: {found.error}" if found.error else "solved"
        line = f"{number} {found.digest()} {took:.2f} s {contact.name} {contact.friction}"
        print(line, work, f"{worst:.1e}", end, flush=True)
    print(
        f"{failed} of {last - first} without a solution; pressure and shear together in "
        f"{len(newton)}, Newton steps: median {np.median(newton or [0]):g}, maximum "
        f"{max(newton, default=0)}; largest residual {largest:.1e}"
    )


if __name__ == "__main__":
    main(sys.argv[1:])
