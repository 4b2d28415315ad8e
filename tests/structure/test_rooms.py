# SPDX-License-Identifier: GPL-3.0-or-later
"""Order of the rooms of the core, as data, and documentation of all public objects."""

import graphlib
import inspect
import os
import re
import subprocess
import sys
from functools import cache
from pathlib import Path
from types import ModuleType

import pytest

import samcontact as sc
from samcontact._util.cached_property import cached_property

ROOT = Path(__file__).parents[2]
INCLUDE = ROOT / "cpp" / "include"
HEADERS = sorted(INCLUDE.rglob("*.hpp"))
SOURCES = sorted((ROOT / "cpp" / "src").rglob("*.cpp"))
BINDINGS = sorted((ROOT / "cpp" / "bindings").glob("*.?pp"))
PACKAGE = ROOT / "python" / "samcontact"
MODULES = sorted(PACKAGE.rglob("*.py"))

# Rooms that each room may include.
BELOW = {
    "base": set(),
    "fatigue": {"base"},
    "kernels": {"base"},
    "fft": {"base"},
    "plasticity": {"base"},
    "operators": {"base", "kernels", "fft", "plasticity"},
    "contact": {"base", "kernels", "fft", "operators"},
    "film": {"base", "kernels", "fft", "operators", "contact"},
    "simulation": {"base", "kernels", "fft", "operators", "plasticity", "contact"},
}


# Parts within divided rooms; "" is the room itself, above all its parts.
DIVIDED = {
    "operators": {
        "influence": set(),
        "convolution": set(),
        "periodic": {"influence", "convolution"},
        "heat": {"influence", "convolution"},
        "residual": {"influence", "convolution", "periodic"},
        "medium": {"influence", "convolution", "periodic", "heat", "residual"},
        "volume": {"influence", "convolution", "heat", "medium"},
        "surface": {"influence", "convolution", "heat", "medium"},
        "zones": {"influence", "convolution", "heat", "residual", "medium", "volume"},
    },
    "contact": {
        "laws": set(),
        "iteration": set(),
        "normal": {"laws", "iteration"},
        "tangential": {"laws", "iteration", "normal"},
        "joint": {"laws", "iteration", "normal", "tangential"},
        "": {"laws", "iteration", "normal", "tangential", "joint"},
    },
    "simulation": {
        "cells": set(),
        "setup": {"cells"},
        "strain": {"cells", "setup"},
        "sources": {"cells", "setup", "strain"},
        "state": {"cells", "setup", "strain", "sources"},
        "body": {"cells", "setup", "strain", "sources", "state"},
        "increment": {"cells", "setup", "strain", "sources", "state", "body"},
        "": {"cells", "setup", "strain", "sources", "state", "body", "increment"},
    },
}


def place(file):
    """Return the room of a header or source and its part, "" if the room is not divided."""
    parts = file.parts[max(n for n, part in enumerate(file.parts) if part in BELOW) : -1]
    return parts[0], "/".join(parts[1:])


def room(file):
    return place(file)[0]


def includes(file):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', file.read_text(), re.MULTILINE)


def own(file):
    """Return the headers of the core included by a file, as paths below cpp/include."""
    return [name for name in includes(file) if name.startswith("samcontact/")]


def test_rooms_are_complete():
    for folder in (INCLUDE / "samcontact", ROOT / "cpp" / "src"):
        assert {path.name for path in folder.iterdir()} == set(BELOW)
    for name in BELOW:
        parts = {place(file)[1] for file in HEADERS if room(file) == name}
        assert parts == set(DIVIDED.get(name, {"": set()}))
    for order in (BELOW, *DIVIDED.values()):
        graphlib.TopologicalSorter(order).prepare()


def test_rooms_include_lower_rooms_only():
    wrong = []
    for file in HEADERS + SOURCES:
        own_room, part = place(file)
        below = DIVIDED.get(own_room, {"": set()})[part] | {part}
        for name in own(file):
            other, other_part = place(INCLUDE / name)
            allowed = BELOW[own_room] if other != own_room else {own_room}
            if other not in allowed or (other == own_room and other_part not in below):
                wrong.append(f"{file.relative_to(ROOT)} includes {name}")
    assert wrong == []


