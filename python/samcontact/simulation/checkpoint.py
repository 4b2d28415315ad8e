# SPDX-License-Identifier: GPL-3.0-or-later
"""Checkpoint files of simulations."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, astuple, fields
from typing import TYPE_CHECKING, Any

from .._util.short_text import in_short
from ..bodies.heterogeneous import Heterogeneous
from ..bodies.layered import Body
from ..bodies.layers import Layered
from ..bodies.material import Material
from ..heat import Heat
from ..problem import adhesion_laws
from ..problem.friction import friction_law, law_of
from ..problem.grid import Grid
from ..problem.moving_topography import Relief
from ..problem.settings import Settings
from ..restart.file import (
    CheckpointError,
    read,
    readable,
    write,
)
from ..restart.tree import Tree, array
from ..softening import JohnsonCook
from .inclusion_trees import body_of, is_heterogeneous, tree_of
from .snapshot import Snapshot

if TYPE_CHECKING:
    pass

KIND = "simulation"


def write_checkpoint(path: str | os.PathLike[str], kept: Snapshot, **more: Any) -> None:
    """Write a checkpoint file; if writing fails, an old file remains. more: further data."""
    tree = {"setup": _setup_tree(kept.arguments), "state": kept.state, "counters": kept.counters}
    write(path, KIND, tree | more)


def read_checkpoint(
    path: str | os.PathLike[str], softening: Sequence[Any]
) -> tuple[Snapshot, Tree]:
    """Read a checkpoint file; return the snapshot of the simulation, and all data of the file."""
    try:
        law1, law2 = softening
    except (TypeError, ValueError) as error:
        raise TypeError(
            f"softening must be a pair, (law of body 1, law of body 2), got {in_short(softening)}"
        ) from error
    tree = read(path, KIND)
    with readable(path):
        given = _arguments(tree["setup"], law1, law2)
        return Snapshot(given, tree["state"], tree["counters"]), tree


def _setup_tree(given: Mapping[str, Any]) -> Tree:
    """Convert the arguments of a simulation to a tree of plain data."""
    setup: Tree = {
        "grid": given["grid"].__getstate__(),
        "settings": {item.name: given[item.name] for item in fields(Settings)}
        | {
            "friction": friction_law(given["friction"]).to_tree(),
            "adhesion": given["adhesion"].to_tree(),
        },
        "heat": asdict(given["heat"]),
        "gap": given["gap"],
    }
    for name in ("body1", "body2"):
        setup[name] = _body_tree(given[name])
    for name in ("relief1", "relief2"):
        relief = given[name]
        if relief is not None:
            setup[name] = {item.name: getattr(relief, item.name) for item in fields(Relief)}
    return setup


def _body_tree(body: Body) -> Tree:
    if isinstance(body, Heterogeneous):
        return tree_of(body, _body_tree)
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
        "free_faces": None if body.free_faces is None else list(body.free_faces[:2]),
        "face_method": None if body.free_faces is None else body.free_faces[2],
        "relaxation_terms": None if body.relaxation_terms is None else list(body.relaxation_terms),
        "johnson_cook": astuple(law) if isinstance(law, JohnsonCook) else None,
        "softening": None if known or law is None else repr(law),
    }


def _arguments(setup: Tree, *laws: Any) -> dict[str, Any]:
    """Convert a tree of plain data back to the arguments of a simulation."""
    given: dict[str, Any] = dict(setup["settings"])
    known = {item.name: item.default for item in fields(Settings)}
    required = {name for name, default in known.items() if default is not None}
    if not required <= set(given) <= set(known):
        raise ValueError(
            "checkpoint must contain the settings that this version of samcontact knows and "
            f"requires, got {', '.join(given) or 'none'}"
        )
    given["friction"] = law_of(given["friction"])
    given["adhesion"] = adhesion_laws.law_of(given["adhesion"])
    given["heat"] = Heat(**setup["heat"])
    given["grid"] = Grid(**setup["grid"])
    for name, law in zip(("body1", "body2"), laws, strict=True):
        given[name] = _body(name, setup[name], law)
    given["gap"] = array(setup, "gap", given["grid"].surface_shape, may_end=True)
    for name in ("relief1", "relief2"):
        if name in setup:
            given[name] = Relief(**setup[name])
    return given


def _body(name: str, part: Tree, law: Any) -> Body:
    if is_heterogeneous(part):
        matrix = _matrix(name, part["matrix"], law)
        return body_of(part, lambda tree: _material(name, tree, None), matrix)
    return _matrix(name, part, law)


def _matrix(name: str, part: Tree, law: Any) -> Material | Layered:
    if part["law"] == Layered.law:
        parts = [part["layers"][n] for n in sorted(part["layers"], key=int)] + [part["substrate"]]
        laws = [None] * len(parts) if law is None else list(law)
        if len(laws) != len(parts):
            raise ValueError(
                f"softening of the layered {name} must be a list of {len(parts)} laws, from the "
                f"surface down, got {in_short(law)}"
            )
        *layers, substrate = map(_material, [name] * len(parts), parts, laws)
        return Layered(tuple(zip(layers, part["thickness"], strict=True)), substrate)
    return _material(name, part, law)


def _material(name: str, part: Tree, law: Any) -> Material:
    if "johnson_cook" in part:
        law = JohnsonCook(*part["johnson_cook"])
    elif "softening" in part and law is None:
        raise CheckpointError(
            f"{name} has the softening law {part['softening']}, which a checkpoint cannot store: "
            "pass softening=(law of body 1, law of body 2); use None for a body without a law, and "
            "a list of laws for a layered body"
        )
    kinematic = tuple(map(tuple, part.get("kinematic", ())))
    thermal, profile, stress = map(part.get, ("thermal", "yield_profile", "residual_stress"))
    faces = part.get("free_faces")
    ends = None if faces is None else (*map(float, faces), part["face_method"])
    constants = part["law"], part["parameters"], kinematic, thermal, law, profile, stress, ends
    return Material(*constants, part.get("relaxation_terms"))
