# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Callable, Sequence
from typing import Any

from ._util.checks import FloatArray

Box = tuple[int, int, int, int, int]
Floats = Sequence[float]
Heatings = list[Heating]
spin_lead: float
version: str

class ConvergenceError(RuntimeError):
    iterations: int
    residual: float

class GridTooSmallError(ValueError):
    axes: str

class Grid:
    nx: int
    ny: int
    nz: int
    dx: float
    dy: float
    dz: float
    def __init__(
        self, nx: int, ny: int, dx: float, dy: float, nz: int, dz: float, *along: bool
    ) -> None: ...
    def x(self) -> list[float]: ...
    def y(self) -> list[float]: ...
    def z(self, layers: int) -> list[float]: ...

class Elastic:
    E: float
    nu: float
    @staticmethod
    def isotropic(E: float, nu: float) -> Elastic: ...
    @staticmethod
    def rigid() -> Elastic: ...

class Heating:
    factor: float
    def __init__(
        self,
        factor: float = ...,
        conductivity: float = ...,
        expansion: float = ...,
        diffusivity: float = ...,
        speed_x: float = ...,
        speed_y: float = ...,
        age: float = ...,
        reference: float = ...,
        of_slip: bool = ...,
    ) -> None: ...

class LawParameter:
    name: str
    unit: str
    low: float
    high: float
    above_low: bool
    many: bool
    infinite: str | None

class LawDescription:
    name: str
    says: str
    yields: bool
    parameters: list[LawParameter]

def hardening_laws() -> list[LawDescription]: ...
def friction_laws() -> list[tuple[str, bool, list[LawParameter]]]: ...  # name, sticks, parameters

class Stack:
    def __init__(self, elastic: Elastic) -> None: ...
    def wave_compliance(self, wavenumbers: FloatArray) -> FloatArray: ...

class Material:
    elastic_constants: Elastic
    stack: Stack
    is_plastic: bool
    @staticmethod
    def rigid() -> Material: ...
    @staticmethod
    def with_law(E: float, nu: float, law: str, values: dict[str, list[float]]) -> Material: ...
    def with_thermal(
        self, conductivity: float, expansion: float, diffusivity: float
    ) -> Material: ...
    def with_backstresses(self, terms: list[tuple[float, float]]) -> Material: ...
    def with_yield_profile(self, z: Floats, factor: Floats) -> Material: ...
    def with_initial_stress(self, z: Floats, sxx: Floats, syy: Floats, sxy: Floats) -> Material: ...
    def yield_stress(self, g: FloatArray) -> FloatArray: ...
    def work(self, g: FloatArray) -> FloatArray: ...
    def uniaxial_stress(self, strain: list[float]) -> list[float]: ...
    def radial_return(
        self, stress: list[float], g: float, backstresses: list[list[float]]
    ) -> tuple[list[float], float, list[list[float]]]: ...
    def equivalent_increment(self, trial: float, g: float) -> float: ...

class Body:
    stack: Stack
    def __init__(self, substrate: Material, layers: list[tuple[Material, float]]) -> None: ...

class ContactLaw:
    attracts: bool
    def __init__(self, kind: str, parameters: list[float]) -> None: ...

class FrictionLaw:
    def __init__(self, name: str, values: dict[str, float]) -> None: ...
    def ratio(self, pressure: float) -> float: ...
    def bound(self, pressure: FloatArray) -> FloatArray: ...

class ContactSolver:
    def __init__(
        self,
        grid: Grid,
        body1: Stack,
        body2: Stack,
        friction: FrictionLaw,
        heating: Heatings,
        contact_law: ContactLaw,
    ) -> None: ...
    def solve(
        self,
        gap: FloatArray,
        load_driven: bool,
        value: float,
        initial_pressure: FloatArray | None,
        tol: float,
        max_iterations: int,
        error_on_border: bool,
    ) -> dict[str, Any]: ...  # fields of ContactSolution (operator_applications, work, ...)
    def shear(self, pressure: FloatArray) -> FloatArray | None: ...

def contact_outline(
    pressure: FloatArray, along_x: bool, along_y: bool, rise: float
) -> tuple[int, int, int, bool, float]: ...

