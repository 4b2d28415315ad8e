# SPDX-License-Identifier: GPL-3.0-or-later
"""The comparison of instruction counts, without valgrind."""

import subprocess

import pytest

from benchmarks.instructions import guard

BEFORE = {"sweep": 1000, "return": 2000}


def test_small_growth_passes():
    rows, failed = guard.compare(BEFORE, {"sweep": 1050, "return": 1500}, {})
    assert failed == []
    assert rows == [
        ("return", "2,000", "1,500", "-25.00 %", "ok"),
        ("sweep", "1,000", "1,050", "+5.00 %", "ok"),
    ]


def test_large_growth_fails():
    rows, failed = guard.compare(BEFORE, {"sweep": 1051, "return": 2000}, {})
    assert failed == ["sweep"]
    assert rows[1][-1] == "more than +5 %"


def test_growth_passes_up_to_the_announced_value():
    allowed = {"sweep": 0.12}
    rows, failed = guard.compare(BEFORE, {"sweep": 1110, "return": 2000}, allowed)
    assert failed == []
    assert rows[1][-1] == "announced"
    assert guard.compare(BEFORE, {"sweep": 1130, "return": 2000}, allowed)[1] == ["sweep"]
    # an announcement never lowers the tolerance
    assert guard.compare(BEFORE, {"sweep": 1040, "return": 2000}, {"sweep": 0.01})[1] == []


def test_new_and_removed_kernels_pass():
    rows, failed = guard.compare({"old": 10}, {"new": 10}, {})
    assert failed == []
    assert [(row[0], row[-1]) for row in rows] == [("new", "new"), ("old", "gone")]


def test_announcements():
    message = (
        "Sum the layers more exactly\n\nInstructions: layer_sweep +12 % because of it\n"
        "Instructions: radial_return +7.5% because it checks more\n"
        "Instructions: transforms +9 %\n"
    )
    # the last gives no reason
    assert guard.allowances(message) == {"layer_sweep": 0.12, "radial_return": 0.075}


def test_table_lines_up():
    text = guard.table(guard.compare(BEFORE, {"sweep": 1051, "return": 2000}, {})[0])
    header, *lines = text.splitlines()
    assert header.split() == ["kernel", "before", "after", "change"]
    assert all(line.index("%") == header.rindex("e") for line in lines)


@pytest.fixture
def repository(tmp_path, monkeypatch):
    """An empty repository in place of this one; returns a function that runs git in it."""
    monkeypatch.setattr(guard, "ROOT", tmp_path)

    def git(*arguments):
        identity = ("-c", "user.name=x", "-c", "user.email=x@example.org")
        subprocess.run(["git", *identity, *arguments], cwd=tmp_path, check=True)

    git("init", "--quiet")
    return git


def commit(git, path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    git("add", ".")
    git("commit", "--quiet", "-m", f"{path.name} {text}")


def test_skips_without_something_to_compare_with(repository, tmp_path):
    driver = tmp_path / guard.DRIVER
    commit(repository, tmp_path / "readme", "1")
    with pytest.raises(guard.Skip, match="no such commit"):
        guard.find_base("HEAD~1")
    commit(repository, driver, "1")
    with pytest.raises(guard.Skip, match=f"has no {guard.DRIVER}"):
        guard.find_base("HEAD~1")
    commit(repository, tmp_path / "readme", "2")
    with pytest.raises(guard.Skip, match="nothing that is counted differs"):
        guard.find_base("HEAD~1")
    commit(repository, driver, "2")
    assert len(guard.find_base("HEAD~1")) == 40


def test_skips_a_shallow_history(repository, tmp_path, monkeypatch):
    for text in "12":
        commit(repository, tmp_path / guard.DRIVER, text)
    shallow = tmp_path / "shallow"
    subprocess.run(
        ["git", "clone", "--quiet", "--depth=1", f"file://{tmp_path}", str(shallow)], check=True
    )
    monkeypatch.setattr(guard, "ROOT", shallow)
    with pytest.raises(guard.Skip, match="shallow"):
        guard.find_base("HEAD~1")


def test_skips_outside_a_repository(tmp_path, monkeypatch):
    monkeypatch.setattr(guard, "ROOT", tmp_path)
    with pytest.raises(guard.Skip, match="git"):
        guard.find_base("HEAD~1")
