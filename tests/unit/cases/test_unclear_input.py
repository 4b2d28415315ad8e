# SPDX-License-Identifier: GPL-3.0-or-later
"""Clear messages for numbers beyond the range of the core, odd texts and odd file names."""

import json
import math
import os
import re
import subprocess
import sys
import warnings

import numpy as np
import pytest
from click.testing import CliRunner

import samcontact as sc
from command import check_failure, invoke
from samcontact._util.likely_names import nearest
from samcontact._util.short_text import escaped
from samcontact.cases import Case, CaseError, load_case, parse_case
from samcontact.commands.main import main

GRID = sc.Grid(8, 8, 1e-5, 1e-5, 3, 1e-5)
GAP = sc.surfaces.paraboloid(GRID, 1e-3)
STEEL = sc.Material.perfect_plastic(2e11, 0.3, 1e9)
TEXT = """title = "Ball"
[grid]
nx = 16
ny = 16
dx = 5e-6
dy = 5e-6
[body1]
law = "rigid"
[body2]
law = "elastic"
E = 210e9
nu = 0.3
[surface]
shape = "paraboloid"
Rx = 1e-3
[[path]]
load = 0.2
increments = 1
"""
COMMANDS = [
    ["run", "a\0.toml"],
    ["run", "a.toml", "--output", "a\0b"],
    ["sweep", "a\0.toml", "--set", "grid.nx=8"],
    ["resume", "a\0b"],
    ["report", "a\0b"],
    ["export", "a\0b"],
]


def simulation(**settings):
    return sc.Simulation(GRID, sc.Material.rigid(), STEEL, GAP, **settings)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (
            lambda: simulation(reach=1e10),
            ValueError,
            "reach must be <= 167.772 m (1677",
        ),
        (lambda: simulation(reach=1e300), ValueError, "reach must be <= 167.772 m"),
        (
            lambda: simulation(max_iterations=10**20),
            ValueError,
            "max_iterations must be an in",
        ),
        (
            lambda: simulation(max_iterations=2**31),
            ValueError,
            "<= 2147483647, got 2147483648",
        ),
        (lambda: sc.Relief(GAP, -(10**20)), ValueError, "first must be an integer of magnitude"),
        (
            lambda: simulation().state.track(margin=2**40),
            ValueError,
            "margin must be an integer",
        ),
        (
            lambda: simulation().set_plastic_strain(2, np.zeros((6, 8, 8, 3)), first=2**40),
            ValueError,
            "first must be an integer of magnitude",
        ),
        (
            lambda: simulation().step(load=10**400),
            ValueError,
            "load must be a number of magnitude <= 1e+300, got <int of about 401 digits>",
        ),
        (
            lambda: simulation().step(load=0.0, advance=(1e300, 0.0)),
            ValueError,
            "advance must be <= 167.772 m",
        ),
        (lambda: sc.Heat(0.1, history=3.0), ValueError, "history must be a pair"),
        (
            lambda: simulation().run({"load": 1.0}),
            TypeError,
            "path must be a list of arguments of step",
        ),
        (lambda: simulation().run([3.0]), TypeError, "path must be a list of arguments"),
        (lambda: simulation().run(3.0), TypeError, "path must be a list of arguments"),
        (lambda: sc.Material("swift", {"E": 1.0}), ValueError, "must be E, nu, B, C, n, got E"),
        (lambda: sc.Material(["swift"], {}), ValueError, "law must be one of elastic, rigid"),
        (
            lambda: sc.Material("elastic", {"E": 1.0, "nu": 0.3}, thermal=(1.0,)),
            ValueError,
            "thermal must contain conductivity, expansion, diffusivity",
        ),
        (
            lambda: sc.Material("elastic", {"E": 1.0, "nu": 0.3}, kinematic=3.0),
            ValueError,
            "kinematic must contain modulus, recovery",
        ),
        (
            lambda: sc.Material("elastic", {"E": 1.0, "nu": 0.3}, softening=abs),
            ValueError,
            "softening requires an elastic-plastic material",
        ),
    ],
)
def test_numbers_out_of_range_are_named(call, error, message):
    with pytest.raises(error, match=re.escape(message)):
        call()


