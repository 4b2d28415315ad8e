# SPDX-License-Identifier: GPL-3.0-or-later
"""Small case files of each kind, whose figures are compared with stored images."""

from case_texts import ASPERITIES, BODIES, GRID, MOVING, WEAR

THERMAL = "[body2.thermal]\nconductivity = 50.2\nexpansion = 11.7e-6\ndiffusivity = 1.4e-5\n"
SURFACE = "[grid]\nnx = 27\nny = 25\ndx = 25e-6\ndy = 25e-6\n"
ELASTIC = 'law = "elastic"\nE = 210e9\nnu = 0.3\n'
PRESSED = "[[path]]\nload = 300.0\nincrements = 1\n[[path]]\nload = 300.0\n"
BALLS = (
    f'{SURFACE}[body1]\n{ELASTIC}[body2]\n{ELASTIC}[surface]\nshape = "paraboloid"\nRx = 7.5e-3\n'
)
CASES = {
    "heated": f"""title = "heated"
{GRID}
{BODIES.replace("[surface]", THERMAL + "[surface]")}
[heat]
factor = 0.05
history = [1e-3, 1.0]
[[path]]
load = 700.0
increments = 3
duration = 10e-3
[[path]]
load = 0.0
increments = 1
duration = 10e-3
""",
    "rolling": MOVING,
    "asperities": ASPERITIES,
    "wear": WEAR.replace("figures = false", "figures = true"),
    "long": f"""title = "long contact"
[grid]
nx = 17
ny = 17
dx = 55e-6
dy = 500e-6
nz = 6
dz = 55e-6
[body1]
{ELASTIC}[body2]
{ELASTIC}[[body2.layers]]
law = "elastic"
E = 300e9
nu = 0.25
thickness = 110e-6
[surface]
shape = "paraboloid"
Rx = 5.1e-3
Ry = 165e-3
[[path]]
load = 11000.0
increments = 1
""",
    "fretting": f"""title = "fretting"
{BALLS}[contact]
friction = {{coulomb = 0.3}}
{PRESSED}increments = 5
fret = {{tangential_load_x = 60.0, cycles = 1}}
""",
    "traction": f"""title = "rolling with creepage"
{BALLS}[contact]
friction = {{coulomb = 0.4}}
{PRESSED}increments = 6
advance = [-150.15e-6, -149.85e-6]
[[path]]
load = 300.0
increments = 6
advance = [-150.4e-6, -149.6e-6]
""",
    "fatigue": f"""title = "fatigue"
{GRID}
{BODIES}
[fatigue]
dang_van = 0.3
fatemi_socie = 1.0
[shakedown]
cycles = 4
[[path]]
load = 700.0
increments = 3
[[path]]
load = 0.0
increments = 3
""",
    "hardened": """title = "hardened case"
[grid]
nx = 16
ny = 12
dx = 2e-5
dy = 2e-5
dz = 2e-5
nz = 20
[body1]
law = "rigid"
[body2]
material = "18CrNiMo7-6"
hardness = {surface = 620.0, core = 380.0, depth = 2e-4}
[surface]
shape = "paraboloid"
Rx = 5e-3
[fatigue]
orthogonal_shear = "x"
dang_van = 0.3
steady_axis = "x"
exposure = {defect = 2e-5}
[[path]]
load = 20.0
increments = 1
""",
    "scar": f"""title = "fretting wear"
{BALLS}[contact]
friction = {{coulomb = 0.3}}
{PRESSED}increments = 2
fret = {{tangential_load_x = 60.0, cycles = 1}}
[wear]
energy = 1e-14
repeats = 50000
cycles = 2
""",
}