def test_headers_have_no_cycle():
    graph = {str(file.relative_to(INCLUDE)): own(file) for file in HEADERS}
    assert {name for names in graph.values() for name in names} <= set(graph)
    graphlib.TopologicalSorter(graph).prepare()  # raises CycleError, which names the cycle


def test_sources_include_their_header_first():
    for file in SOURCES:  # long ones are divided: heat_history_fields.cpp
        first = Path(includes(file)[0])
        assert first.parts[:-1] == ("samcontact", *file.relative_to(ROOT / "cpp/src").parts[:-1])
        assert file.stem == first.stem or file.stem.startswith(f"{first.stem}_")


def test_the_core_knows_neither_python_nor_printing():
    forbidden = re.compile(r"pybind11|Python\.h|numpy|iostream|cstdio|stdio\.h|fstream|print")
    for file in HEADERS + SOURCES:
        assert [name for name in includes(file) if forbidden.search(name)] == []
        assert not re.search(r"\bstd::(cout|cerr|clog|printf)\b|\bprintf\s*\(", file.read_text())


def test_fftw_is_used_by_one_file():
    users = {str(f.relative_to(ROOT)) for f in HEADERS + SOURCES if "fftw3.h" in includes(f)}
    assert users == {"cpp/include/samcontact/fft/plan.hpp"}


def test_pybind11_stays_in_the_bindings():
    users = {file.name for file in BINDINGS if any("pybind11" in name for name in includes(file))}
    assert {"arrays.hpp", "base.cpp"} <= users
    shared = {"arrays", "long_work", "module", "parts", "rooms", "softening", "state", "typed"}
    assert {path.stem for path in BINDINGS} - shared <= set(BELOW)


@cache
def closure(header):
    """Return all headers that a header of the core includes, also through others."""
    names = set(includes(INCLUDE / header))
    return names.union(*(closure(name) for name in names if name.startswith("samcontact/")))


def shown_to_compile(file, before):
    """Yield the headers of the core that stand alone because this file compiles.

    These are headers before which nothing is included but what they include themselves. `before`
    contains the headers included so far.
    """
    for name in includes(file):
        if name not in before and name.startswith("samcontact/"):
            if before <= closure(name):
                yield name
            yield from shown_to_compile(INCLUDE / name, before)
        before.add(name)


COMPILED = [file for file in SOURCES + BINDINGS if file.suffix == ".cpp"]
SHOWN = {name for file in COMPILED for name in shown_to_compile(file, set())}
OTHERS = [file for file in HEADERS if str(file.relative_to(INCLUDE)) not in SHOWN]


def test_a_header_after_others_is_not_shown_to_compile_alone(tmp_path):
    (tmp_path / "a.cpp").write_text('#include <regex>\n#include "samcontact/base/box.hpp"\n')
    (tmp_path / "b.cpp").write_text('#include "samcontact/base/box.hpp"\n#include <regex>\n')
    assert "samcontact/base/box.hpp" not in shown_to_compile(tmp_path / "a.cpp", set())
    assert "samcontact/base/box.hpp" in shown_to_compile(tmp_path / "b.cpp", set())


