# SPDX-License-Identifier: GPL-3.0-or-later
"""Libraries that commands do not load."""

import sys
from importlib.util import find_spec

from samcontact.commands import array_libraries


def test_libraries_are_absent_until_they_are_needed(monkeypatch):
    for name in ("dask", "sparse"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    monkeypatch.setitem(sys.modules, "pint", sys)  # loaded already
    monkeypatch.delitem(sys.modules, "cupy", raising=False)
    array_libraries.hide()
    assert find_spec("dask") is None
    assert sys.modules["pint"] is sys
    array_libraries.show()
    assert find_spec("dask") is not None
    assert sys.modules["pint"] is sys