CASES["creeping"] = """title = "creeping"
[grid]
nx = 24
ny = 24
dx = 80e-6
dy = 80e-6
[body1]
law = "rigid"
[body2]
law = "elastic"
E = 2.4e9
nu = 0.4
relaxation = {times = [0.1, 10.0], shares = [0.3, 0.4]}
[surface]
shape = "paraboloid"
Rx = 10e-3
[[path]]
load = 20.0
increments = 1
duration = 0.0
[[path]]
load = 20.0
increments = 16
duration = 300.0
first_duration = 0.01
"""
CASES["adhering"] = """title = "adhering"
[grid]
nx = 40
ny = 40
dx = 12e-9
dy = 12e-9
[body1]
law = "rigid"
[body2]
law = "elastic"
E = 200e6
nu = 0.4
[surface]
shape = "paraboloid"
Rx = 1e-6
[contact]
adhesion = {kind = "exponential", work = 0.05, range = 2.6e-9}
[[path]]
approach = 6e-9
start = -12e-9
increments = 18
[[path]]
approach = -12e-9
increments = 18
"""
CASES["included"] = """title = "inclusion and void"
[grid]
nx = 30
ny = 30
dx = 6e-6
dy = 6e-6
dz = 6e-6
nz = 16
[body1]
law = "rigid"
[body2]
law = "swift"
material = "52100"
[[body2.inclusions]]
center = [-27e-6, 0.0, 48e-6]
radius = 24e-6
E = 390e9
nu = 0.25
[[body2.inclusions]]
law = "void"
shape = "ellipsoid"
center = [33e-6, 0.0, 42e-6]
radii = [25e-6, 24e-6, 30e-6]
[surface]
shape = "paraboloid"
Rx = 3e-3
[[path]]
load = 20.0
increments = 2
[[path]]
load = 0.0
increments = 1
"""
CASES["film"] = """title = "film"
[lubricant]
kind = "roelands"
viscosity = 0.04
pressure_viscosity = 22e-9
eyring_stress = 5e6
[film]
load = 20.0
speeds = [1e-4, 1e-3, 1e-2, 0.1]
slide_to_roll = 0.05
order = 1
boundary = {thickness = 2e-9}
[grid]
nx = 32
ny = 24
dx = 15e-6
dy = 14e-6
[body1]
law = "elastic"
E = 207e9
nu = 0.3
[body2]
law = "elastic"
E = 207e9
nu = 0.3
[surface]
shape = "paraboloid"
Rx = 0.01
"""
CASES["film in time"] = (
    CASES["film"]
    .replace("speeds = [1e-4, 1e-3, 1e-2, 0.1]", "entrainment = 1.0")
    .replace("boundary = {thickness = 2e-9}", "[film.transient]\nduration = 240e-6\nsteps = 8")
    + '[relief2]\nkind = "dent"\ndepth = 2e-7\nradius = 60e-6\nx = -180e-6\n'
)
ELASTIC = 'law = "elastic"\nE = 207e9\nnu = 0.3\n'
PLASTIC = ELASTIC.replace("elastic", "linear_hardening")
PLASTIC += "yield_stress = 0.9e9\ntangent_modulus = 5e9\n"
CASES["pressed film"] = (
    CASES["film"]
    .replace("speeds = [1e-4, 1e-3, 1e-2, 0.1]", "entrainment = 4.0\nincrements = 2")
    .replace("load = 20.0", "load = 900.0")
    .replace("slide_to_roll = 0.05\n", "")
    .replace("boundary = {thickness = 2e-9}\n", "")
    .replace("viscosity = 0.04", "viscosity = 0.1")
    .replace("15e-6", "54e-6")
    .replace("14e-6", "54e-6")
    .replace(ELASTIC + "[surface]", PLASTIC + "[surface]")
)
CASES["heated film"] = (
    CASES["film"]
    .replace("speeds = [1e-4, 1e-3, 1e-2, 0.1]", "entrainment = 2.0\nthermal = true")
    .replace("slide_to_roll = 0.05", "slide_to_roll = 0.5")
    .replace("boundary = {thickness = 2e-9}\n", "")
    .replace("[film]", "thermal = {conductivity = 0.14, capacity = 1.7e6, beta = 0.04}\n[film]")
    .replace(
        "nu = 0.3\n",
        "nu = 0.3\nthermal = {conductivity = 46.0, expansion = 12e-6, diffusivity = 12.5e-6}\n",
    )
)
CASES["friction"] = """title = "friction over velocity"
[sliding]
mean_pressure = 1e6
slowest = 1e-4
fastest = 1e3
per_decade = 2
[grid]
nx = 32
ny = 32
dx = 31.25e-6
dy = 31.25e-6
periodic = "xy"
[body1]
law = "rigid"
[body2]
law = "elastic"
E = 200e6
nu = 0.49
relaxation = {times = [1e-5, 1e-4, 1e-3, 1e-2], shares = [0.3, 0.3, 0.2, 0.1]}
[surface]
shape = "paraboloid"
Rx = inf
[surface.roughness]
kind = "self_affine"
rms_height = 15e-6
hurst = 0.8
wavelength_min = 125e-6
wavelength_max = 500e-6
seed = 3
"""