@pytest.mark.parametrize("header", OTHERS, ids=lambda file: file.stem)
def test_other_headers_compile_alone(header):
    folder = ROOT / "build" / "headers"
    folder.mkdir(parents=True, exist_ok=True)
    source = folder / f"{room(header)}_{header.stem}.cpp"
    source.write_text(f'#include "{header.relative_to(INCLUDE)}"\n')
    compiler = os.environ.get("CXX", "g++")
    flags = ["-std=c++20", "-Wall", "-Wextra", "-Werror", "-Wno-unknown-pragmas", f"-I{INCLUDE}"]
    flags += ["-isystem", "/usr/include/eigen3", "-fsyntax-only", source.name]
    done = subprocess.run([compiler, *flags], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_headers_start_with_their_purpose():
    for file in HEADERS:
        lines = file.read_text().splitlines()
        assert re.match(r"// [A-Z].{15,}", lines[1]), file
        assert "#pragma once" in lines, file


def test_the_architecture_page_shows_the_order_of_the_rooms():
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    picture = page.split("```text")[1].split("```")[0].split("cpp/include, cpp/src\n")[1]
    shown, inside = {"": {}}, ""
    for number, line in enumerate(picture.splitlines()):
        indent, names = re.match(r"( +)(\w+(?:, \w+)*)", line).groups()
        inside = inside if len(indent) == 4 else ""
        shown[inside] |= dict.fromkeys(names.split(", "), number)
        if names in DIVIDED and not inside:
            shown[inside := names] = {}
    for room_of, order in {"": BELOW, **DIVIDED}.items():
        lines = shown.pop(room_of)
        assert set(lines) == set(order) - {""}
        for name in lines:
            assert all(lines[other] > lines[name] for other in order[name]), name
    assert not shown


@pytest.mark.parametrize(
    "folder",
    [
        "cpp",
        "python",
        "tests",
        "cmake",
        "cases",
        "docs",
        "scripts",
        "benchmarks",
        "gallery",
        "reference",
    ],
)
def test_files_begin_with_the_licence(folder):
    kinds = {".hpp", ".cpp", ".py", ".pyi", ".cmake", ".toml", ".md", ".sh"}
    files = [f for f in (ROOT / folder).rglob("*") if f.suffix in kinds]
    assert files
    for file in files:
        start = "\n".join(file.read_text().splitlines()[:2])
        # an empty file, such as py.typed or a package marker, has nothing to license
        assert "SPDX-License-Identifier: GPL-3.0-or-later" in start or not start, file


def test_every_documented_module_is_available_as_an_attribute():
    pages = [file.read_text(encoding="utf-8") for file in (ROOT / "docs" / "api").glob("*.md")]
    modules = sorted(re.findall(r"automodule:: samcontact\.(\S+)", "\n".join(pages)))
    assert {"cases", "plotting", "plotting.wear", "report", "results"} <= set(modules)
    code = f"""if True:
        import operator, sys, samcontact as sc
        for name in {modules}:
            assert name.split(".")[0] in dir(sc), name
            found = operator.attrgetter(name)(sc)
            assert found is sys.modules["samcontact." + name], name
        try:
            sc.plots
        except AttributeError as error:
            print(error)"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "module 'samcontact' has no attribute 'plots'"


def public(owner, prefix):
    """Yield public functions, classes, methods and properties of a module or class, with names."""
    own = inspect.isclass(owner) and [name for base in owner.__mro__[:-1] for name in vars(base)]
    names = getattr(owner, "__all__", None) or [n for n in own or vars(owner) if n[0] != "_"]
    for name in names:
        # Names of a module may be loaded on first use.
        thing = inspect.getattr_static(owner, name) if own else getattr(owner, name)
        thing = getattr(thing, "__func__", thing)
        full = f"{prefix}.{name}"
        if isinstance(thing, ModuleType):
            if thing.__name__.startswith("samcontact."):
                yield from public(thing, full)
        elif inspect.isclass(thing):
            yield full, thing
            if thing.__module__.startswith("samcontact"):
                yield from public(thing, full)
        elif inspect.isfunction(thing) or isinstance(thing, property | cached_property):
            yield full, thing


def test_everything_public_has_a_docstring():
    things = {
        name: thing
        for name, thing in public(sc, "sc")
        if str(getattr(thing, "__module__", "samcontact")).startswith("samcontact")
    }
    assert {"sc.Grid", "sc.Simulation.step", "sc.hertz.point", "sc.State.pressure"} <= set(things)
    assert sorted(name for name, thing in things.items() if not inspect.getdoc(thing)) == []


def callables():
    """Return public classes and functions with documented parameters."""
    for name in sc.__all__:
        thing = getattr(sc, name)
        members = [thing]
        if inspect.ismodule(thing):
            members = [getattr(thing, inner) for inner in getattr(thing, "__all__", ())]
        for member in members:
            if inspect.isclass(member):
                yield member, inspect.signature(member.__init__)
                for method in vars(member).values():
                    if inspect.isfunction(method) and not method.__name__.startswith("_"):
                        yield method, inspect.signature(method)
            elif inspect.isfunction(member):
                yield member, inspect.signature(member)


def test_every_parameter_is_documented():
    missing = []
    for thing, signature in callables():
        text = inspect.getdoc(thing) or ""
        if "Parameters\n" not in text:
            continue
        kinds = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)
        names = [p.name for p in signature.parameters.values() if p.kind not in kinds]
        missing += [f"{thing.__qualname__}({name})" for name in names if name not in ("self", "cls")
                    and not re.search(rf"\b{name}\b", text)]  # fmt: skip
    assert not missing
