# SPDX-License-Identifier: GPL-3.0-or-later
"""Every figure written by default looks like its stored, inspected image.

`python tests/unit/plotting/test_default_images.py` replaces the stored images: inspect
each before you commit it.
"""

import sys
from pathlib import Path

import matplotlib
import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image

sys.path.insert(0, str(Path(__file__).parents[2]))

from overlapping_texts import overlaps_when_saved

from case_texts import ASPERITIES, BODIES, GRID, MOVING, WEAR
from samcontact.commands.folder import _FIGURES
from samcontact.commands.main import main
from samcontact.plotting import summary

STORED = Path(__file__).parents[2] / "images"
WIDTH = 280
"""Pixels of what is stored."""
LIMIT = 0.06
"""Matplotlib 3.10 and 3.11 differ by 0.051, a line that is missing by 0.118."""
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
EQUAL_IMAGES = {("wear", "last_cycle_body2"): "wear/first_cycle_body2"}
"""Figures that look as others, which are stored."""
FIRST_IN_OTHERS = {
    "long": ("axis_stress", "load_approach", "pressure", "sections"),
    "fretting": ("gap_map", "pressure", "pressure_map"),
    "adhering": ("gap_map", "pressure", "pressure_map"),
    "creeping": (
        "gap_map", "pressure", "pressure_map", "load_approach", "imprint", "imprint_map",
    ),
    "included": (
        "axis_stress", "gap_map", "load_approach", "pressure", "pressure_map", "imprint",
        "imprint_map",
    ),
    "fatigue": (
        "axis_stress", "gap_map", "load_approach", "pressure", "pressure_map", "imprint",
        "imprint_map", "residual", "sections",
    ),
    "hardened": (
        "axis_stress", "gap_map", "load_approach", "pressure", "pressure_map", "imprint",
        "imprint_map", "residual", "sections", "fatigue_depth", "fatigue_section",
    ),
}  # fmt: skip
"""Figures that other cases have stored; once is enough."""
OLD_TICKS = {"shakedown"} if matplotlib.__version_info__ < (3, 11) else set()
"""Figures whose decades this matplotlib labels otherwise than that of those stored."""


def drawn(case, folder):
    """Return the small figures of a case that no other case stores; no texts may overlap."""
    file = folder / f"{case}.toml"
    file.write_text(CASES[case])
    others = FIRST_IN_OTHERS.get(case, ())
    written = summary.save
    with pytest.MonkeyPatch.context() as patch, overlaps_when_saved() as hidden:
        patch.setattr(
            summary,
            "save",
            lambda figure, path: path if path.stem in others else written(figure, path),
        )
        outcome = CliRunner().invoke(
            main, ["run", str(file), "--output", str(folder / case), "--quiet"]
        )
    assert outcome.exit_code == 0, outcome.output
    assert len(hidden) >= len(list((folder / case).glob("*.png"))) > 0
    assert not any(hidden.values()), list(hidden.values())
    found = {}
    for path in sorted((folder / case).glob("*.png")):
        with Image.open(path) as image:
            height = round(WIDTH * image.height / image.width)
            found[path.stem] = image.convert("RGB").resize((WIDTH, height), Image.Resampling.BOX)
    return found


def difference(image, other):
    """Return the difference of two images, 0 to 1: the maximum of means over 10-pixel squares.

    Each square is compared at its place and shifted by one pixel, and the smallest difference
    counts: fonts, and with them the size of panels, differ between versions of matplotlib, and a
    frame that moves by a pixel is no flaw. A missing or displaced line changes more.
    """
    assert abs(image.height - other.height) <= 0.04 * other.height
    image = image.resize(other.size)
    offsets = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1)]
    moved = [np.abs(squares(image, *by) - squares(other)).max(axis=2) for by in offsets]
    return float(np.min(moved, axis=0).max()) / 255


def squares(image, x=0, y=0):
    """Return means over squares of about 10 pixels, without the image edge, shifted by x, y."""
    box = (1 + x, 1 + y, image.width - 1 + x, image.height - 1 + y)
    size = image.width // 10, image.height // 10
    return np.asarray(image.resize(size, Image.Resampling.BOX, box), dtype=float)


def stored(case):
    own = {path.stem: path for path in (STORED / case).glob("*.jpg")}
    others = {
        name: STORED / f"{path}.jpg" for (of, name), path in EQUAL_IMAGES.items() if of == case
    }
    return dict(sorted((own | others).items()))


@pytest.mark.parametrize("case", CASES)
def test_figures_look_as_those_stored(case, tmp_path):
    found, expected = drawn(case, tmp_path), stored(case)
    assert set(expected) <= set(found)
    assert set(found) <= {name for other in CASES for name in stored(other)}
    for name in expected.keys() - OLD_TICKS:
        with Image.open(expected[name]) as image:
            assert difference(found[name], image.convert("RGB")) < LIMIT, name


def test_every_figure_of_a_run_is_stored():
    names = {name.replace("[12]", body) for name in _FIGURES for body in "12"}
    there = {name for case in CASES for name in stored(case)}
    of_body_1 = {name for name in names if name.endswith("body1")}  # drawn as those of body 2
    assert there | of_body_1 == names | (there & of_body_1)


def test_a_changed_image_is_detected():
    """A missing line, or cells instead of smooth colours, cause larger differences than fonts."""
    with Image.open(STORED / "heated" / "pressure.jpg") as image:
        shown = image.convert("RGB")
    without = np.array(shown)
    without[np.ptp(without.astype(int), axis=2) > 40] = 255  # what has colour
    assert difference(Image.fromarray(without), shown) > 1.5 * LIMIT
    with Image.open(STORED / "heated" / "sections.jpg") as image:
        shown = image.convert("RGB")
    coarse = shown.resize((14, shown.height // 20), Image.Resampling.BOX)
    assert difference(coarse.resize(shown.size, Image.Resampling.NEAREST), shown) > 1.5 * LIMIT


if __name__ == "__main__":
    import tempfile

    for case in CASES:
        (STORED / case).mkdir(parents=True, exist_ok=True)
        for old in (STORED / case).glob("*.jpg"):
            old.unlink()
        with tempfile.TemporaryDirectory() as folder:
            for name, image in drawn(case, Path(folder)).items():
                if (case, name) not in EQUAL_IMAGES and name not in FIRST_IN_OTHERS.get(case, ()):
                    image.save(STORED / case / f"{name}.jpg", quality=90, optimize=True)
