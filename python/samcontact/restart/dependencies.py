# SPDX-License-Identifier: GPL-3.0-or-later
"""Canonical texts of user-defined functions and objects, from their code and the data they use."""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable, Iterator
from importlib import metadata
from pathlib import Path
from types import (
    BuiltinFunctionType,
    CodeType,
    FunctionType,
    MethodDescriptorType,
    MethodType,
    MethodWrapperType,
    ModuleType,
    WrapperDescriptorType,
)
from typing import Any

import numpy as np

Text = Callable[[Any], str]
"""Function that returns the canonical text of any value."""
IDENTITY_ATTRIBUTE = "identity"
"""Name of the attribute in which users can state everything on which an object depends."""

_COMPILED_TYPES = (
    BuiltinFunctionType, MethodDescriptorType, MethodWrapperType, WrapperDescriptorType, np.ufunc,
)  # fmt: skip
_PACKAGE_FOLDERS = {"site-packages", "dist-packages"}
"""Names of the folders of installed packages. Code in these folders is identified by the version of
the package; any other code is user code."""
_STATELESS_SLOTS = {"__dict__", "__weakref__", "__doc__", "__module__", "__annotations__"}
_STATELESS_SLOTS |= {
    "__firstlineno__",
    "__static_attributes__",
    "__annotate_func__",
    "__annotate__",
}


class UnidentifiedError(ValueError):
    """Error for a function or object whose dependencies cannot be determined."""


def text_of_object(value: Any, text: Text) -> str:
    """Return a text that is equal for two objects only if they behave identically.

    Parameters
    ----------
    value : object
        Function, method, partial, class, module, or instance of any class.
    text : callable
        Function that returns the canonical text of a part of `value`.

    Raises
    ------
    UnidentifiedError
        The object has state that Python cannot read, e.g. the state of a compiled object.
    """
    stated = getattr(value, IDENTITY_ATTRIBUTE, None)
    if stated is not None and not callable(stated):
        return f"{type(value).__name__} with identity {text(stated)}"
    if isinstance(value, ModuleType):
        return _module(value)
    if isinstance(value, FunctionType):
        return _from_library(value) or _function(value, text)
    if isinstance(value, MethodType):
        return f"method {text(value.__func__)} of {text(value.__self__)}"
    if isinstance(value, functools.partial):
        return f"partial {text([value.func, value.args, value.keywords, vars(value)])}"
    if isinstance(value, functools._lru_cache_wrapper):
        return f"cached {text(value.__wrapped__)}"
    if isinstance(value, type):
        return _from_library(value) or _class(value, text)
    if isinstance(value, (staticmethod, classmethod)):
        return f"{type(value).__name__} {text(value.__func__)}"
    if isinstance(value, property):
        return f"property {text([value.fget, value.fset, value.fdel])}"
    if isinstance(value, _COMPILED_TYPES):
        return _compiled(value, text)
    return _instance(value, text)


def _function(function: FunctionType, text: Text) -> str:
    cells = []
    for cell in function.__closure__ or ():
        try:
            cells.append(cell.cell_contents)
        except ValueError:  # not assigned yet
            cells.append(None)
    known = dict(_globals(function.__code__, function.__globals__))
    state = {name: value for name, value in vars(function).items() if name != "__wrapped__"}
    parts = [function.__defaults__, function.__kwdefaults__, cells, state, known]
    return f"{function.__qualname__} {text(_code(function.__code__))} {text(parts)}"


def _code(code: CodeType) -> list[Any]:
    """Return the content of a code object as a list, without file name and line numbers."""
    constants = [_code(c) if isinstance(c, CodeType) else c for c in code.co_consts]
    names = [code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars]
    counts = [code.co_argcount, code.co_posonlyargcount, code.co_kwonlyargcount, code.co_flags]
    return [code.co_code, constants, names, counts]


