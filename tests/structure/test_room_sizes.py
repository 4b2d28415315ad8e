# SPDX-License-Identifier: GPL-3.0-or-later
"""Rooms stay small: lines by room, as listed by scripts/sizes.py."""

import importlib.util
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
spec = importlib.util.spec_from_file_location("sizes", ROOT / "scripts" / "sizes.py")
sizes = importlib.util.module_from_spec(spec)
spec.loader.exec_module(sizes)


def test_files_belong_to_rooms():
    assert sizes.room_of("python/samcontact/heat.py") == ("samcontact.heat", False)
    assert sizes.room_of("python/samcontact/wear/steps.py") == ("samcontact.wear", False)
    assert sizes.room_of("tests/unit/wear/test_steps.py") == ("samcontact.wear", True)
    assert sizes.room_of("tests/unit/conftest.py") is None
    assert sizes.room_of("cpp/src/fft/plan.cpp") == ("cpp/fft", False)
    assert sizes.room_of("cpp/include/samcontact/fft/plan.hpp") == ("cpp/fft", False)
    assert sizes.room_of("cpp/src/contact/normal/window.cpp") == ("cpp/contact/normal", False)
    assert sizes.room_of("cpp/src/contact/outline.cpp") == ("cpp/contact", False)
    assert sizes.room_of("cpp/tests/test_fft.cpp") == ("cpp/tests", True)


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="files are listed by git")
def test_no_room_is_too_large():
    counts = sizes.lines_of_files()
    path = "python/samcontact/heat.py"
    assert counts[path] == len((ROOT / path).read_text(encoding="utf-8").splitlines())
    rooms = sizes.by_room(counts)
    assert {room: lines for room, (lines, _) in rooms.items() if lines > sizes.MAX_LINES} == {}
    assert len(sizes.table(rooms, rooms).splitlines()) == len(rooms) + 3
    assert sizes.table(rooms, rooms).endswith("| 0 |")
