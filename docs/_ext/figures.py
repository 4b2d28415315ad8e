# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of the benchmarks, drawn from their stored records before pages are read.

They are in build/figures, and drawn again when records, benchmarks or the package have changed.
Those in docs/figures are stored: they are of runs of minutes, whose records are not.
"""

from __future__ import annotations

import hashlib
import importlib
import json
import sys
from typing import Any

from executed import ROOT, fingerprint
from sphinx.application import Sphinx

BENCHMARKS = ROOT / "benchmarks"
NAMES = ("experiments", "finite_elements", "peers", "static_capacity")


def key(name: str) -> str:
    """Return the hash of everything that the figures of a benchmark depend on."""
    found = hashlib.sha256(fingerprint().encode())
    for file in sorted([*BENCHMARKS.glob("*.py"), *(BENCHMARKS / name).glob("*.*")]):
        found.update(file.name.encode() + file.read_bytes())
    return found.hexdigest()


def figures(name: str) -> dict[str, Any]:
    """Draw the figures of a benchmark from its stored records; the keys are file names."""
    if name == "peers":
        peers = importlib.import_module("benchmarks.peers.figures")
        stored = BENCHMARKS / name / "results.json"
        return peers.draw(json.loads(stored.read_text(encoding="utf-8")))
    study = importlib.import_module("benchmarks.study").find(name)
    return study.draw(study.records())


def draw(app: Sphinx) -> None:
    """Draw the figures that do not exist yet, or whose inputs have changed."""
    for name in NAMES:
        drawn_from = ROOT / "build" / "figures" / f"{name}.key"
        if not drawn_from.exists() or drawn_from.read_text() != key(name):
            importlib.import_module("benchmarks.study").save(figures(name))
            drawn_from.write_text(key(name))


def setup(app: Sphinx) -> dict[str, bool]:
    sys.path.append(str(ROOT))
    app.connect("builder-inited", draw)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
