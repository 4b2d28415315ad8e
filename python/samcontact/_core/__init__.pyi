# SPDX-License-Identifier: GPL-3.0-or-later
# Written by: python scripts/stubs.py
"""
C++ core of samcontact; use the package samcontact instead.
"""

from __future__ import annotations

import collections.abc
import typing

import numpy
import numpy.typing

from . import fatigue, kernels, operators

__all__: list[str] = [
    "Body",
    "ContactLaw",
    "ContactSolver",
    "ConvergenceError",
    "CreepingContact",
    "CreepingTractions",
    "Drive",
    "Elastic",
    "FilmSolver",
    "FrictionLaw",
    "Grid",
    "GridTooSmallError",
    "Heating",
    "LawDescription",
    "LawParameter",
    "LubricantTable",
    "Material",
    "MovingCreep",
    "PartialSlipContact",
    "PullOffError",
    "Settings",
    "Simulation",
    "Stack",
    "State",
    "contact_outline",
    "fatigue",
    "film_outflow",
    "friction_laws",
    "hardening_laws",
    "kernels",
    "magnitude_of",
    "may_have_steps",
    "operators",
    "paraboloid_of",
    "self_influence",
    "spin_lead",
    "version",
]

class ConvergenceError(RuntimeError):
    """
    Error of an iteration that did not reach its tolerance; see `iterations` and `residual`.
    The previous state is kept.
    """

    iterations: int
    residual: float

class PullOffError(ConvergenceError):
    """
    Error of a load whose tension exceeds the largest tension that adhesion allows.
    `pull_off` is the largest tension reached [N]; `approach` is the approach there [m].
    """

    approach: float
    pull_off: float

class GridTooSmallError(ValueError):
    """
    Error of a contact that reaches the edge of the grid.
    `axes` names the directions to enlarge: x, y or xy.
    """

    axes: str

class LawParameter:
    @property
    def above_low(self) -> bool: ...
    @property
    def high(self) -> float: ...
    @property
    def infinite(self) -> str | None: ...
    @property
    def low(self) -> float: ...
    @property
    def many(self) -> bool: ...
    @property
    def name(self) -> str: ...
    @property
    def unit(self) -> str: ...

class Grid:
    def __init__(
        self,
        nx: int,
        ny: int,
        dx: float,
        dy: float,
        nz: int,
        dz: float,
        along_x: bool = False,
        along_y: bool = False,
    ) -> None: ...
    def x(self) -> list[float]: ...
    def y(self) -> list[float]: ...
    def z(self, layers: int) -> list[float]: ...
    @property
    def dx(self) -> float: ...
    @property
    def dy(self) -> float: ...
    @property
    def dz(self) -> float: ...
    @property
    def nx(self) -> int: ...
    @property
    def ny(self) -> int: ...
    @property
    def nz(self) -> int: ...

class LawDescription:
    @property
    def name(self) -> str: ...
    @property
    def parameters(self) -> list[LawParameter]: ...
    @property
    def says(self) -> str: ...
    @property
    def yields(self) -> bool: ...

class Elastic:
    @staticmethod
    def isotropic(E: float, nu: float) -> Elastic: ...
    @staticmethod
    def rigid() -> Elastic: ...
    @property
    def E(self) -> float: ...
    @property
    def nu(self) -> float: ...

