# SPDX-License-Identifier: GPL-3.0-or-later
"""Library of materials: constants of common materials, each with its source.

    steel = sc.materials.get("52100")
    steel.material()            # elastic, with thermal constants if they are known
    steel.material("swift")     # with a hardening law
    steel.source("E")           # where the value is from

The library contains no constants without a source: a request for such a constant raises ValueError.
Strength depends on the treatment of a part, so prefer values of your own tests
(`Material.from_test`).
"""

from .entry import MaterialData, SourcedValue
from .library import get, names

__all__ = ["MaterialData", "SourcedValue", "get", "names"]
