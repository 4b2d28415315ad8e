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

from cases_with_figures import CASES
from overlapping_texts import overlaps_when_saved

from samcontact.commands import solve_study
from samcontact.commands.folder import _FIGURES
from samcontact.commands.main import main
from samcontact.plotting import summary

STORED = Path(__file__).parents[2] / "images"
WIDTH = 280
"""Pixels of what is stored."""
LIMIT = 0.06
"""Matplotlib 3.10 and 3.11 differ by 0.051, a line that is missing by 0.118."""
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
    "film in time": ("film_map", "film_profile", "interferogram"),
    "pressed film": ("film_map", "film_profile", "interferogram"),
    "heated film": ("film_map", "film_profile", "interferogram", "regime_chart"),
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
    written, written_film = summary.save, solve_study.save_figure
    with pytest.MonkeyPatch.context() as patch, overlaps_when_saved() as hidden:
        patch.setattr(
            summary,
            "save",
            lambda figure, path: path if path.stem in others else written(figure, path),
        )
        patch.setattr(
            solve_study,
            "save_figure",
            lambda figure, path: path if path.stem in others else written_film(figure, path),
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
