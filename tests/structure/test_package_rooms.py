# SPDX-License-Identifier: GPL-3.0-or-later
"""Order of the rooms of the Python package, as data, and imports between rooms."""

import ast
import graphlib
import importlib
import re
import subprocess
import sys
from pathlib import Path

import pytest

import samcontact as sc

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "python" / "samcontact"
MODULES = sorted(PACKAGE.rglob("*.py"))

# Rooms of the package (folders and public modules) by floor: each imports from lower floors
# only, types included.
FLOORS = [
    {"_util"},
    {
        "adhesion",
        "bodies",
        "files",
        "hertz",
        "kernels",
        "lubricants",
        "paths",
        "softening",
        "surfaces",
        "units",
    },
    {"bearings", "critical", "hardness", "restart", "heat", "heat_kernels", "materials"},
    {"problem", "flattening", "parts"},
    {"measured", "solutions", "dents", "operators"},
    {"diagnostics"},
    {"contact", "fatigue"},
    {"inclusions", "simulation", "rolling", "sliding"},
    {"shakedown", "wear", "energy", "lubrication"},
    {"asperities", "overrolling"},
    {"cases"},
    {"results"},
    {"accuracy", "plotting"},
    {"report", "sweeps"},
    {"commands"},
]
# Modules that call the core; all others use these modules.
CORE_USERS = {
    "__init__",
    "_util.checks",
    "_util.load_core",
    "_util.version",
    "accuracy.load_search",
    "bodies.hardening_laws",
    "bodies.layers",
    "commands.errors",
    "contact.creeping_rolling",
    "contact.enlargement",
    "contact.fields",
    "contact.interpenetration",
    "contact.moving",
    "contact.solver",
    "contact.normal_drive",
    "contact.tangential_drive",
    "diagnostics.hertz_estimate",
    "fatigue.criteria",
    "heat_kernels",
    "inclusions.fine_solution",
    "kernels",
    "lubrication.balance",
    "lubrication.film_accuracy",
    "lubrication.nested",
    "lubrication.sheared",
    "lubrication.steady",
    "lubrication.surface_heat",
    "lubrication.yielding",
    "operators",
    "restart.file",
    "rolling",
    "problem.adhesion_laws",
    "problem.contact_law",
    "problem.friction",
    "problem.grid",
    "problem.heating",
    "problem.settings",
    "simulation.engine",
    "solutions.interface_stress",
    "solutions.outline",
}


def test_the_repository_contains_the_whole_package():
    """No pattern of .gitignore excludes a part of the package."""
    command = ["git", "-C", str(ROOT), "check-ignore", "--no-index", *map(str, MODULES)]
    ignored = subprocess.run(command, capture_output=True, text=True).stdout.splitlines()
    assert ignored == []


def test_scipy_is_loaded_by_one_module():
    """This module checks the available memory first."""
    loads = re.compile(r"^\s*(import scipy|from scipy)", re.MULTILINE)
    assert [path.name for path in MODULES if loads.search(path.read_text())] == ["lazy_scipy.py"]


def test_cached_properties_have_no_lock():
    """Only the own cached_property is used.

    Before Python 3.12, the lock of that in functools can block a process forked meanwhile.
    """
    loads = re.compile(
        r"^\s*from functools import .*cached_property|functools\.cached", re.MULTILINE
    )
    users = [path.name for path in MODULES if loads.search(path.read_text())]
    assert users == ["cached_property.py"]


def module_name(file):
    """Return the dotted name below the package: "grid", "wear" for its __init__, "wear.steps"."""
    parts = file.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if len(parts) > 1 and parts[-1] == "__init__" else parts)


NAMES = {module_name(file): file for file in MODULES}


def imports(name, nodes):
    """Return the modules of the package imported by these statements of a module."""
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
    """Return the modules that a module imports when loaded or used, or for its types."""
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


def test_rooms_import_from_lower_floors_only():
    floor = {room: number for number, rooms in enumerate(FLOORS) for room in rooms}
    top = {path.stem for path in PACKAGE.iterdir() if path.suffix == ".py" or path.is_dir()}
    assert top - {"__init__", "__main__", "__pycache__", "_core"} == set(floor)
    wrong = []
    for name in set(NAMES) - {"__init__", "__main__"}:
        room = name.split(".")[0]
        for target in {target.split(".")[0] for target in all_imports(name)} - {room, "_core"}:
            if floor[target] >= floor[room]:
                wrong.append(f"{name} imports {target}")
    assert wrong == []


def test_the_architecture_page_shows_the_floors():
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    picture = page.split("```text\npython/samcontact\n")[1].split("cpp/bindings")[0]
    lines = [re.split(r" {2,}", line.strip())[0] for line in picture.splitlines()]
    assert lines == [", ".join(sorted(rooms)) for rooms in reversed(FLOORS)]


def test_only_public_modules_lie_outside_of_folders():
    outside = {path.stem for path in PACKAGE.glob("*.py")} - {"__init__", "__main__"}
    assert outside <= set(sc.__all__)


def own_private_names(tree):
    """Return the private names defined in a module: functions, methods, attributes."""
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name
        elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            if getattr(node.value, "id", "") == "self":
                yield node.attr
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            yield node.target.id


def reached_into(tree):
    """Return the private attributes of other objects used, but not defined, in a module."""
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
    """Code shared by several test files is in a separate module."""
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
    """Only the names of classes load modules, not their use.

    NumPy loads masked arrays on first use, which takes longer than a small contact.
    """
    code = """if True:
        import sys, samcontact as sc
        grid = sc.Grid(64, 64, 1e-6, 1e-6)
        gap = sc.surfaces.paraboloid(grid, 1e-2)
        sc.Material, sc.ContactSolver
        before = set(sys.modules)
        body = sc.Material.elastic(210e9, 0.3)
        sc.ContactSolver(grid, sc.Material.rigid(), body).solve(gap, load=0.1)
        print(sorted(set(sys.modules) - before))"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


PUBLIC = ast.parse(NAMES["__init__"].read_text())


def test_names_loaded_on_first_use_are_those_for_type_checkers():
    """The table of places in the package agrees with the imports that type checkers see."""
    (typed,) = (node for node in PUBLIC.body if isinstance(node, ast.If))
    seen = {
        (node.module or "", alias.name)
        for node in typed.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    given = {node.targets[0].id: node.value for node in PUBLIC.body if isinstance(node, ast.Assign)}
    places = ast.literal_eval(given["_PLACES"])
    modules = ast.literal_eval(given["_MODULES"].args[0])
    listed = {(place, name) for place, names in places.items() for name in names}
    assert seen == listed | {("", name) for name in modules}
    for place, name in listed:
        assert getattr(sc, name) is getattr(importlib.import_module(f"samcontact.{place}"), name)
    assert set(sc.__all__) <= set(dir(sc))
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        sc.__getattr__("nothing")


def test_importing_the_package_loads_few_modules():
    code = """if True:
        import sys, samcontact
        own = [name for name in sys.modules if name.startswith("samcontact.")]
        print(len(own), sorted(sys.modules.keys() & {"scipy", "h5py", "pandas", "xarray"}))"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    count, libraries = found.stdout.split(maxsplit=1)
    assert int(count) < 30
    assert libraries.strip() == "[]"