class PartialSlipContact:
    def __init__(
        self, grid: Grid, body1: Stack, body2: Stack, friction: FrictionLaw, contact_law: ContactLaw
    ) -> None: ...
    is_coupled: bool
    def solve(
        self,
        gap: FloatArray,
        load_driven: bool,
        value: float,
        is_force: tuple[bool, bool, bool],
        tangential: tuple[float, float, float],
        previous_pressure: FloatArray | None,
        previous_shear: FloatArray | None,
        previous_gap: FloatArray | None,
        previous_approach: float,
        has_moved: bool,
        initial_pressure: FloatArray | None,
        tol: float,
        max_iterations: int,
        error_on_border: bool,
    ) -> dict[str, Any]: ...  # fields of StickSlipSolution, without totals
    def roll(
        self,
        gap: FloatArray,
        load_driven: bool,
        value: float,
        is_force: tuple[bool, bool, bool],
        tangential: tuple[float, float, float],
        initial_pressure: FloatArray | None,
        initial_shear: FloatArray | None,
        initial_creepage: tuple[float, float, float],
        tol: float,
        max_iterations: int,
        error_on_border: bool,
    ) -> dict[str, Any]: ...  # the same, per way rolled

class State:
    def __getattr__(self, name: str) -> Any: ...  # one of its content; None: there is none
    def content(self) -> dict[str, Any]: ...
    def widened(self, like: State) -> State: ...
    def tangential_force(self) -> tuple[float, float, float]: ...
    converged: bool
    warnings: list[str]
    origin: float
    offset: tuple[float, float]
    first_cell: tuple[int, int]
    def history_rows(self, body: int) -> tuple[int, int] | None: ...
    def residual_displacement_in(self, body: int, box: Box, axis: int) -> FloatArray: ...
    def residual_stress_in(self, body: int, box: Box) -> FloatArray: ...
    def initial_stress_in(self, body: int, box: Box) -> FloatArray: ...
    def yield_factor_in(self, body: int, box: Box) -> FloatArray: ...
    def plastic_strain_in(self, body: int, box: Box) -> FloatArray: ...
    def equivalent_plastic_strain_in(self, body: int, box: Box) -> FloatArray: ...
    def backstress_in(self, body: int, box: Box) -> FloatArray: ...
    def zones(self, body: int) -> list[Box]: ...
    def own_box(self, body: int) -> Box | None: ...
    def deviator_in_own_box(self, body: int, loaded: bool) -> FloatArray: ...
    def stress_in_zones(self, body: int, loaded: bool) -> FloatArray: ...
    def gap(self) -> FloatArray: ...
    def repulsion(self) -> FloatArray: ...
    def attraction_energy(self) -> float: ...
    def max_equivalent_plastic_strain(self, body: int) -> float: ...
    def max_plastic_strain_magnitude(self, body: int) -> float: ...
    def plastic_cells(self, body: int) -> int: ...
    def layers(self) -> int: ...
    def strain_beyond(self, body: int) -> Box | None: ...
    def stress(self, body: int, layers: int) -> FloatArray: ...
    def residual_stress(self, body: int, layers: int) -> FloatArray: ...
    def initial_stress(self, body: int, layers: int) -> FloatArray: ...
    def plastic_strain(self, body: int, layers: int) -> FloatArray: ...
    def equivalent_plastic_strain(self, body: int, layers: int) -> FloatArray: ...
    def backstress(self, body: int, layers: int) -> FloatArray: ...
    def temperature(self, body: int, layers: int) -> FloatArray: ...
    def surface_temperature(self, body: int) -> FloatArray: ...
    def softening(self, body: int) -> FloatArray | None: ...
    def relief(self, body: int) -> FloatArray: ...
    def residual_displacement(self, body: int, axis: int) -> FloatArray: ...
    def surface_displacement(self, body: int) -> FloatArray: ...

Planes = tuple[FloatArray, FloatArray]

class fatigue:
    dang_van: Callable[[FloatArray, float], FloatArray]
    crossland: Callable[[FloatArray, float], FloatArray]
    findley: Callable[[FloatArray, float], Planes]
    fatemi_socie: Callable[[FloatArray, FloatArray, float], Planes]

class Settings:
    def __init__(
        self,
        *,
        tol: float,
        increment_tol: float,
        max_iterations: int,
        on_border: str,
        residual_stress: str,
        image_tol: float,
        one_zone: bool,
        reach: int,
    ) -> None: ...