def _globals(code: CodeType, scope: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    """Iterate over the global variables that a function uses, as pairs of name and value."""
    names = set(_names(code))
    imported = {name: sys.modules[name] for name in names - set(scope) if name in sys.modules}
    yield from _used(names, imported | scope, "", set())


def _used(
    names: set[str], scope: dict[str, Any], prefix: str, seen: set[int]
) -> Iterator[tuple[str, Any]]:
    """Iterate over the variables of a scope that a function uses, as pairs of name and value.

    A user module in the scope is replaced by those of its variables whose names occur in the
    function. Some of these variables may be unused, which does no harm. names: names that occur in
    the function. prefix: text put before each name in the pairs. seen: ids of the modules already
    visited.
    """
    for name in sorted(names & set(scope)):
        value = scope[name]
        if not isinstance(value, ModuleType) or _library(value.__name__) is not None:
            yield prefix + name, value
        elif id(value) not in seen:
            yield from _used(names, vars(value), f"{prefix}{name}.", {*seen, id(value)})


def _names(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


def _class(cls: type, text: Text) -> str:
    own = {name: part for name, part in vars(cls).items() if name not in _STATELESS_SLOTS}
    own = {name: part for name, part in own.items() if not _is_slot(part)}
    bases = [base for base in cls.__bases__ if base is not object]
    return f"class {cls.__qualname__} {text([bases, own])}"


def _is_slot(part: Any) -> bool:
    return type(part).__name__ in ("member_descriptor", "getset_descriptor", "_abc_data")


def _instance(value: Any, text: Text) -> str:
    """Return the text of the pickled form of an object.

    Raises UnidentifiedError if the object cannot be pickled.
    """
    try:
        made = value.__reduce_ex__(4)
    except Exception as error:  # the user class may raise anything
        raise UnidentifiedError(str(error)) from error
    if isinstance(made, str):
        return f"{type(value).__module__}.{made}"
    maker, arguments, *rest = made
    state, *more = (*rest, None, None, None)[:3]
    items = [None if one is None else list(one) for one in more]
    return f"object {text([maker, arguments, state, *items])}"


def _compiled(value: Any, text: Text) -> str:
    owner = getattr(value, "__self__", None)
    name = getattr(value, "__qualname__", value.__name__)
    if owner is not None and not isinstance(owner, (ModuleType, type)):
        return f"{name} of {text(owner)}"
    owner = getattr(value, "__objclass__", owner)
    module = getattr(value, "__module__", None) or getattr(owner, "__module__", None)
    known = module or getattr(owner, "__name__", None) or "numpy"
    library = _library(str(known))
    if library is None and str(known).partition(".")[0] not in sys.builtin_module_names:
        raise UnidentifiedError(f"{name} is compiled code that belongs to no installed package")
    return f"{known}.{name} of {library}"


def _module(module: ModuleType) -> str:
    return f"module {module.__name__} of {_library(module.__name__)}"


def _from_library(value: Any) -> str | None:
    """Return the text of a function or class of an installed package, or None for user code."""
    module, name = value.__module__, value.__qualname__
    library = _library(str(module))
    found: Any = sys.modules.get(str(module))
    for part in name.split("."):
        found = getattr(found, part, None)
    return f"{module}.{name} of {library}" if library is not None and found is value else None


@functools.cache
def _library(module: str) -> str | None:
    """Return name and version of the package that contains a module, or None for a user module."""
    top = module.partition(".")[0]
    if top in sys.stdlib_module_names and top != "__main__":
        return f"Python {sys.version_info.major}.{sys.version_info.minor}"
    loaded = sys.modules.get(top)
    file = getattr(loaded, "__file__", None)
    installed = file and _PACKAGE_FOLDERS & set(Path(file).resolve().parts)
    if top != "samcontact" and not installed:
        return None
    try:
        return f"{top} {metadata.version(top)}"
    except metadata.PackageNotFoundError:
        return f"{top} {getattr(loaded, '__version__', '')}"
