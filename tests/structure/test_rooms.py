# SPDX-License-Identifier: GPL-3.0-or-later
"""The order of the rooms, as data, and what keeps the code readable by machine."""

import ast
import graphlib
import inspect
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

import samcontact as sc

ROOT = Path(__file__).parents[2]
INCLUDE = ROOT / "cpp" / "include"
HEADERS = sorted(INCLUDE.rglob("*.hpp"))
SOURCES = sorted((ROOT / "cpp" / "src").rglob("*.cpp"))
BINDINGS = sorted((ROOT / "cpp" / "bindings").glob("*.?pp"))
PACKAGE = ROOT / "python" / "samcontact"
MODULES = sorted(PACKAGE.rglob("*.py"))

# What a room may include besides itself.
BELOW = {
    "base": set(),
    "fatigue": {"base"},
    "kernels": {"base"},
    "fft": {"base"},
    "plasticity": {"base"},
    "operators": {"base", "kernels", "fft"},
    "contact": {"base", "kernels", "fft", "operators"},
    "simulation": {"base", "kernels", "fft", "operators", "plasticity", "contact"},
}
# The rooms of the package, folders and public modules, by floors: each imports from floors below it
# only, types included.
FLOORS = [
    {"_util"},
    {"bodies", "files", "hertz", "paths", "hardness", "kernels", "softening", "surfaces", "units"},
    {"bearings", "critical", "restart", "heat", "heat_kernels"},
    {"scene", "flattening"},
    {"measured", "solutions", "dents", "operators"},
    {"diagnostics"},
    {"contact", "fatigue"},
    {"simulation", "rolling"},
    {"shakedown", "wear", "energy"},
    {"asperities"},
    {"cases"},
    {"results"},
    {"accuracy", "plotting"},
    {"report", "sweeps"},
    {"commands"},
]
# Modules that talk to the core; all others go through them.
CORE_USERS = {
    "__init__",
    "_util.load_core",
    "_util.version",
    "accuracy.load_search",
    "bodies.hardening_laws",
    "bodies.layered",
    "commands.errors",
    "contact.enlargement",
    "contact.fields",
    "contact.interpenetration",
    "contact.solver",
    "contact.tangential_drive",
    "diagnostics.hertz_estimate",
    "fatigue.criteria",
    "heat_kernels",
    "kernels",
    "operators",
    "restart.file",
    "rolling",
    "scene.grid",
    "scene.heating",
    "scene.settings",
    "simulation.engine",
    "solutions.interface_stress",
}


def room(file):
    return file.parent.name


def includes(file):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', file.read_text(), re.MULTILINE)


def own(file):
    """The headers of the core that a file includes, as paths below cpp/include."""
    return [name for name in includes(file) if name.startswith("samcontact/")]


def test_the_repository_holds_the_whole_package():
    """A pattern of .gitignore must not leave out a part of it."""
    command = ["git", "-C", str(ROOT), "check-ignore", "--no-index", *map(str, MODULES)]
    ignored = subprocess.run(command, capture_output=True, text=True).stdout.splitlines()
    assert ignored == []


def test_rooms_are_complete():
    for folder in (INCLUDE / "samcontact", ROOT / "cpp" / "src"):
        assert {path.name for path in folder.iterdir()} == set(BELOW)
    assert {room(file) for file in HEADERS} == set(BELOW)
    graphlib.TopologicalSorter(BELOW).prepare()


def test_rooms_include_lower_rooms_only():
    wrong = [
        f"{file.relative_to(ROOT)} includes {name}"
        for file in HEADERS + SOURCES
        for name in own(file)
        if name.split("/")[1] not in BELOW[room(file)] | {room(file)}
    ]
    assert wrong == []


def test_headers_have_no_cycle():
    graph = {str(file.relative_to(INCLUDE)): own(file) for file in HEADERS}
    assert {name for names in graph.values() for name in names} <= set(graph)
    graphlib.TopologicalSorter(graph).prepare()  # raises CycleError, which names the cycle


def test_sources_include_their_header_first():
    for file in SOURCES:  # long ones are divided: heat_history_fields.cpp
        first = Path(includes(file)[0])
        assert str(first.parent) == f"samcontact/{room(file)}"
        assert file.stem == first.stem or file.stem.startswith(f"{first.stem}_")


def test_the_core_knows_neither_python_nor_printing():
    forbidden = re.compile(r"pybind11|Python\.h|numpy|iostream|cstdio|stdio\.h|fstream|print")
    for file in HEADERS + SOURCES:
        assert [name for name in includes(file) if forbidden.search(name)] == []
        assert not re.search(r"\bstd::(cout|cerr|clog|printf)\b|\bprintf\s*\(", file.read_text())


