# SPDX-License-Identifier: GPL-3.0-or-later
"""Example case files of the package, which users can copy and change."""

from __future__ import annotations

import re
import sys
from pathlib import Path

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

from .._util.short_text import in_short

FOLDER = Path(__file__).parents[1] / "cases" / "example_files"
FIRST_CASES = {
    "adhesion": "k1_adhering_tip",
    "bearing": "b5_bearing_6208",
    "bearing_film": "l2_bearing_6208_in_oil",
    "ehl": "l1_ball_in_oil",
    "gear_film": "l3_gear_flank_in_oil",
    "stribeck": "l4_from_full_film_to_dry",
    "dent_in_oil": "l5_dent_in_oil",
    "yielding_film": "l6_race_that_yields_in_oil",
    "roller": "b6_misaligned_roller",
    "gear": "b4_gear_flank",
    "case_depth": "b7_case_depth",
    "coated_gear": "b8_coated_gear",
    "dent": "r6_dented_raceway",
    "coating": "c1_coated_contact",
    "coating_wear": "w3_coated_wear",
    "inclusion": "i1_oxide_below_raceway",
    "microstructure": "i2_random_oxides",
    "rough": "w2_running_in",
    "rubber": "p2_rubber_friction",
    "fretting": "s1_fretting_ball",
    "blade": "s5_blade_root",
    "rail": "s6_rail_traction",
    "indentation": "v1_nano_indentation",
    "coated_indentation": "v3_coated_indentation",
}
"""Name of the example that `samcontact new` writes, by kind of problem."""


def example_names() -> list[str]:
    """Return the names of all examples, sorted."""
    return sorted(file.stem for file in FOLDER.glob("*.toml"))


def example_text(name: str, path: str | None = None) -> str:
    """Return the text of an example.

    Parameters
    ----------
    name : str
        Name of the example, e.g. "t1_two_balls".
    path : str, optional
        Path to which the text will be written. It appears in the commands quoted in the comments.

    Raises
    ------
    ValueError
        There is no example of this name.
    """
    names = example_names()
    if name not in names:
        raise ValueError(f"name: must be one of {', '.join(names)}, got {in_short(name)}")
    text = (FOLDER / f"{name}.toml").read_text(encoding="utf-8")
    return re.sub(rf"cases/{name}\.toml", lambda _: path or f"{name}.toml", text)


def example_title(name: str) -> str:
    """Return the title of an example."""
    title = tomllib.loads(example_text(name))["title"]
    assert isinstance(title, str)
    return title