class Stack:
    def __eq__(self, arg0: typing.Any) -> bool: ...
    def __init__(self, elastic: Elastic) -> None: ...
    def wave_compliance(
        self, wavenumbers: numpy.typing.NDArray[numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64]: ...

class Material:
    @staticmethod
    def rigid() -> Material: ...
    @staticmethod
    def with_law(
        E: float,
        nu: float,
        law: str,
        values: collections.abc.Mapping[str, collections.abc.Sequence[float]],
    ) -> Material: ...
    def equivalent_increment(self, trial: float, g: float) -> float: ...
    def radial_return(
        self,
        stress: typing.Annotated[collections.abc.Sequence[float], "FixedSize(6)"],
        g: float,
        backstresses: collections.abc.Sequence[
            typing.Annotated[collections.abc.Sequence[float], "FixedSize(6)"]
        ],
    ) -> tuple[
        typing.Annotated[list[float], "FixedSize(6)"],
        float,
        list[typing.Annotated[list[float], "FixedSize(6)"]],
    ]: ...
    def uniaxial_stress(self, strain: collections.abc.Sequence[float]) -> list[float]: ...
    def with_backstresses(
        self, terms: collections.abc.Sequence[tuple[float, float]]
    ) -> Material: ...
    def with_free_faces(self, low: float, high: float, exact: bool) -> Material: ...
    def with_initial_stress(
        self,
        z: collections.abc.Sequence[float],
        sxx: collections.abc.Sequence[float],
        syy: collections.abc.Sequence[float],
        sxy: collections.abc.Sequence[float],
    ) -> Material: ...
    def with_relaxation(
        self, times: collections.abc.Sequence[float], shares: collections.abc.Sequence[float]
    ) -> Material: ...
    def with_thermal(
        self, conductivity: float, expansion: float, diffusivity: float
    ) -> Material: ...
    def with_yield_profile(
        self, z: collections.abc.Sequence[float], factor: collections.abc.Sequence[float]
    ) -> Material: ...
    def work(
        self, g: numpy.typing.NDArray[numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def yield_stress(
        self, g: numpy.typing.NDArray[numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    @property
    def elastic_constants(self) -> Elastic: ...
    @property
    def is_plastic(self) -> bool: ...
    @property
    def stack(self) -> Stack: ...

class Body:
    @typing.overload
    def __init__(self, substrate: Material) -> None: ...
    @typing.overload
    def __init__(
        self, substrate: Material, layers: collections.abc.Sequence[tuple[Material, float]]
    ) -> None: ...
    @property
    def stack(self) -> Stack: ...

class Heating:
    @typing.overload
    def __init__(self) -> None: ...
    @typing.overload
    def __init__(
        self,
        factor: float,
        thermal: collections.abc.Sequence[
            typing.Annotated[collections.abc.Sequence[float], "FixedSize(3)"]
        ],
        thickness: collections.abc.Sequence[float],
        speed_x: float,
        speed_y: float,
        age: float,
        reference: float,
        of_slip: bool,
        period: tuple[float, float] = (0.0, 0.0),
    ) -> None: ...
    @property
    def factor(self) -> float: ...

class FrictionLaw:
    def __init__(
        self, name: str, values: collections.abc.Mapping[str, collections.abc.Sequence[float]]
    ) -> None: ...
    def bound(
        self, pressure: numpy.typing.NDArray[numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def ratio(self, pressure: float) -> float: ...

class ContactLaw:
    def __init__(
        self,
        kind: str,
        parameters: collections.abc.Sequence[float],
        rubs_by_compression: bool = False,
    ) -> None: ...
    @property
    def attracts(self) -> bool: ...
    @property
    def largest_attraction(self) -> float: ...
    @property
    def steepest_fall(self) -> float: ...
    @property
    def work(self) -> float: ...

class Drive:
    def __init__(
        self,
        is_load: bool,
        value: float,
        is_moment: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(2)"],
        tilt: typing.Annotated[collections.abc.Sequence[float], "FixedSize(2)"],
        spring: float = 0.0,
    ) -> None: ...

class ContactSolver:
    def __init__(
        self,
        grid: Grid,
        body1: Body,
        body2: Body,
        friction: FrictionLaw,
        heating: typing.Annotated[collections.abc.Sequence[Heating], "FixedSize(2)"],
        contact_law: ContactLaw,
    ) -> None: ...
    def shear(
        self, pressure: numpy.typing.NDArray[numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64] | None: ...
    def solve(
        self,
        gap: numpy.typing.NDArray[numpy.float64],
        drive: Drive,
        initial_pressure: numpy.typing.NDArray[numpy.float64] | None,
        tol: float,
        max_iterations: int,
        error_on_border: bool,
    ) -> dict[str, typing.Any]: ...

class MovingCreep:
    def __init__(
        self,
        amounts: collections.abc.Sequence[float],
        distances: collections.abc.Sequence[float],
        towards_plus_x: bool,
    ) -> None: ...

class CreepingTractions:
    def __init__(
        self, grid: Grid, body1: Body, body2: Body, creep1: MovingCreep, creep2: MovingCreep
    ) -> None: ...
    def displacement(
        self,
        pressure: numpy.typing.NDArray[numpy.float64],
        shear: numpy.typing.NDArray[numpy.float64],
    ) -> numpy.typing.NDArray[numpy.float64]: ...

class CreepingContact:
    def __init__(
        self, grid: Grid, body1: Body, body2: Body, creep1: MovingCreep, creep2: MovingCreep
    ) -> None: ...
    def displacement(
        self, pressure: numpy.typing.NDArray[numpy.float64]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def solve(
        self,
        gap: numpy.typing.NDArray[numpy.float64],
        drive: Drive,
        initial_pressure: numpy.typing.NDArray[numpy.float64] | None,
        tol: float,
        max_iterations: int,
        error_on_border: bool,
    ) -> dict[str, typing.Any]: ...

class PartialSlipContact:
    def __init__(
        self, grid: Grid, body1: Body, body2: Body, friction: FrictionLaw, contact_law: ContactLaw
    ) -> None: ...
    def roll(
        self,
        gap: numpy.typing.NDArray[numpy.float64],
        drive: Drive,
        is_force: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(3)"],
        tangential: typing.Annotated[collections.abc.Sequence[float], "FixedSize(3)"],
        initial_pressure: numpy.typing.NDArray[numpy.float64] | None,
        initial_shear: numpy.typing.NDArray[numpy.float64] | None,
        initial_creepage: typing.Annotated[collections.abc.Sequence[float], "FixedSize(3)"],
        tol: float,
        max_iterations: int,
        error_on_border: bool,
        accept_stall: bool,
        duration: float = 0.0,
        displacement: numpy.typing.NDArray[numpy.float64] | None = None,
    ) -> dict[str, typing.Any]: ...
    def solve(
        self,
        gap: numpy.typing.NDArray[numpy.float64],
        drive: Drive,
        is_force: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(3)"],
        tangential: typing.Annotated[collections.abc.Sequence[float], "FixedSize(3)"],
        previous_pressure: numpy.typing.NDArray[numpy.float64] | None,
        previous_shear: numpy.typing.NDArray[numpy.float64] | None,
        previous_gap: numpy.typing.NDArray[numpy.float64] | None,
        previous_approach: float,
        previous_tilt: typing.Annotated[collections.abc.Sequence[float], "FixedSize(2)"],
        has_moved: bool,
        initial_pressure: numpy.typing.NDArray[numpy.float64] | None,
        tol: float,
        max_iterations: int,
        error_on_border: bool,
        accept_stall: bool,
        duration: float = 0.0,
        slip_rate: numpy.typing.NDArray[numpy.float64] | None = None,
        selects: bool = False,
        plastic_slip: numpy.typing.NDArray[numpy.float64] | None = None,
    ) -> dict[str, typing.Any]: ...
    @property
    def is_coupled(self) -> bool: ...

class State:
    def attraction_energy(self) -> float: ...
    def backstress(self, body: int, layers: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def backstress_in(
        self, body: int, box: typing.Annotated[collections.abc.Sequence[int], "FixedSize(5)"]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def content(self) -> dict[str, typing.Any]: ...
    def deviator_in_own_box(
        self, body: int, loaded: bool
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def disturbance(self, body: int, layers: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def eigenstrain(self, body: int, layers: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def eigenstrain_in(
        self, body: int, box: typing.Annotated[collections.abc.Sequence[int], "FixedSize(5)"]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def eigenstress(self, body: int, layers: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def eigenstress_in(
        self, body: int, box: typing.Annotated[collections.abc.Sequence[int], "FixedSize(5)"]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def equivalent_plastic_strain(
        self, body: int, layers: int
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def equivalent_plastic_strain_in(
        self, body: int, box: typing.Annotated[collections.abc.Sequence[int], "FixedSize(5)"]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def equivalent_pressure(self, body: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def gap(self) -> numpy.typing.NDArray[numpy.float64]: ...
    def has_eigenstrain(self, body: int) -> bool: ...
    def history_rows(self, body: int) -> tuple[int, int] | None: ...
    def inclusion_equivalent_strain(
        self, body: int, layers: int
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def inclusion_plastic_strain(
        self, body: int, layers: int
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def initial_stress(self, body: int, layers: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def initial_stress_in(
        self, body: int, box: typing.Annotated[collections.abc.Sequence[int], "FixedSize(5)"]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def layers(self) -> int: ...
    def matrix_plastic_strain(
        self, body: int, layers: int
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def max_equivalent_plastic_strain(self, body: int) -> float: ...
    def max_plastic_strain_magnitude(self, body: int) -> float: ...
    def moment(self) -> typing.Annotated[list[float], "FixedSize(2)"]: ...
    def own_box(self, body: int) -> typing.Annotated[list[int], "FixedSize(5)"] | None: ...
    def plastic_cells(self, body: int) -> int: ...
    def plastic_strain(self, body: int, layers: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def plastic_strain_in(
        self, body: int, box: typing.Annotated[collections.abc.Sequence[int], "FixedSize(5)"]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def relief(self, body: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def repulsion(self) -> numpy.typing.NDArray[numpy.float64]: ...
    def residual_displacement(
        self, body: int, axis: int
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def residual_displacement_in(
        self,
        body: int,
        box: typing.Annotated[collections.abc.Sequence[int], "FixedSize(5)"],
        axis: int,
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def residual_stress(self, body: int, layers: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def residual_stress_in(
        self, body: int, box: typing.Annotated[collections.abc.Sequence[int], "FixedSize(5)"]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def softening(self, body: int) -> numpy.typing.NDArray[numpy.float64] | None: ...
    def strain_beyond(self, body: int) -> typing.Annotated[list[int], "FixedSize(5)"] | None: ...
    def stress(self, body: int, layers: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def stress_in_zones(self, body: int, loaded: bool) -> numpy.typing.NDArray[numpy.float64]: ...
    def surface_displacement(self, body: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def surface_temperature(self, body: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def tangential_force(self) -> typing.Annotated[list[float], "FixedSize(3)"]: ...
    def temperature(self, body: int, layers: int) -> numpy.typing.NDArray[numpy.float64]: ...
    def viscous_work(self, body: int) -> float: ...
    def widened(self, like: State) -> State: ...
    def yield_factor_in(
        self, body: int, box: typing.Annotated[collections.abc.Sequence[int], "FixedSize(5)"]
    ) -> numpy.typing.NDArray[numpy.float64]: ...
    def zones(self, body: int) -> list[typing.Annotated[list[int], "FixedSize(5)"]]: ...
    @property
    def approach(self) -> float: ...
    @property
    def contact_gap(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def contact_iterations(self) -> int: ...
    @property
    def converged(self) -> bool: ...
    @property
    def duration(self) -> float: ...
    @property
    def eigenstrain1(self) -> dict[str, typing.Any] | None: ...
    @property
    def eigenstrain2(self) -> dict[str, typing.Any] | None: ...
    @property
    def falling_number(self) -> float: ...
    @property
    def far_effect1(self) -> dict[str, typing.Any] | None: ...
    @property
    def far_effect2(self) -> dict[str, typing.Any] | None: ...
    @property
    def first_cell(self) -> typing.Annotated[list[int], "FixedSize(2)"]: ...
    @property
    def flow_boxes1(self) -> numpy.typing.NDArray[numpy.int64] | None: ...
    @property
    def flow_boxes2(self) -> numpy.typing.NDArray[numpy.int64] | None: ...
    @property
    def friction_work(self) -> float: ...
    @property
    def heat_factor1(self) -> float: ...
    @property
    def heat_factor2(self) -> float: ...
    @property
    def heat_speed1(self) -> float: ...
    @property
    def heat_speed2(self) -> float: ...
    @property
    def history1(self) -> dict[str, typing.Any] | None: ...
    @property
    def history2(self) -> dict[str, typing.Any] | None: ...
    @property
    def inclusions_flow1(self) -> dict[str, typing.Any] | None: ...
    @property
    def inclusions_flow2(self) -> dict[str, typing.Any] | None: ...
    @property
    def iterations(self) -> int: ...
    @property
    def joint_steps(self) -> int: ...
    @property
    def largest_mismatch(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def last_flow(self) -> dict[str, typing.Any] | None: ...
    @property
    def lateral_heat_speed1(self) -> float: ...
    @property
    def lateral_heat_speed2(self) -> float: ...
    @property
    def lateral_travel(self) -> typing.Annotated[list[float], "FixedSize(2)"]: ...
    @property
    def load(self) -> float: ...
    @property
    def matrix_flow1(self) -> dict[str, typing.Any] | None: ...
    @property
    def matrix_flow2(self) -> dict[str, typing.Any] | None: ...
    @property
    def motion(self) -> typing.Annotated[list[float], "FixedSize(3)"]: ...
    @property
    def offset(self) -> typing.Annotated[list[float], "FixedSize(2)"]: ...
    @property
    def origin(self) -> float: ...
    @property
    def past1(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def past2(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def past_symmetry(self) -> int: ...
    @property
    def plastic_residual(self) -> float: ...
    @property
    def plastic_slip(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def pressure(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def residual_method(self) -> int: ...
    @property
    def shear_symmetry(self) -> int: ...
    @property
    def shear_x(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def shear_y(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def slip(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def slip_power(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def slip_rate(self) -> numpy.typing.NDArray[numpy.float64] | None: ...
    @property
    def softening1(self) -> dict[str, typing.Any] | None: ...
    @property
    def softening2(self) -> dict[str, typing.Any] | None: ...
    @property
    def stall_warning(self) -> str: ...
    @property
    def substeps(self) -> int: ...
    @property
    def tilt(self) -> typing.Annotated[list[float], "FixedSize(2)"]: ...
    @property
    def time(self) -> float: ...
    @property
    def traction_memory1(self) -> dict[str, typing.Any] | None: ...
    @property
    def traction_memory2(self) -> dict[str, typing.Any] | None: ...
    @property
    def travel(self) -> typing.Annotated[list[float], "FixedSize(2)"]: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def yield_excess(self) -> float: ...

class Settings:
    def __init__(
        self,
        *,
        tol: float,
        increment_tol: float,
        max_iterations: int,
        on_border: str,
        on_stall: str,
        residual_stress: str,
        image_tol: float,
        one_zone: bool,
        reach: int,
    ) -> None: ...

class Simulation:
    def __init__(
        self,
        *,
        grid: Grid,
        body1: Body,
        body2: Body,
        gap: numpy.typing.NDArray[numpy.float64],
        friction: FrictionLaw,
        settings: Settings,
        march: typing.Annotated[collections.abc.Sequence[float], "FixedSize(4)"],
        softening: typing.Annotated[
            collections.abc.Sequence[
                collections.abc.Callable[
                    [numpy.typing.NDArray[numpy.float64]], numpy.typing.NDArray[numpy.float64]
                ]
                | None
            ],
            "FixedSize(2)",
        ],
        reliefs: typing.Annotated[
            collections.abc.Sequence[
                tuple[
                    numpy.typing.NDArray[numpy.float64],
                    int,
                    bool,
                    numpy.typing.NDArray[numpy.float64] | None,
                ]
                | None
            ],
            "FixedSize(2)",
        ],
        contact_law: ContactLaw,
        inclusions: typing.Annotated[
            collections.abc.Sequence[
                tuple[
                    typing.Annotated[collections.abc.Sequence[int], "FixedSize(3)"],
                    numpy.typing.NDArray[numpy.int32],
                    numpy.typing.NDArray[numpy.float64],
                    collections.abc.Sequence[Material],
                ]
                | None
            ],
            "FixedSize(2)",
        ],
    ) -> None: ...
    def add_eigenstrain(
        self,
        body: int,
        first: typing.Annotated[collections.abc.Sequence[int], "FixedSize(3)"],
        strain: numpy.typing.NDArray[numpy.float64],
    ) -> None: ...
    def restore(
        self,
        content: dict[str, typing.Any],
        counters: dict[str, typing.Any],
        heating: typing.Annotated[collections.abc.Sequence[Heating], "FixedSize(2)"],
    ) -> None: ...
    def set_plastic_state(
        self,
        body: int,
        first_row: int,
        strain: numpy.typing.NDArray[numpy.float64],
        equivalent: numpy.typing.NDArray[numpy.float64] | None,
        backstress: numpy.typing.NDArray[numpy.float64] | None,
    ) -> None: ...
    def stand_at(self, state: State) -> None: ...
    def step(
        self,
        drive: Drive,
        pressure: numpy.typing.NDArray[numpy.float64] | None,
        shear_x: numpy.typing.NDArray[numpy.float64] | None,
        shear_y: numpy.typing.NDArray[numpy.float64] | None,
        heating: typing.Annotated[collections.abc.Sequence[Heating], "FixedSize(2)"],
        duration: float,
        advance: typing.Annotated[
            collections.abc.Sequence[
                typing.Annotated[collections.abc.Sequence[float], "FixedSize(2)"]
            ],
            "FixedSize(2)",
        ],
        is_force: typing.Annotated[collections.abc.Sequence[bool], "FixedSize(3)"],
        tangential: typing.Annotated[collections.abc.Sequence[float], "FixedSize(3)"],
        lasts: float,
    ) -> State: ...
    def take_over(self, smaller: Simulation) -> None: ...
    @property
    def counters(self) -> dict[str, typing.Any]: ...
    @property
    def state(self) -> State: ...
    @property
    def tilt(self) -> typing.Annotated[list[float], "FixedSize(2)"]: ...

class LubricantTable:
    def __init__(
        self,
        scale: float,
        step: float,
        reduced: numpy.typing.NDArray[numpy.float64],
        fluidity: numpy.typing.NDArray[numpy.float64],
        density: numpy.typing.NDArray[numpy.float64],
        density_slope: numpy.typing.NDArray[numpy.float64],
    ) -> None: ...
    def at(self, pressure: float) -> tuple[float, float, float, float]: ...
    @property
    def largest_pressure(self) -> float: ...

class FilmSolver:
    def __init__(self, grid: Grid, body1: Body, body2: Body) -> None: ...
    def solve(
        self,
        lubricant: LubricantTable,
        gap: numpy.typing.NDArray[numpy.float64],
        is_load: bool,
        target: float,
        along_x: numpy.typing.NDArray[numpy.float64],
        along_y: numpy.typing.NDArray[numpy.float64],
        order: int,
        supply: float,
        thinnest: float,
        layer: tuple[float, float],
        start: dict[str, typing.Any],
        tol: float,
        max_iterations: int,
        time: tuple[float, float] = (0.0, 1.0),
        content: numpy.typing.NDArray[numpy.float64] | None = None,
        pressure_flow: collections.abc.Sequence[numpy.typing.NDArray[numpy.float64]] = [],
        order_change: tuple[float, float] = (4.0, 20.0),
    ) -> dict[str, typing.Any]: ...

def contact_outline(
    pressure: numpy.typing.NDArray[numpy.float64], along_x: bool, along_y: bool, rise: float
) -> tuple[int, int, int, bool, float]: ...
def film_outflow(
    grid: Grid,
    lubricant: LubricantTable,
    along_x: numpy.typing.NDArray[numpy.float64],
    along_y: numpy.typing.NDArray[numpy.float64],
    order: int,
    supply: float,
    layer: float,
    fields: collections.abc.Sequence[numpy.typing.NDArray[numpy.float64]],
    pressure_flow: collections.abc.Sequence[numpy.typing.NDArray[numpy.float64]] = [],
) -> numpy.typing.NDArray[numpy.float64]: ...
def friction_laws() -> list[tuple[str, bool, list[LawParameter]]]: ...
def hardening_laws() -> list[LawDescription]: ...
def magnitude_of(numbers: numpy.typing.NDArray[numpy.float64]) -> tuple[float, bool]: ...
def may_have_steps(
    heights: numpy.typing.NDArray[numpy.float64], along_x: bool, along_y: bool, ratio: float
) -> bool: ...
def paraboloid_of(
    gap: numpy.typing.NDArray[numpy.float64], grid: Grid, on_grid: float, at_reach: float
) -> tuple[float, float, float, tuple[float, float]] | None: ...
def self_influence(grid: Grid, body1: Body, body2: Body) -> float: ...

spin_lead: float
version: str
