# SPDX-License-Identifier: GPL-3.0-or-later
"""Library of materials: constants of common materials, each with its source.

    steel = sc.materials.get("52100")
    steel.material()            # elastic, with thermal constants if they are known
    steel.material("swift")     # with a hardening law
    steel.source("E")           # where the value is from

Each constant in the library has a source. A request for a constant that the library does not
contain raises ValueError. Strength depends on the treatment of a part, so prefer values from your
own tests (`Material.from_test`).
"""

from .entry import MaterialData, SourcedValue
from .library import get, names

__all__ = ["MaterialData", "SourcedValue", "get", "names"]
