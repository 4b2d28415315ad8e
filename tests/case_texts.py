# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files shared by tests: balls in pressing, rolling, collision and wear."""

SWIFT = 'law = "swift"\nE = 210e9\nnu = 0.3\nB = 945e6\nC = 20\nn = 0.121'
BODIES = f"""[body1]
law = "elastic"
E = 210e9
nu = 0.3
[body2]
{SWIFT}
[surface]
shape = "paraboloid"
Rx = 7.5e-3"""
GRID = """[grid]
nx = 15
ny = 13
dx = 60e-6
dy = 60e-6
nz = 12
dz = 60e-6"""
MINIMAL = f"""
title = "two balls"
{GRID}
{BODIES}
[[path]]
load = 600.0
increments = 2
[[path]]
load = 0.0
increments = 1
"""
MOVING = f"""
title = "moving"
{GRID}
{BODIES}
[contact]
friction = 0.0
[[path]]
load = 600.0
increments = 2
roll = {{distance = 180e-6, step = 60e-6, passes = 2, unload_increments = 1}}
"""
ASPERITIES = """
title = "Two spheres"
[asperities]
R1 = 1.0
R2 = 2.0
interference = 6e-4
increments = 8
passes = 2
back_and_forth = true
[body1]
law = "elastic"
E = 200e9
nu = 0.32
[body2]
law = "perfect_plastic"
E = 200e9
nu = 0.32
yield_stress = 0.9e9
[contact]
tol = 1e-7
"""
WEAR = """
title = "Wearing ball"
[grid]
nx = 21
ny = 21
dx = 60e-6
dy = 60e-6
nz = 24
dz = 24e-6
[body1]
law = "elastic"
E = 210e9
nu = 0.3
[body2]
law = "swift"
E = 210e9
nu = 0.3
B = 1735e6
C = 16.0
n = 0.067
[surface]
shape = "paraboloid"
Rx = 7.5e-3
[contact]
friction = 0.4
[[path]]
load = 1700.0
increments = 1
[[path]]
load = 0.0
increments = 1
[wear]
threshold = 0.002
cycles = 1
window = [3, 5]
order = 1
[output]
figures = false
"""
SCAR = """
title = "Fretting ball"
[grid]
nx = 24
ny = 24
dx = 8e-6
dy = 8e-6
[body1]
law = "elastic"
E = 210e9
nu = 0.3
[body2]
law = "elastic"
E = 210e9
nu = 0.3
[surface]
shape = "paraboloid"
Rx = 5e-3
[contact]
friction = {coulomb = 0.5}
[[path]]
load = 8.0
increments = 1
[[path]]
load = 8.0
increments = 1
fret = {tangential_load_x = 2.4}
[wear]
energy = [1e-14, 3e-14]
repeats = 20000
cycles = 2
"""
