# SPDX-License-Identifier: GPL-3.0-or-later
"""Failures of the output stream never lose results: ASCII terminals, closed pipes."""

import os
import signal
import subprocess
import sys

import click
import pytest

from case_texts import MINIMAL, SWIFT
from command import invoke
from samcontact.commands.main import main
from samcontact.commands.streams import guarded_output

# Without a volume, for few figures.
SURFACES = MINIMAL.replace(SWIFT, 'law = "elastic"\nE = 210e9\nnu = 0.3').replace(
    "nz = 12\ndz = 60e-6", ""
)
COMMAND = [sys.executable, "-m", "samcontact"]


@pytest.fixture
def case(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(
        "estimate_error = false\n" + SURFACES.replace("two balls", "zwei Köpfe ≤ 3 µm"),
        encoding="utf-8",
    )
    return path


def run(case, *arguments, **options):
    out = case.with_name("out")
    command = [*COMMAND, "run", str(case), "--output", str(out), *arguments]
    ended = subprocess.run(command, stderr=subprocess.PIPE, check=False, **options)
    return ended, {path.name for path in out.iterdir()}


FILES = {
    ".samcontact-files", "results.nc", "pressure.png", "load_approach.png", "pressure_map.png",
    "gap_map.png",
}  # fmt: skip


@pytest.mark.parametrize("encoding", ["ascii", pytest.param("latin-1", marks=pytest.mark.slow)])
def test_a_terminal_without_some_characters(case, encoding):
    environment = os.environ | {"PYTHONIOENCODING": encoding, "PYTHONUTF8": "0"}
    ended, files = run(case, "--no-figures", env=environment, stdout=subprocess.PIPE)
    assert (ended.returncode, files) == (0, {"results.nc"}), ended.stderr
    text = ended.stdout.decode(encoding)
    shown = {"ascii": "zwei Kopfe <= 3 um", "latin-1": "zwei Köpfe <= 3 µm"}[encoding]
    assert text.splitlines()[0] == shown
    assert {"ascii": "[um]", "latin-1": "[µm]"}[encoding] in text
    assert "results.nc" in text


@pytest.mark.parametrize("both", [False, True], ids=["stdout", "stdout and stderr"])
def test_a_closed_pipe(case, both):
    reading, writing = os.pipe()
    os.close(reading)
    out = case.with_name("out")
    command = [*COMMAND, "run", str(case), "--output", str(out), *["--no-figures"] * both]
    errors = writing if both else subprocess.PIPE
    with subprocess.Popen(command, stdout=writing, stderr=errors) as process:
        os.close(writing)
        _, message = process.communicate()
    assert {path.name for path in out.iterdir()} == ({"results.nc"} if both else FILES)
    assert process.returncode == 1
    if not both:
        assert b"Traceback" not in message
        assert b"rror" not in message


def test_output_to_a_full_disk(case):
    with open("/dev/full", "w") as full:
        ended, files = run(case, "--no-figures", stdout=full)
    assert (ended.returncode, files) == (1, {"results.nc"})
    message = ended.stderr.decode().splitlines()[-1]
    assert message == "error: cannot write to the standard output: No space left on device"


@pytest.mark.parametrize(
    "words",
    [
        *("doctor", "run --help"),
        *(pytest.param(words, marks=pytest.mark.slow) for words in ("--help", "--version")),
    ],
)
def test_unprintable_output_is_a_failure(words):
    with open("/dev/full", "w") as full:
        command = [*COMMAND, *words.split()]
        ended = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, check=False)
    assert ended.returncode == 1
    message = "error: cannot write to the standard output: No space left on device\n"
    assert ended.stderr.decode() == message


def test_a_closed_stream(case):
    out = case.with_name("out")
    script = f"{' '.join(COMMAND)} run {case} --output {out} --no-figures >&- 2>&-"
    assert subprocess.run(["sh", "-c", script], check=False).returncode == 0
    assert [path.name for path in out.iterdir()] == ["results.nc"]


def test_undecodable_file_names(capsysbinary):
    with guarded_output():
        print("results\udcff.nc", "σ", "½")
    assert capsysbinary.readouterr().out == "results?.nc σ ½\n".encode()


def test_streams_and_signals_are_restored(case):
    before = sys.stdout, sys.stderr, signal.getsignal(signal.SIGTERM)
    assert invoke("hertz", "--R", "1", "--E-star", "1", "--load", "1").exit_code == 0
    with pytest.raises(click.UsageError, match="modulus"):
        main.main(["hertz", "--R", "1"], standalone_mode=False)
    assert before == (sys.stdout, sys.stderr, signal.getsignal(signal.SIGTERM))
