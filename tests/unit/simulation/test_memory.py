# SPDX-License-Identifier: GPL-3.0-or-later
"""Memory of an elastic-plastic increment with a plastic zone that fills the volume."""

import subprocess
import sys

import pytest

SETUP = """
import numpy as np
import samcontact as sc

def peak():
    with open("/proc/self/status") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith("VmHWM"))

n, a = {cells}, 418.2e-6
nz = int(0.62 * n)
grid = sc.Grid(n, n, 2.35 * a / n, 2.35 * a / n, nz, 1.5 * a / nz)
r2 = (grid.x[:, None] ** 2 + grid.y**2) / a**2
pressure = 4.096e9 * np.sqrt(np.maximum(0, 1 - r2)) * (1 + 1e-3 * (grid.x[:, None] + grid.y) / a)
steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
small = sc.Grid(8, 8, 1e-5, 1e-5, 4, 1e-5)
sc.Simulation(small, sc.Material.elastic(210e9, 0.3), steel, np.zeros((8, 8))).step(
    pressure=np.full((8, 8), 1e8)
)  # loads all modules
before = peak()
sim = sc.Simulation(grid, sc.Material.elastic(210e9, 0.3), steel, np.zeros((n, n)),
                    residual_stress="fast")
state = sim.step(pressure=pressure)
assert (state.equivalent_plastic_strain() > 0).mean() > 0.4
print((peak() - before) / (n * n * nz))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.parametrize("cells", [72, pytest.param(118, marks=pytest.mark.slow)])
def test_below_750_bytes_a_cell(cells):
    command = [sys.executable, "-c", SETUP.format(cells=cells)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    assert float(done.stdout) < 750