def test_fftw_has_one_door():
    users = {str(f.relative_to(ROOT)) for f in HEADERS + SOURCES if "fftw3.h" in includes(f)}
    assert users == {"cpp/include/samcontact/fft/plan.hpp"}


def test_scipy_is_loaded_by_one_module():
    """Which looks for memory first."""
    loads = re.compile(r"^\s*(import scipy|from scipy)", re.MULTILINE)
    assert [path.name for path in MODULES if loads.search(path.read_text())] == ["lazy_scipy.py"]


def test_cached_properties_have_no_lock():
    """That of the standard library before Python 3.12, which hangs a child forked meanwhile."""
    loads = re.compile(
        r"^\s*from functools import .*cached_property|functools\.cached", re.MULTILINE
    )
    users = [path.name for path in MODULES if loads.search(path.read_text())]
    assert users == ["cached_property.py"]


def test_pybind11_stays_in_the_bindings():
    users = {file.name for file in BINDINGS if any("pybind11" in name for name in includes(file))}
    assert {"arrays.hpp", "base.cpp"} <= users
    shared = {"arrays", "long_work", "module", "parts", "rooms", "softening"}
    assert {path.stem for path in BINDINGS} - shared <= set(BELOW)


# A source includes its header first, so that each of these compiles alone where the core is built.
WITH_SOURCE = {(room(file), file.stem) for file in SOURCES}
OTHERS = [file for file in HEADERS if (room(file), file.stem) not in WITH_SOURCE]


@pytest.mark.parametrize("header", OTHERS, ids=lambda file: file.stem)
def test_headers_without_a_source_compile_alone(header):
    folder = ROOT / "build" / "headers"
    folder.mkdir(parents=True, exist_ok=True)
    source = folder / f"{room(header)}_{header.stem}.cpp"
    source.write_text(f'#include "{header.relative_to(INCLUDE)}"\n')
    compiler = [os.environ.get("CXX", "g++")]
    if shutil.which("ccache"):  # most have not changed since the last time
        compiler = ["ccache", *compiler]
    flags = ["-std=c++20", "-Wall", "-Wextra", "-Werror", "-Wno-unknown-pragmas", f"-I{INCLUDE}"]
    flags += ["-isystem", "/usr/include/eigen3", "-c", source.name, "-o", f"{source.stem}.o"]
    done = subprocess.run([*compiler, *flags], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_headers_open_with_their_purpose():
    for file in HEADERS:
        lines = file.read_text().splitlines()
        assert re.match(r"// [A-Z].{15,}", lines[1]), file
        assert "#pragma once" in lines, file


def test_the_architecture_page_names_every_room():
    page = (ROOT / "docs" / "architecture.md").read_text()
    diagram = page.split("```text")[1].split("```")[0]
    rows = re.findall(r"^\| (\w+) \|", page, re.MULTILINE)
    for name in BELOW:
        assert re.search(rf"\b{name}\b", diagram), name
        assert name in rows, name


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


def module_name(file):
    """Dotted, below the package: "grid", "wear" of its __init__, "wear.steps"."""
    parts = file.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if len(parts) > 1 and parts[-1] == "__init__" else parts)


NAMES = {module_name(file): file for file in MODULES}


def imports(name, nodes):
    """Modules of the package that these statements of a module import."""
    file = NAMES[name]
    package = file.relative_to(PACKAGE).parent.parts
    for node in nodes:
        if not isinstance(node, ast.ImportFrom) or node.level == 0:
            continue
        base = package[: len(package) + 1 - node.level] + tuple((node.module or "").split("."))
        base = ".".join(part for part in base if part)
        for alias in node.names:
            inner = f"{base}.{alias.name}".lstrip(".")
            yield inner if inner in NAMES or not base else base


def all_imports(name, *, types=True):
    """Modules that a module imports when it is loaded or used, or for its types."""
    tree = ast.parse(NAMES[name].read_text())
    if not types:
        tree.body = [
            node
            for node in tree.body
            if getattr(getattr(node, "test", 0), "id", 0) != "TYPE_CHECKING"
        ]
    return set(imports(name, ast.walk(tree)))


def test_modules_have_no_cycle():
    graph = {name: all_imports(name) - {"_core"} for name in NAMES if name != "__init__"}
    assert {name for names in graph.values() for name in names} <= set(NAMES)
    graphlib.TopologicalSorter(graph).prepare()  # raises CycleError, which names the cycle