def test_largest_seed_and_steps_are_not_refused():
    sc.surfaces.rough_self_affine(GRID, 1e-7, 0.5, seed=2**200)
    assert simulation(reach=150.0).reach == 150.0


@pytest.mark.parametrize("depth", [100, 400, 900, 20000])
@pytest.mark.parametrize("brackets", ["[]", "{}"])
def test_deeply_nested_case_files(tmp_path, depth, brackets):
    left, right = ("[", "]") if brackets == "[]" else ("{a=", "}")
    path = tmp_path / "deep.toml"
    path.write_text(f"{TEXT}x = {left * depth}1{right * depth}\n")
    with pytest.raises(CaseError, match=r"deep\.toml: .*(too deeply|unknown field)") as caught:
        load_case(path)
    assert len(str(caught.value)) < 500
    settings = f"grid.nx={'[' * depth}{']' * depth}"
    path.write_text(TEXT)
    outcome = invoke("sweep", path, "--set", settings, "--output", tmp_path / "s")
    assert outcome.exit_code == 2
    assert outcome.exception is None or isinstance(outcome.exception, SystemExit)


def test_numbers_of_thousands_of_digits(tmp_path):
    with pytest.raises(CaseError, match=r"case\.toml: not valid TOML: Exceeds the limit"):
        parse_case(TEXT.replace("nx = 16", f"nx = {'1' * 5000}"))


def test_encodings_of_case_files(tmp_path):
    path = tmp_path / "c.toml"
    path.write_text(TEXT, encoding="utf-8-sig")
    assert load_case(path).title == "Ball"
    assert load_case(path).model_dump() == parse_case(TEXT).model_dump()
    for encoding, byte in (("utf-16", 0), ("latin-1", 10)):
        path.write_text(TEXT.replace("Ball", "Bäll"), encoding=encoding)
        message = rf"c\.toml: cannot read the case file: its byte {byte} is not UTF-8: save it as"
        with pytest.raises(CaseError, match=message):
            load_case(path)


@pytest.mark.parametrize("character", ["\0", "\x1b[31m", "\x07", "\x9b2J", "\r", "\x7f"])
@pytest.mark.parametrize("field", ["title", "description", "directory", "path"])
def test_control_characters_reach_no_terminal(tmp_path, field, character):
    stated = json.dumps(f"a{character}b")
    texts = {
        "title": TEXT.replace('"Ball"', stated),
        "description": f"description = {stated}\n{TEXT}",
        "directory": f"{TEXT}[output]\ndirectory = {stated}\n",
        "path": TEXT.replace('"paraboloid"\nRx = 1e-3', f'"file"\npath = {stated}'),
    }
    path = tmp_path / "c.toml"
    path.write_text(texts[field].replace("\x7f", "\\u007f"))
    outcome = invoke("run", path, "--output", tmp_path / "out", "--no-figures")
    check_failure(outcome, 2, f"{field}: must be text without control characters")
    assert escaped(outcome.output) == outcome.output
    assert not (tmp_path / "out").exists()


def test_control_characters_of_names_are_escaped_in_errors(tmp_path):
    path = tmp_path / "c.toml"
    path.write_text(f'"\\u001b[2Jbad" = 1\n{TEXT}')
    outcome = CliRunner().invoke(main, ["run", str(path)], color=True)
    assert outcome.exit_code == 2
    assert r"'\x1b[2Jbad': unknown field" in outcome.output
    assert "\x1b" not in outcome.output
    assert escaped("a\tb\nµ — ∞") == "a\tb\nµ — ∞"


@pytest.mark.parametrize("arguments", COMMANDS, ids=lambda a: " ".join(a[:2]).replace("\0", "NUL"))
def test_names_of_files_with_null_characters(arguments):
    outcome = CliRunner().invoke(main, arguments)
    assert outcome.exit_code == 2
    assert "must not contain a null character" in outcome.output
    assert "\0" not in outcome.output


