# SPDX-License-Identifier: GPL-3.0-or-later
"""Semi-analytical elastic-plastic contact of two bodies. SI units everywhere."""

from importlib import import_module as _import_module
from typing import TYPE_CHECKING

from ._util import silent_interrupt  # noqa: F401  (active while the package is loaded)

# isort: split
from ._util import load_core  # noqa: F401  (before anything that needs the core)

# isort: split
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
from .accuracy import AccuracyResult, AccuracyWarning, to_accuracy
from .accuracy.grid_errors import GridErrors, estimate_errors
from .accuracy.load_search import FoundLoad, find_load
from .bodies.heterogeneous import Heterogeneous
from .bodies.inclusion import Inclusion
from .bodies.layered import Layered
from .bodies.material import Material
from .contact.solver import ContactSolver
from .heat import Heat
from .lubricants import Lubricant
from .problem import friction as _friction
from .problem import varying_friction as _varying_friction
from .problem.adhesion_laws import Adhesion
from .problem.contact_law import HardContact, TensileLimit
from .problem.friction import *  # noqa: F403  (all laws)
from .problem.grid import Grid
from .problem.moving_topography import Relief
from .problem.varying_friction import *  # noqa: F403  (all laws)
from .restart.file import CheckpointError
from .simulation.increment_errors import IncrementErrors
from .simulation.simulation import Simulation
from .solutions.contact_solution import ContactSolution, PartialSlipSolution, RollingSolution
from .solutions.moving_solution import FreeRollingSolution, SlidingSolution
from .solutions.state import State
from .solutions.track import Track
from .solutions.zone import Zone
from .sweeps import SweepInterrupted, sweep

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

if TYPE_CHECKING:
    from . import cases as cases
    from . import plotting as plotting
    from . import report as report
    from . import results as results
else:
    _ON_DEMAND = ("cases", "plotting", "report", "results")
    # loaded on first use: they import file and figure libraries, not needed for a solution

    def __getattr__(name):
        if name in _ON_DEMAND:
            return _import_module(f"{__name__}.{name}")
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

    def __dir__():
        return sorted({*globals(), *_ON_DEMAND})
