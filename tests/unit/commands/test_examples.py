# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands that write case files to start from."""

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from samcontact import materials, units
from samcontact.cases import load_case
from samcontact.commands.example_cases import FIRST_CASES, example_names, example_text
from samcontact.commands.main import main


def invoke(*arguments):
    return CliRunner().invoke(main, list(map(str, arguments)))


@pytest.mark.parametrize("kind", FIRST_CASES)
def test_a_new_case_is_valid_and_names_its_own_path(kind, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    outcome = invoke("new", kind)
    assert outcome.exit_code == 0, outcome.output
    assert f"samcontact run {kind}.toml" in outcome.stdout
    text = Path(f"{kind}.toml").read_text(encoding="utf-8")
    assert f"#   samcontact run {kind}.toml" in text
    assert "cases/" not in text
    assert load_case(f"{kind}.toml").title


def test_examples_need_no_optional_package(tmp_path, monkeypatch):
    """Values with units would need pint, which a plain installation does not have."""

    def missing():
        raise ImportError("pint is not installed")

    monkeypatch.setattr(units, "_registry", missing)
    invoke("cases", tmp_path / "cases")
    for name in example_names():
        assert load_case(tmp_path / "cases" / f"{name}.toml").title, name


def test_an_existing_file_is_kept(tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text("mine")
    outcome = invoke("new", "dent", file)
    assert outcome.exit_code == 2
    assert outcome.stderr.startswith(f"error: {file} exists already")
    assert file.read_text() == "mine"
    link = tmp_path / "link.toml"
    link.symlink_to(tmp_path / "nowhere.toml")
    assert invoke("new", "dent", link).exit_code == 2
    assert not (tmp_path / "nowhere.toml").exists()


def test_all_examples_are_listed_and_written(tmp_path):
    listed = invoke("cases").stdout
    for name in example_names():
        assert f"\n{name} " in f"\n{listed}"
    folder = tmp_path / "cases"
    assert invoke("cases", folder).exit_code == 0
    assert {file.stem for file in folder.iterdir()} == set(example_names())
    changed = folder / f"{example_names()[-1]}.toml"
    assert "0 case files written" in invoke("cases", folder).stdout
    changed.write_text("mine")
    outcome = invoke("cases", folder)
    assert outcome.exit_code == 2
    assert changed.read_text() == "mine"


def test_an_unknown_example_is_refused_by_name():
    with pytest.raises(ValueError, match=r"^name: must be one of .*t1_two_balls.*, got 'none'"):
        example_text("none")


def test_the_new_coating_gives_the_stress_on_both_sides_of_the_interface(tmp_path):
    """In-plane stresses jump with the stiffness; tractions and in-plane strains do not."""
    file = tmp_path / "coating.toml"
    assert invoke("new", "coating", file).exit_code == 0
    case = load_case(file)
    assert case.wear is None
    simulation, path = case.build()
    state = simulation.run(path, progress=False)[-1]
    above, below = state.interface_stress(body=2)[..., 0]
    largest = np.abs(above).max()
    np.testing.assert_allclose(above[2:5], below[2:5], atol=1e-6 * largest)  # zz, yz, xz
    strains = []
    for stress, material in ((above, "TiN"), (below, "52100")):
        E, nu = (materials.get(material).value(name) for name in ("E", "nu"))
        strains.append((stress[0] - nu * (stress[1] + stress[2])) / E)
    np.testing.assert_allclose(*strains, atol=1e-6 * np.abs(strains[0]).max())
    assert np.abs(above[0] - below[0]).max() > 0.2 * largest