@pytest.mark.parametrize(
    ("name", "fields", "intended"),
    [
        ("Radius", ["roughness", "shape", "Rx", "Ry"], "Rx"),
        ("radius", ["shape", "R", "axis"], "R"),
        ("RX", ["shape", "Rx", "Ry"], "Rx"),
        ("Youngs_modulus", ["law", "E", "nu"], "E"),
        ("poisson-ratio", ["law", "E", "nu"], "nu"),
        ("mu", ["friction", "tol"], "friction"),
        ("yield_strenght", ["E", "yield_stress"], "yield_stress"),
        ("force", ["load", "approach"], "load"),
        ("zzz", ["load", "approach"], None),
        ("mu", ["load"], None),
    ],
)
def test_common_synonyms_of_fields_are_suggested(name, fields, intended):
    assert nearest(name, fields) == intended


def test_a_radius_is_known_by_its_name():
    with pytest.raises(CaseError, match=r"surface\.Radius: unknown field; .*did you mean Rx\?"):
        parse_case(TEXT.replace("Rx =", "Radius ="))


def test_infinite_radius_with_units():
    content = parse_case(TEXT).model_dump()
    content["surface"] |= {"Rx": "1 mm", "Ry": "inf"}
    surface = Case.model_validate(content).surface
    assert (surface.Rx, surface.Ry) == (1e-3, math.inf)
    content["grid"]["dx"] = "inf"
    with pytest.raises(ValueError, match=r"grid\.dx: must be a finite number > 0"):
        Case.model_validate(content)


class TestHertzWithUnits:
    def values(self, *arguments):
        outcome = invoke("hertz", *arguments)
        assert outcome.exit_code == 0, outcome.output
        return outcome.stdout

    def test_are_those_without(self):
        plain = self.values(
            "--R", "7.5e-3", "--Ry", "0.0375", "--E-star", "115e9", "--load", "1500"
        )
        texts = ("--R", "7.5 mm", "--Ry", "37.5mm", "--E-star", "115 GPa", "--load", "1.5 kN")
        assert self.values(*texts) == plain
        for name, value, text in (("--approach", "1e-6", "1 um"), ("--p0", "1e9", "1000 MPa")):
            common = ("--R", "7.5 mm", "--E-star", "115 GPa")
            assert self.values(*common, name, value) == self.values(*common, name, text)

    @pytest.mark.parametrize("wrong", ["7.5 kg", "7,5", "mm", "", "7.5 mm mm", "7.5 parsec/s"])
    def test_refused_by_name(self, wrong):
        outcome = invoke("hertz", "--R", wrong, "--E-star", "115 GPa", "--load", "1")
        assert outcome.exit_code == 2
        message = "Invalid value for '--R': must be a number and a unit that converts to m, got"
        assert f"{message} {wrong!r}" in outcome.stderr


def test_shell_completion_as_documented():
    program = "import sys; sys.argv[0] = 'samcontact'; from samcontact.commands.main import main"

    def complete(**variables):
        command = [sys.executable, "-c", f"{program}; main()"]
        environment = os.environ | variables
        run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        return run.stdout

    for shell in ("bash", "zsh", "fish"):
        assert "_SAMCONTACT_COMPLETE" in complete(_SAMCONTACT_COMPLETE=f"{shell}_source")
    words = {"COMP_WORDS": "samcontact her", "COMP_CWORD": "1"}
    assert complete(_SAMCONTACT_COMPLETE="bash_complete", **words).split() == ["plain,hertz"]


def test_a_checkpoint_is_no_file_of_results(tmp_path):
    simulation().save(tmp_path / "results.nc")
    outcome = invoke("report", tmp_path)
    check_failure(outcome, 2, "must be a results file", "samcontact checkpoint")
    assert len(outcome.stderr.splitlines()) == 1


@pytest.mark.parametrize("name", ["results.nc", "case.toml"])
def test_a_report_never_replaces_results_or_cases(tmp_path, name):
    (tmp_path / "results.nc").write_text("precious")
    file = tmp_path / name
    file.write_text("precious")
    check_failure(invoke("report", tmp_path, "--output", file), 2, "must end in .html", name)
    assert file.read_text() == "precious"


def test_a_report_that_cannot_be_written_is_refused_first(tmp_path):
    (tmp_path / "results.nc").write_text("not read")
    missing = tmp_path / "nowhere" / "report.html"
    check_failure(invoke("report", tmp_path, "--output", missing), 2, "existing folder")
    check_failure(invoke("report", tmp_path, "--output", tmp_path), 2, "a directory")
    check_failure(invoke("report", tmp_path / "nowhere"), 1, "no results file", "nowhere")


