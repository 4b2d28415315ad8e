# SPDX-License-Identifier: GPL-3.0-or-later
"""Semi-analytical elastic-plastic contact of two bodies. SI units everywhere."""

from importlib import import_module as _import_module
from typing import TYPE_CHECKING

from ._util import silent_interrupt  # noqa: F401  (active while the package is loaded)

# isort: split
from ._util import load_core  # noqa: F401  (before anything that needs the core)

# isort: split
from ._core import ConvergenceError, GridTooSmallError, PullOffError
from ._core import version as __version__
from ._util.errors import (
    ConvergenceWarning,
    ElasticStrainWarning,
    GridTooSmallWarning,
    IncrementWarning,
    PlasticStrainWarning,
    ResolutionWarning,
    SingularPressureWarning,
    UnitWarning,
    WornCoatingWarning,
)
from .problem import friction as _friction
from .problem import varying_friction as _varying_friction
from .problem.friction import *  # noqa: F403  (all laws)
from .problem.varying_friction import *  # noqa: F403  (all laws)

__all__ = [
    "AccuracyResult",
    "AccuracyWarning",
    "Adhesion",
    "CheckpointError",
    "ContactSolution",
    "ContactSolver",
    "ConvergenceError",
    "ConvergenceWarning",
    "ElasticStrainWarning",
    "FoundLoad",
    "FreeRollingSolution",
    "Grid",
    "GridErrors",
    "GridTooSmallError",
    "GridTooSmallWarning",
    "HardContact",
    "Heat",
    "Heterogeneous",
    "Inclusion",
    "IncrementErrors",
    "IncrementWarning",
    "Layered",
    "Lubricant",
    "Material",
    "PartialSlipSolution",
    "PlasticStrainWarning",
    "PullOffError",
    "Relief",
    "ResolutionWarning",
    "RollingSolution",
    "Simulation",
    "SingularPressureWarning",
    "SlidingSolution",
    "State",
    "SweepInterrupted",
    "TensileLimit",
    "Track",
    "UnitWarning",
    "WornCoatingWarning",
    "Zone",
    "__version__",
    "adhesion",
    "asperities",
    "bearings",
    "critical",
    "dents",
    "energy",
    "estimate_errors",
    "fatigue",
    "find_load",
    "flattening",
    "hardness",
    "heat",
    "heat_kernels",
    "hertz",
    "inclusions",
    "kernels",
    "lubricants",
    "lubrication",
    "materials",
    "measured",
    "operators",
    "overrolling",
    "parts",
    "paths",
    "rolling",
    "shakedown",
    "sliding",
    "softening",
    "surfaces",
    "sweep",
    "to_accuracy",
    "units",
    "wear",
]
__all__ += _friction.__all__
__all__ += _varying_friction.__all__

# Loaded on first use, because a program needs few of them.
_MODULES = frozenset(
    (
        "adhesion",
        "asperities",
        "bearings",
        "cases",
        "critical",
        "dents",
        "energy",
        "fatigue",
        "flattening",
        "hardness",
        "heat",
        "heat_kernels",
        "hertz",
        "inclusions",
        "kernels",
        "lubricants",
        "lubrication",
        "materials",
        "measured",
        "operators",
        "overrolling",
        "parts",
        "paths",
        "plotting",
        "report",
        "results",
        "rolling",
        "shakedown",
        "sliding",
        "softening",
        "surfaces",
        "units",
        "wear",
    )
)
_PLACES = {
    "_util.errors": ("AccuracyWarning",),
    "accuracy.grid_errors": ("GridErrors", "estimate_errors"),
    "accuracy.load_search": ("FoundLoad", "find_load"),
    "accuracy.outcome": ("AccuracyResult",),
    "accuracy.prescribed": ("to_accuracy",),
    "bodies.heterogeneous": ("Heterogeneous",),
    "bodies.inclusion": ("Inclusion",),
    "bodies.layers": ("Layered",),
    "bodies.material": ("Material",),
    "contact.solver": ("ContactSolver",),
    "heat": ("Heat",),
    "lubricants": ("Lubricant",),
    "problem.adhesion_laws": ("Adhesion",),
    "problem.contact_law": ("HardContact", "TensileLimit"),
    "problem.grid": ("Grid",),
    "problem.moving_topography": ("Relief",),
    "restart.file": ("CheckpointError",),
    "simulation.increment_errors": ("IncrementErrors",),
    "simulation.simulation": ("Simulation",),
    "solutions.contact_solution": ("ContactSolution", "PartialSlipSolution", "RollingSolution"),
    "solutions.moving_solution": ("FreeRollingSolution", "SlidingSolution"),
    "solutions.state": ("State",),
    "solutions.track": ("Track",),
    "solutions.zone": ("Zone",),
    "sweeps": ("SweepInterrupted", "sweep"),
}

if TYPE_CHECKING:
    from . import (
        adhesion,
        asperities,
        bearings,
        critical,
        dents,
        energy,
        fatigue,
        flattening,
        hardness,
        heat,
        heat_kernels,
        hertz,
        inclusions,
        kernels,
        lubricants,
        lubrication,
        materials,
        measured,
        operators,
        overrolling,
        parts,
        paths,
        rolling,
        shakedown,
        sliding,
        softening,
        surfaces,
        units,
        wear,
    )
    from . import cases as cases
    from . import plotting as plotting
    from . import report as report
    from . import results as results
    from ._util.errors import AccuracyWarning
    from .accuracy.grid_errors import GridErrors, estimate_errors
    from .accuracy.load_search import FoundLoad, find_load
    from .accuracy.outcome import AccuracyResult
    from .accuracy.prescribed import to_accuracy
    from .bodies.heterogeneous import Heterogeneous
    from .bodies.inclusion import Inclusion
    from .bodies.layers import Layered
    from .bodies.material import Material
    from .contact.solver import ContactSolver
    from .heat import Heat
    from .lubricants import Lubricant
    from .problem.adhesion_laws import Adhesion
    from .problem.contact_law import HardContact, TensileLimit
    from .problem.grid import Grid
    from .problem.moving_topography import Relief
    from .restart.file import CheckpointError
    from .simulation.increment_errors import IncrementErrors
    from .simulation.simulation import Simulation
    from .solutions.contact_solution import (
        ContactSolution,
        PartialSlipSolution,
        RollingSolution,
    )
    from .solutions.moving_solution import (
        FreeRollingSolution,
        SlidingSolution,
    )
    from .solutions.state import State
    from .solutions.track import Track
    from .solutions.zone import Zone
    from .sweeps import SweepInterrupted, sweep
else:
    _PLACE = {name: place for place, names in _PLACES.items() for name in names}

    def __getattr__(name):
        if name in _MODULES:
            return _import_module(f"{__name__}.{name}")
        if name in _PLACE:
            value = getattr(_import_module(f"{__name__}.{_PLACE[name]}"), name)
            globals()[name] = value
            return value
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

    def __dir__():
        return sorted({*globals(), *_MODULES, *_PLACE})
