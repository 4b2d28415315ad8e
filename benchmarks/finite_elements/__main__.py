# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.finite_elements: two contacts by finite elements and by samcontact.

On one thread: OMP_NUM_THREADS must be 1. Writes what was measured to results.json, and with --docs
a page of the documentation.
"""

from __future__ import annotations

import argparse
import json
import os
import tempfile
from pathlib import Path
from types import ModuleType
from typing import Any

import matplotlib.pyplot as plt

from ..harness import ROOT
from . import balls, wave
from .tables import Points, Runs, points

KEPT = Path(__file__).parent / "results.json"
PAGE = ROOT / "docs" / "finite_elements.md"
FIGURES = ROOT / "docs" / "figures"
SCENES = {"balls": balls, "wave": wave}
REPEATS = 3  # of samcontact; the least time counts: what disturbs only adds
LABELS = {"a grid": "samcontact", "an accuracy": "samcontact, to an accuracy"}
TEXT = """<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by: OMP_NUM_THREADS=1 python -m benchmarks.finite_elements --docs -->
# Beside finite elements

Two contacts that yield, one with an axis and one without, by samcontact and by
[CalculiX](https://www.calculix.de) 2.20 (Debian's `calculix-ccx`). Both codes solve them on one
thread, on meshes of their own.

```console
$ apt install calculix-ccx
$ OMP_NUM_THREADS=1 python -m benchmarks.finite_elements --docs
```

Tables have the largest of the errors of five numbers, each against its code's own limit on fine
meshes (the two finest extrapolated with order two), and the processor's time. Work on the deck is
not in it.

{sections}"""


def measure(
    scene: ModuleType, elements: tuple[int, ...], cells: tuple[int, ...]
) -> dict[str, Runs]:
    """Both codes on all meshes, by name and size."""
    found: dict[str, Runs] = {"CalculiX": {}, "samcontact": {}}
    for across in cells:
        runs = [scene.solve(across) for _ in range(REPEATS)]
        found["samcontact"][str(across)] = min(runs, key=lambda run: run["seconds"])
        print("samcontact", across, found["samcontact"][str(across)], flush=True)
    for across in elements:
        with tempfile.TemporaryDirectory() as folder:
            found["CalculiX"][str(across)] = scene.finite_elements(Path(folder), across)
        print("CalculiX", across, found["CalculiX"][str(across)], flush=True)
    return found


def measured(name: str) -> dict[str, Any]:
    """All that the section of a scene takes."""
    scene = SCENES[name]
    found: dict[str, Any] = {"runs": measure(scene, scene.ELEMENTS, scene.CELLS)}
    if scene is balls:
        found |= {"slopes": balls.measure_slopes(), "accuracy": balls.measure_accuracy()}
    return found


def page(kept: dict[str, dict[str, Any]]) -> str:
    """All of it, from what is kept of each scene."""
    return TEXT.format(sections="\n".join(SCENES[name].section(**kept[name]) for name in SCENES))


def draw(name: str, kept: dict[str, Any]) -> None:
    """Largest error of all quantities over time."""
    scene = SCENES[name]
    lines: dict[str, Points] = {"CalculiX": points(kept["runs"]["CalculiX"], scene.QUANTITIES)}
    lines |= {LABELS[than]: known for than, known in scene.ours(**kept).items()}
    figure, ax = plt.subplots(figsize=(5.2, 3.6), layout="constrained")
    for (label, known), marker in zip(lines.items(), "sod", strict=False):
        errors, seconds = zip(*known, strict=True)
        ax.loglog(seconds, [100 * e for e in errors], marker=marker, label=label)
    ax.set(xlabel="processor's time [s]", ylabel="largest error [%]")
    ax.grid(which="major", alpha=0.3)
    ax.legend()
    figure.savefig(FIGURES / scene.FIGURE, dpi=150)
    plt.close(figure)


def parsed() -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="coarse meshes only, keep nothing")
    parser.add_argument("--docs", action="store_true", help="write the page of the documentation")
    parser.add_argument("--scene", choices=SCENES, help="only this one anew, keep the rest")
    parser.add_argument("--accuracy", action="store_true", help="to accuracies anew, keep the rest")
    parser.add_argument("--page", action="store_true", help="only that, from what is kept")
    given = parser.parse_args()
    if not given.page and os.environ.get("OMP_NUM_THREADS") != "1":
        parser.error("both codes are to have one thread: set OMP_NUM_THREADS=1")
    return given


def main() -> None:
    """Measure, keep, and write the page."""
    given = parsed()
    names = [given.scene] if given.scene else list(SCENES)
    if given.quick:
        for name in names:
            measure(SCENES[name], SCENES[name].ELEMENTS[:1], SCENES[name].CELLS[:2])
        return
    kept = json.loads(KEPT.read_text(encoding="utf-8"))
    if given.accuracy:
        kept["balls"]["accuracy"] = balls.measure_accuracy()
    elif not given.page:
        kept |= {name: measured(name) for name in names}
    KEPT.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")
    if given.docs or given.page:
        for name in SCENES:
            draw(name, kept[name])
        PAGE.write_text(page(kept), encoding="utf-8")


if __name__ == "__main__":
    main()