@pytest.mark.parametrize("output", ["file", "file/below"])
def test_a_file_at_the_place_of_the_results_folder(tmp_path, output):
    case, file = tmp_path / "case.toml", tmp_path / "file"
    case.write_text(TEXT)
    file.write_text("precious")
    check_failure(invoke("run", case, "--output", tmp_path / output), 1, "is a file", "--output")
    assert file.read_text() == "precious"


def test_a_report_replaces_no_pipe_or_device(tmp_path):
    (tmp_path / "results.nc").write_text("not read")
    pipe = tmp_path / "report.html"
    os.mkfifo(pipe)
    check_failure(invoke("report", tmp_path), 2, "a device or pipe")
    assert pipe.is_fifo()


def test_a_lock_that_is_a_link_destroys_no_file(tmp_path):
    case, precious = tmp_path / "case.toml", tmp_path / "precious"
    case.write_text(TEXT)
    precious.write_text("precious")
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / ".samcontact.lock").symlink_to(precious)
    check_failure(invoke("run", case, "--output", tmp_path / "out"), 1, ".samcontact.lock")
    assert precious.read_text() == "precious"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[[path]]", "[path]", "path: must be a list of tables: write [[path]] instead of [path]"),
        ("[grid]", "[[grid]]", "grid: must be a single table: write [grid] instead of [[grid]]"),
    ],
)
def test_brackets_of_sections(old, new, message):
    with pytest.raises(CaseError, match=re.escape(message)):
        parse_case(TEXT.replace(old, new))


def test_case_files_without_an_end():
    with pytest.raises(CaseError, match=r"/dev/zero: .* more than 100000000 characters"):
        load_case("/dev/zero")


@pytest.mark.parametrize("mode", ["product", "zip"])
def test_sweeps_are_counted_before_they_are_made(mode):
    loads = [float(i) for i in range(1, 200_001)]
    parameters = {name: loads for name in ("path[0].load", "body2.E", "grid.dx")}
    expected = len(loads) ** 3 if mode == "product" else len(loads)
    with pytest.raises(ValueError, match=f"at most 100000 cases, got {expected} .*body2.E 200000"):
        sc.sweep(parse_case(TEXT), parameters, mode=mode)


@pytest.mark.parametrize("content", [b"\xff\xfe", b""])
def test_a_damaged_description_of_an_interrupted_run(tmp_path, content):
    folder = tmp_path / "checkpoints"
    folder.mkdir()
    (folder / "case.txt").write_bytes(content)
    check_failure(invoke("resume", tmp_path), 2, "case.txt is damaged", "--resume")


def test_warnings_turned_into_errors_by_the_environment(tmp_path):
    case = tmp_path / "case.toml"
    case.write_text(TEXT)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        outcome = invoke("run", case, "--output", tmp_path / "out", "--quiet")
    check_failure(outcome, 1, "warning treated as an error")


@pytest.mark.parametrize("Ry", [1e200, 1e-300])
def test_radii_too_different_for_an_ellipse(Ry):
    with pytest.raises(ValueError, match=r"Rx and Ry must differ by .* 1e\+100, got 1.0 and"):
        sc.hertz.elliptic(1.0, Ry, 1e11, load=1.0)
    assert sc.hertz.elliptic(1.0, 1e100, 1e11, load=1.0).p0 > 0.0


@pytest.mark.parametrize("text", ["40 um;", "40 um; 3 m", "40 um # wide", "40 um\n3 m"])
def test_nothing_after_a_unit_is_dropped(text):
    with pytest.raises(ValueError, match="must be a number and a unit that converts to m"):
        sc.units.si(text, "m")


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [("h.npy", "1 2 3\n", r"not written by numpy\.save$"), ("h.txt", "1 2 3\n1 2\n", "at row 2$")],
)
def test_errors_of_height_files_contain_no_advice_of_numpy(tmp_path, name, content, message):
    (tmp_path / name).write_text(content)
    with pytest.raises(ValueError, match=message):
        sc.measured.read(tmp_path / name, dx=1e-6)
