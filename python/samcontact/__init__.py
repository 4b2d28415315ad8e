# SPDX-License-Identifier: GPL-3.0-or-later
"""Semi-analytical elastic-plastic contact of two bodies. SI units everywhere."""

from importlib import import_module as _import_module
from typing import TYPE_CHECKING

from . import _starting  # noqa: F401  (while all else is loaded)

# isort: split
from . import _load_core  # noqa: F401  (before anything that needs the core)

# isort: split
from . import (
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
    kernels,
    measured,
    operators,
    paths,
    rolling,
    shakedown,
    softening,
    surfaces,
    units,
    wear,
)
from ._core import ConvergenceError, GridTooSmallError
from ._core import version as __version__
from ._doubts import UnitWarning
from ._edges import SingularPressureWarning
from ._told import PlasticStrainWarning
from .accuracy import AccuracyWarning, Accurate, to_accuracy
from .contact import ContactSolver, GridTooSmallWarning
from .find import FoundLoad, find_load
from .friction import Coulomb
from .grid import Grid
from .grid_errors import GridErrors, estimate_errors
from .heat import Heat
from .increment_errors import IncrementErrors, IncrementWarning
from .layered import Layered
from .material import Material
from .relief import Relief
from .resolution import ElasticStrainWarning, ResolutionWarning
from .runs.file import CheckpointError
from .simulation import Simulation
from .solution import ContactSolution, RollingSolution, StickSlipSolution
from .state import State
from .sweeps import SweepInterrupted, sweep
from .track import Track
from .zone import Zone

__all__ = [
    "AccuracyWarning",
    "Accurate",
    "CheckpointError",
    "ContactSolution",
    "ContactSolver",
    "ConvergenceError",
    "Coulomb",
    "ElasticStrainWarning",
    "FoundLoad",
    "Grid",
    "GridErrors",
    "GridTooSmallError",
    "GridTooSmallWarning",
    "Heat",
    "IncrementErrors",
    "IncrementWarning",
    "Layered",
    "Material",
    "PlasticStrainWarning",
    "Relief",
    "ResolutionWarning",
    "RollingSolution",
    "Simulation",
    "SingularPressureWarning",
    "State",
    "StickSlipSolution",
    "SweepInterrupted",
    "Track",
    "UnitWarning",
    "Zone",
    "__version__",
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
    "kernels",
    "measured",
    "operators",
    "paths",
    "rolling",
    "shakedown",
    "softening",
    "surfaces",
    "sweep",
    "to_accuracy",
    "units",
    "wear",
]

if TYPE_CHECKING:
    from . import cases as cases
    from . import plotting as plotting
    from . import report as report
    from . import results as results
else:
    _ON_DEMAND = ("cases", "plotting", "report", "results")
    # they load libraries for files and figures, which a solution does not need

    def __getattr__(name):
        if name in _ON_DEMAND:
            return _import_module(f"{__name__}.{name}")
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

    def __dir__():
        return sorted({*globals(), *_ON_DEMAND})