def test_rooms_import_from_floors_below_only():
    floor = {room: number for number, rooms in enumerate(FLOORS) for room in rooms}
    top = {path.stem for path in PACKAGE.iterdir() if path.suffix == ".py" or path.is_dir()}
    assert top - {"__init__", "__main__", "__pycache__"} == set(floor)
    wrong = []
    for name in set(NAMES) - {"__init__", "__main__"}:
        room = name.split(".")[0]
        for target in {target.split(".")[0] for target in all_imports(name)} - {room, "_core"}:
            if floor[target] >= floor[room]:
                wrong.append(f"{name} imports {target}")
    assert wrong == []


def test_only_public_modules_lie_outside_of_folders():
    outside = {path.stem for path in PACKAGE.glob("*.py")} - {"__init__", "__main__"}
    assert outside <= set(sc.__all__)


def own_private_names(tree):
    """Private names that a module defines: functions, methods, attributes."""
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            if getattr(node.value, "id", "") == "self":
                yield node.attr
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            yield node.target.id


def reached_into(tree):
    """Private attributes of other objects that a module uses, which it does not define."""
    modules = {
        alias.asname or alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.Import)
        for alias in node.names
    }
    own = {*own_private_names(tree), "_core", "_replace"}  # the compiled part, tuples with names
    for node in ast.walk(tree):
        if not isinstance(node, ast.Attribute) or not re.match("_[a-z]", node.attr):
            continue
        value = node.value
        is_super = isinstance(value, ast.Call) and getattr(value.func, "id", "") == "super"
        if is_super or getattr(value, "id", "") in {"self", "cls", *modules} or node.attr in own:
            continue
        yield ast.unparse(node)


def test_no_module_reaches_into_the_privates_of_another():
    trees = {name: ast.parse(file.read_text()) for name, file in NAMES.items()}
    found = {name: list(reached_into(tree)) for name, tree in trees.items()}
    assert {name: uses for name, uses in found.items() if uses} == {}
    sample = (
        "class A:\n    def f(self, b):\n        return self._x, b._y, b._z\n    def _z(self): ..."
    )
    assert list(reached_into(ast.parse(sample))) == ["b._y"]


def test_no_test_file_imports_another():
    """What several share is a module."""
    pattern = re.compile(r"^\s*(?:from|import) test_\w+", re.MULTILINE)
    files = (ROOT / "tests").rglob("*.py")
    assert [file.name for file in files if pattern.search(file.read_text())] == []


def test_few_modules_talk_to_the_core():
    assert {name for name in NAMES if "_core" in all_imports(name, types=False)} == CORE_USERS


def test_the_package_loads_no_file_or_figure_library():
    heavy = {"matplotlib", "xarray", "pydantic", "pandas", "click", "rich"}
    heavy |= {"SurfaceTopography", "pint", "distributed"}
    heavy |= {f"scipy.{part}" for part in ("fft", "ndimage", "optimize", "signal", "special")}
    code = f"import sys, samcontact; print(sorted({heavy} & set(sys.modules)))"
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


def test_a_first_solve_loads_nothing():
    """NumPy loads its masked arrays when they are named, for longer than small contacts take."""
    code = """if True:
        import sys, samcontact as sc
        grid = sc.Grid(64, 64, 1e-6, 1e-6)
        gap = sc.surfaces.paraboloid(grid, 1e-2)
        before = set(sys.modules)
        body = sc.Material.elastic(210e9, 0.3)
        sc.ContactSolver(grid, sc.Material.rigid(), body).solve(gap, load=0.1)
        print(sorted(set(sys.modules) - before))"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


def test_every_documented_module_is_there_when_it_is_asked_for():
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
    """Public functions, classes, methods and properties below a module or class, with names."""
    own = inspect.isclass(owner) and [name for base in owner.__mro__[:-1] for name in vars(base)]
    names = getattr(owner, "__all__", None) or [n for n in own or vars(owner) if n[0] != "_"]
    for name in names:
        thing = inspect.getattr_static(owner, name)
        thing = getattr(thing, "__func__", thing)
        full = f"{prefix}.{name}"
        if isinstance(thing, ModuleType):
            if thing.__name__.startswith("samcontact."):
                yield from public(thing, full)
        elif inspect.isclass(thing):
            yield full, thing
            if thing.__module__.startswith("samcontact"):
                yield from public(thing, full)
        elif inspect.isfunction(thing) or isinstance(thing, property):
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
    """Public classes and functions with documented parameters."""
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
