# SPDX-License-Identifier: GPL-3.0-or-later
"""A simulation as plain data: for its file, and for pickles and copies of it and its states."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, astuple, dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from .._util.short_text import in_short
from ..bodies.layered import Body, Layered
from ..bodies.material import Material
from ..heat import Heat
from ..restart.file import (
    DAMAGED,
    CheckpointError,
    ForeignCheckpointError,
    damaged,
    other_version,
    read,
    write,
)
from ..restart.tree import Tree, array
from ..scene.domain import Surfaces, Window, require_continued
from ..scene.friction import Coulomb
from ..scene.grid import Grid
from ..scene.heating import heating
from ..scene.moving_topography import Relief
from ..scene.settings import Settings
from ..softening import JohnsonCook

if TYPE_CHECKING:
    from ..solutions.state import State

_SCENE = ("body1", "body2", *(item.name for item in fields(Settings)))
"""Arguments of a simulation that are attributes of the same name and kind."""
KIND = "simulation"


class Standing(Protocol):
    """A simulation, as far as copies and checkpoints know it."""

    grid: Grid
    body1: Body
    body2: Body
    friction: float | Coulomb
    residual_stress: str
    _core: Any
    _heat: Heat
    _first: Window
    _window: Window
    _surfaces: Surfaces
    _told: Any
    _history: Any

    @property
    def state(self) -> State: ...

    @property
    def counters(self) -> dict[str, int]: ...

    @property
    def _over(self) -> Callable[[Grid], Window]: ...

    @property
    def _open(self) -> Callable[[Window, Callable[[Any], object]], None]: ...


Made = TypeVar("Made", bound=Standing)


class Moment(Protocol):
    """A state, as far as copies and checkpoints know it."""

    _core: Any
    _heat: Heat
    _window: Window


@dataclass(frozen=True)
class Snapshot:
    """All that makes a simulation again, standing where it stood."""

    arguments: dict[str, Any]
    """Of Simulation(...)."""
    state: Tree
    """Its parts, as the core describes them."""
    counters: dict[str, int]


def arguments(simulation: Standing, window: Window) -> dict[str, Any]:
    """Of Simulation(...) over a window of it, with the heat of the next increment."""
    given = {name: getattr(simulation, name) for name in _SCENE} | vars(window)
    return given | {"gap": given.pop("initial_gap"), "heat": simulation._heat}


def snapshot(simulation: Standing, state: Moment | None = None) -> Snapshot:
    """A simulation as it stands, or as it stood in an earlier state."""
    moment = simulation.state if state is None else state
    given = arguments(simulation, moment._window) | {"heat": moment._heat}
    return Snapshot(given, moment._core.content(), simulation.counters)


def resume(simulation: Standing, kept: Snapshot) -> None:
    """Make a simulation of the same scene stand as a snapshot tells, in its window."""
    simulation._history.forget()
    heat, state = kept.arguments["heat"], kept.state
    given, grid = kept.arguments, kept.arguments["grid"]
    window = simulation._window if simulation.grid == grid else simulation._over(grid)
    if not callable(given["gap"]):
        before = Window(grid, given["gap"], given.get("relief1"), given.get("relief2"))
        try:
            require_continued(window, before)
        except ValueError as error:
            raise ForeignCheckpointError(f"the checkpoint is of other surfaces: {error}") from error
    then = heat
    if heat.partition is None:
        then = replace(heat, factor=[state["heat_factor1"], state["heat_factor2"]])
    entries = heating(then, (simulation.body1, simulation.body2), grid)
    if window is simulation._window:
        simulation._core.restore(state, kept.counters, entries)
    else:
        simulation._open(window, lambda core: core.restore(state, kept.counters, entries))
    simulation._heat = heat


def stand_at(simulation: Standing, state: Moment) -> None:
    """Take a simulation back to an earlier state of it."""
    simulation._history.forget()
    simulation._core.stand_at(state._core)
    simulation._heat = state._heat


def restored(cls: type[Made], kept: Snapshot) -> Made:
    """A simulation that stands as a snapshot tells."""
    simulation = cls(**kept.arguments)
    resume(simulation, kept)
    return simulation


def reduced(simulation: Standing) -> tuple[Any, ...]:
    """What a pickle or copy of a simulation is made of; functions stay what they are."""
    kept, surfaces = snapshot(simulation), vars(simulation._surfaces)
    functions = {name: shape for name, shape in surfaces.items() if callable(shape)}
    told = {name: getattr(simulation, name) for name in ("_told", "_first")}
    kept = replace(kept, arguments=kept.arguments | functions)
    return restored, (type(simulation), kept), told


def restored_state(cls: type[Any], kept: Snapshot) -> Any:
    """The state of it."""
    return restored(cls, kept).state


def loaded(
    cls: type[Made], path: str | os.PathLike[str], softening: Sequence[Any], gap: Any = None
) -> Made:
    """The simulation of a file; gap: a function that is the one in it."""
    kept, tree = read_checkpoint(path, softening)
    if told := other_version(path, tree):
        warnings.warn(f"{told}: further increments may differ in their last digits", stacklevel=3)
    try:
        simulation = cls(**kept.arguments | ({} if gap is None else {"gap": gap}))
        resume(simulation, kept)
        return simulation
    except CheckpointError:
        raise
    except DAMAGED as error:
        raise damaged(path, error) from error


def write_checkpoint(path: str | os.PathLike[str], kept: Snapshot, **more: Any) -> None:
    """A failure leaves the old file. more: trees that go with it."""
    tree = {"scene": _scene(kept.arguments), "state": kept.state, "counters": kept.counters}
    write(path, KIND, tree | more)


def read_checkpoint(
    path: str | os.PathLike[str], softening: Sequence[Any]
) -> tuple[Snapshot, Tree]:
    """A snapshot, and all trees of the file."""
    try:
        law1, law2 = softening
    except (TypeError, ValueError) as error:
        raise TypeError(
            f"softening must be a pair, (law of body 1, law of body 2), got {in_short(softening)}"
        ) from error
    tree = read(path, KIND)
    try:
        given = _arguments(tree["scene"], law1, law2)
        return Snapshot(given, tree["state"], tree["counters"]), tree
    except CheckpointError:
        raise
    except DAMAGED as error:
        raise damaged(path, error) from error


def _scene(given: Mapping[str, Any]) -> Tree:
    """The arguments of a simulation as a tree."""
    scene: Tree = {
        "grid": given["grid"].__getstate__(),
        "settings": {item.name: given[item.name] for item in fields(Settings)} | _law(given),
        "heat": asdict(given["heat"]),
        "gap": given["gap"],
    }
    for name in ("body1", "body2"):
        scene[name] = _body_tree(given[name])
    for name in ("relief1", "relief2"):
        relief = given[name]
        if relief is not None:
            scene[name] = {item.name: getattr(relief, item.name) for item in fields(Relief)}
    return scene


def _body_tree(body: Body) -> Tree:
    if isinstance(body, Layered):
        layers = {str(n): _body_tree(material) for n, (material, _) in enumerate(body.layers)}
        thickness = [h for _, h in body.layers]
        below = _body_tree(body.substrate)
        return {"law": body.law, "layers": layers, "thickness": thickness, "substrate": below}
    law, known = body.softening, isinstance(body.softening, JohnsonCook)
    return {
        "law": body.law,
        "parameters": dict(body.parameters),
        "kinematic": body.kinematic or None,
        "thermal": body.thermal,
        "yield_profile": body.yield_profile,
        "residual_stress": body.residual_stress,
        "johnson_cook": astuple(law) if isinstance(law, JohnsonCook) else None,
        "softening": None if known or law is None else repr(law),
    }


def _law(given: Mapping[str, Any]) -> Tree:
    """Of friction."""
    friction = given["friction"]
    sticks = isinstance(friction, Coulomb)
    return {"friction": friction.coefficient if sticks else friction, "stick_and_slip": sticks}


def _arguments(scene: Tree, *laws: Any) -> dict[str, Any]:
    """The reverse."""
    given: dict[str, Any] = dict(scene["settings"])
    known = {item.name: item.default for item in fields(Settings)} | {"stick_and_slip": False}
    required = {name for name, default in known.items() if default is not None}
    if not required <= set(given) <= set(known):
        raise ValueError(f"its settings are {', '.join(given) or 'missing'}")
    if given.pop("stick_and_slip"):
        given["friction"] = Coulomb(given["friction"])
    given["heat"] = Heat(**scene["heat"])
    given["grid"] = Grid(**scene["grid"])
    for name, law in zip(("body1", "body2"), laws, strict=True):
        given[name] = _body(name, scene[name], law)
    given["gap"] = array(scene, "gap", given["grid"].surface_shape, may_end=True)
    for name in ("relief1", "relief2"):
        if name in scene:
            given[name] = Relief(**scene[name])
    return given


def _body(name: str, part: Tree, law: Any) -> Body:
    if part["law"] == Layered.law:
        layers = [_material(name, part["layers"][n], None) for n in sorted(part["layers"], key=int)]
        substrate = _material(name, part["substrate"], None)
        return Layered(tuple(zip(layers, part["thickness"], strict=True)), substrate)
    return _material(name, part, law)


def _material(name: str, part: Tree, law: Any) -> Material:
    if "johnson_cook" in part:
        law = JohnsonCook(*part["johnson_cook"])
    elif "softening" in part and law is None:
        raise CheckpointError(
            f"{name} softens by {part['softening']}, which a checkpoint cannot hold: "
            "give it again, softening=(law of body 1, law of body 2), None for a body without"
        )
    kinematic = tuple(map(tuple, part.get("kinematic", ())))
    thermal, profile, stress = map(part.get, ("thermal", "yield_profile", "residual_stress"))
    return Material(part["law"], part["parameters"], kinematic, thermal, law, profile, stress)