class Simulation:
    state: State
    counters: dict[str, int]
    def __init__(
        self,
        *,
        grid: Grid,
        body1: Material | Body,
        body2: Material | Body,
        gap: FloatArray,
        friction: FrictionLaw,
        settings: Settings,
        march: tuple[float, float],
        softening: list[Callable[[FloatArray], FloatArray] | None],
        reliefs: list[tuple[FloatArray, int, bool, FloatArray | None] | None],
        contact_law: ContactLaw,
    ) -> None: ...
    def step(
        self,
        kind: str,
        value: float,
        pressure: FloatArray | None,
        shear_x: FloatArray | None,
        shear_y: FloatArray | None,
        heating: Heatings,
        duration: float,
        advance: tuple[float, float],
        is_force: tuple[bool, bool, bool],
        tangential: tuple[float, float, float],
    ) -> State: ...
    def set_plastic_state(
        self,
        body: int,
        first_row: int,
        strain: FloatArray,
        equivalent: FloatArray | None,
        backstress: FloatArray | None,
    ) -> None: ...
    def add_eigenstrain(self, body: int, first: Sequence[int], strain: FloatArray) -> None: ...
    def restore(
        self, content: dict[str, Any], counters: dict[str, int], heating: Heatings
    ) -> None: ...
    def take_over(self, smaller: Simulation) -> None: ...
    def stand_at(self, state: State) -> None: ...

class kernels:
    @staticmethod
    def traction_displacement(
        traction: int,
        axis: int,
        X: FloatArray,
        Y: FloatArray,
        a: float,
        b: float,
        E: float,
        nu: float,
    ) -> FloatArray: ...
    @staticmethod
    def traction_stress(
        traction: int, X: FloatArray, Y: FloatArray, z: FloatArray, a: float, b: float, nu: float
    ) -> FloatArray: ...
    @staticmethod
    def eigenstrain_displacement(
        axis: int, X: FloatArray, Y: FloatArray, zc: float, a: float, b: float, c: float, nu: float
    ) -> FloatArray: ...
    @staticmethod
    def eigenstrain_stress(
        X: FloatArray,
        Y: FloatArray,
        z: FloatArray,
        zc: float,
        a: float,
        b: float,
        c: float,
        E: float,
        nu: float,
    ) -> FloatArray: ...
    @staticmethod
    def steady_heat_temperature(
        X: FloatArray, Y: FloatArray, z: FloatArray, a: float, b: float
    ) -> FloatArray: ...
    @staticmethod
    def steady_heat_stress(
        X: FloatArray, Y: FloatArray, z: FloatArray, a: float, b: float
    ) -> FloatArray: ...
    @staticmethod
    def steady_heat_displacement(
        X: FloatArray, Y: FloatArray, a: float, b: float, r0: float
    ) -> FloatArray: ...
    @staticmethod
    def heat_temperature(
        x: FloatArray,
        y: FloatArray,
        z: float,
        a: float,
        b: float,
        heated: float,
        speed: Floats,
        tol: float,
    ) -> FloatArray: ...
    @staticmethod
    def heat_displacement(
        x: FloatArray, y: FloatArray, a: float, b: float, heated: float, speed: Floats, tol: float
    ) -> FloatArray: ...
    @staticmethod
    def heat_stress(
        x: FloatArray,
        y: FloatArray,
        z: float,
        a: float,
        b: float,
        nu: float,
        heated: float,
        speed: Floats,
        tol: float,
    ) -> FloatArray: ...

class operators:
    class HeatHistory:
        size: int
        def __init__(
            self,
            grid: Grid,
            heating: Heating,
            elastic: Elastic,
            shortest: float,
            longest: float,
            tolerance: float,
            in_depth: bool,
        ) -> None: ...
        def add(self, flux: FloatArray, dt: float) -> None: ...
        def temperature(self, ahead: float, z: list[float]) -> FloatArray: ...
        def displacement(self, ahead: float) -> FloatArray: ...
        def stress(self, ahead: float, z: list[float]) -> FloatArray: ...
        def copy(self) -> operators.HeatHistory: ...
        def state(self) -> FloatArray: ...
        def set_state(self, state: FloatArray) -> None: ...

    @staticmethod
    def residual_stress(
        grid: Grid, strain: FloatArray, elastic: Elastic, exact: bool, image_tol: float
    ) -> FloatArray: ...
    @staticmethod
    def residual_displacement(
        grid: Grid, strain: FloatArray, nu: float, axis: int
    ) -> FloatArray: ...
    @staticmethod
    def surface_displacement(
        grid: Grid,
        body: Stack,
        pressure: FloatArray,
        shear_x: FloatArray | None,
        shear_y: FloatArray | None,
        axis: int,
    ) -> FloatArray: ...
    @staticmethod
    def surface_stress(
        grid: Grid,
        body: Stack,
        heating: Heating,
        z: list[float],
        pressure: FloatArray,
        shear_x: FloatArray | None,
        shear_y: FloatArray | None,
    ) -> FloatArray: ...
    @staticmethod
    def temperature(
        grid: Grid, heating: Heating, z: list[float], pressure: FloatArray
    ) -> FloatArray: ...
