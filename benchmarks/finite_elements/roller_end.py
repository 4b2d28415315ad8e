# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.finite_elements.roller_end: end of an elastic roller by CalculiX.

The eighth of a cylinder on a rigid plane, which is the symmetry plane of two equal rollers that end
at the same place. Linear hexahedra become larger away from the end of the contact. The pressure is
the nodal force of the plane over the area of the node. Units are millimetres, newtons and
megapascals. The run writes reference/roller_end/calculix.json.
"""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

import numpy as np

import reference
from samcontact import hertz

from . import calculix
from .deck import FloatArray, contact, named, surface

RADIUS, HALF_LENGTH, HALF_WIDTH = 8.0, 6.0, 6.0
E, NU = 210e3, 0.3
STIFFNESS = 1e9  # contact stiffness [N/mm^3]: 3 nm of penetration
CELL_X, CELL_Y = 0.04, 0.04  # elements at the end of the contact
FINE_X, FINE_Y, FINE_Z = 0.36, 0.2, 0.1  # extents of uniform elements
GROWTH, GROWTH_Y, MAX_CELL_Y = 1.4, 1.3, 0.6
DISPLACEMENT = 0.012  # of the middle plane, for about 11 kN
INCREMENTS = 4
FILE = Path(reference.__file__).parent / "roller_end" / "calculix.json"


def ticks(cell: float, fine: float, end: float, growth: float, longest: float) -> FloatArray:
    """Return coordinates from 0 to `end`, equally spaced up to `fine`, then growing."""
    found = [0.0]
    while found[-1] < fine - 1e-9:
        found.append(found[-1] + cell)
    last, step = len(found) - 1, cell
    while found[-1] < end:
        step = min(step * growth, longest)
        found.append(found[-1] + step)
    x = np.array(found)
    x[last + 1 :] = x[last] + (x[last + 1 :] - x[last]) * (end - x[last]) / (x[-1] - x[last])
    return x


def areas(x: FloatArray) -> FloatArray:
    """Return the length that belongs to each node."""
    length = np.zeros_like(x)
    length[:-1] += np.diff(x) / 2
    length[1:] += np.diff(x) / 2
    return length


def corners(numbers: FloatArray, i: int, j: int, k: int) -> list[int]:
    """Return the nodes of a hexahedron, from the layer k + 1 to the layer k."""
    ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
    return [int(numbers[i + a, j + b, k + layer]) for layer in (1, 0) for a, b in ring]


def write(path: Path) -> tuple[FloatArray, FloatArray, int]:
    """Write the deck; return x and y of the nodes of the plane, and the number of nodes."""
    x = ticks(CELL_X, FINE_X, HALF_WIDTH, GROWTH, np.inf)
    y = ticks(CELL_Y, FINE_Y, HALF_LENGTH, GROWTH_Y, MAX_CELL_Y)
    z = ticks(CELL_X, FINE_Z, RADIUS, GROWTH, np.inf)
    top = np.sqrt(RADIUS**2 - x**2) - RADIUS
    roller = np.arange(x.size * y.size * z.size).reshape(x.size, y.size, z.size) + 1
    columns = int(np.searchsorted(x, FINE_X - 1e-9)) + 1
    plate = np.arange(columns * y.size * 2).reshape(columns, y.size, 2) + 1 + roller.size
    lines = ["*NODE, NSET=ALL"]
    for i, j, k in np.ndindex(roller.shape):
        height = top[i] - (RADIUS + top[i]) * z[k] / RADIUS
        lines.append(f"{roller[i, j, k]}, {x[i]:.12g}, {y[j]:.12g}, {height:.12g}")
    lines.append("*NODE, NSET=PLATE")
    for i, j, k in np.ndindex(plate.shape):
        lines.append(f"{plate[i, j, k]}, {x[i]:.12g}, {y[j]:.12g}, {0.1 * (1 - k):.12g}")
    lines.append("*ELEMENT, TYPE=C3D8, ELSET=BODIES")
    above, below, count = [], [], 0
    for numbers, sides in ((roller, below), (plate, above)):
        for i, j, k in np.ndindex(*(n - 1 for n in numbers.shape)):
            count += 1
            lines.append(", ".join(map(str, [count, *corners(numbers, i, j, k)])))
            if k == 0 and i < columns - 1:
                sides.append(count)
    lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{E}, {NU}"]
    lines += ["*SOLID SECTION, ELSET=BODIES, MATERIAL=STEEL"]
    lines += surface("BELOW", below, "S2") + surface("ABOVE", above, "S1") + contact(STIFFNESS)
    sets = {"SYMMETRY_X": roller[0], "SYMMETRY_Y": roller[:, -1], "MIDDLE": roller[:, :, -1]}
    for name, nodes in (sets | {"FACE": plate[:, :, 1]}).items():
        lines += named("NSET", name, nodes.ravel().tolist())
    lines += ["*BOUNDARY", "SYMMETRY_X, 1, 1", "SYMMETRY_Y, 2, 2", "PLATE, 1, 3"]
    lines += ["*STEP, INC=100", "*STATIC, DIRECT", f"{1 / INCREMENTS}, 1."]
    lines += ["*CONTROLS, PARAMETERS=FIELD", "1e-4, 1e-2", "*BOUNDARY"]
    lines += [f"MIDDLE, 3, 3, {DISPLACEMENT}", "*NODE PRINT, NSET=FACE, FREQUENCY=100", "RF"]
    path.write_text("\n".join([*lines, "*END STEP"]) + "\n")
    return x[:columns], y, roller.size


def main() -> None:
    """Run CalculiX and write the pressure on the centre line over the maximum by Hertz."""
    with tempfile.TemporaryDirectory() as folder:
        x, y, nodes = write(Path(folder) / calculix.DECK)
        calculix.run(Path(folder))
        text = (Path(folder) / calculix.PRINTED).read_text()
    rows = [line.split() for line in text.splitlines() if line.count("E") == 3]
    force = np.abs(np.array(rows, dtype=float))
    normal = force[np.argsort(force[:, 0]), 3].reshape(x.size, y.size)
    pressure = normal[0] / (areas(x)[0] * areas(y))
    load = 4e-3 * normal.sum() * 1e3
    line = hertz.line(R=RADIUS * 1e-3, E_star=E * 1e6 / (1 - NU**2),
                      load_per_length=load / (2e-3 * HALF_LENGTH))  # fmt: skip
    record = {
        "load": load, "nodes": nodes, "y": (1e-3 * y).tolist(),
        "pressure_over_hertz": (pressure * 1e6 / line.p0).tolist(),
    }  # fmt: skip
    FILE.write_text(json.dumps(record, indent=1) + "\n")


if __name__ == "__main__":
    main()
