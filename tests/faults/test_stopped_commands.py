# SPDX-License-Identifier: GPL-3.0-or-later
"""A command stopped during or after an increment resumes with bit-identical results."""

import contextlib
import hashlib
import json
import random
import signal

import pytest
import xarray as xr
from faulting import Nursery, with_trials

from case_texts import GRID, MINIMAL, SCAR, SWIFT, WEAR

BALL = """
body1 = {law = "elastic", E = 210e9, nu = 0.3}
surface = {shape = "paraboloid", Rx = 7.5e-3}
"""
FLAT = 'body2 = {law = "elastic", E = 210e9, nu = 0.3}'
STEEL = f"body2 = {{{', '.join(SWIFT.splitlines())}}}"
SMALL_GRID = "nx = 8, ny = 8, dx = 120e-6, dy = 120e-6, nz = 6, dz = 120e-6"
TWO_BALLS = MINIMAL.replace(GRID, f"[grid]\n{SMALL_GRID.replace(', ', chr(10))}")
# A case of each kind of run, and how many increments a resumed run may solve again.
KINDS = {
    "shakedown": (f"estimate_error = false\n{TWO_BALLS}[shakedown]\ncycles = 3\ntol = 0.002\n", 3),
    "fatigue": (f'{TWO_BALLS}[fatigue]\ndang_van = 0.3\northogonal_shear = "y"\n', 3),
    "accuracy": (
        f'title = "to 20 %"\naccuracy = {{max_pressure = 0.2}}\n{BALL}{FLAT}\n'
        "path = [{load = 100.0}, {load = 400.0}]\n",
        2,
    ),
    "wear": (WEAR.replace("cycles = 1", "cycles = 2"), 2),
    "fretting wear": (SCAR.replace("20000", "2000"), 6),
    "fretting": (
        f'title = "to and fro"\nestimate_error = false\ngrid = {{{SMALL_GRID}}}\n{BALL}{STEEL}\n'
        'contact = {friction = {coulomb = 0.3}, on_border = "warn"}\n'
        "path = [{load = 400.0, increments = 1},"
        " {load = 400.0, increments = 1, fret = {tangential_load_x = 60.0}}]\n",
        0,
    ),
    "found load": (
        'title = "searched"\n'
        f"grid = {{{SMALL_GRID}}}\n"
        f'contact = {{on_border = "warn"}}\n{BALL}{STEEL}\npath = [{{load = 900.0}}]\n',
        1,
    ),
}
FIRST = f"""title = "first"
grid = {{nx = 8, ny = 8, dx = 120e-6, dy = 120e-6}}
{BALL}{FLAT}
path = [{{load = 10.0}}]
"""
COMMAND = (
    f"FIRST = {FIRST!r}"
    + """
import importlib, json, os, pathlib, tempfile
from click.testing import CliRunner
import samcontact as sc
from samcontact import results
from samcontact.simulation import increment_errors
from samcontact.commands.main import main
import samcontact.commands.solve_contact, samcontact.commands.solve_study
find = importlib.import_module("samcontact.accuracy.load_search")
made = {"step": 0, "end": 0}
increment_errors.estimated = lambda *_, **__: None  # whose steps are those of no path

with tempfile.TemporaryDirectory() as folder:  # loads for all what the first run loads
    case = pathlib.Path(folder, "case.toml")
    case.write_text(FIRST)
    CliRunner().invoke(main, ["run", str(case), "--output", folder, "--no-figures"])

def counted(owner, name, kind, place, number):
    call = getattr(owner, name)
    def counting(*arguments, **named):
        made[kind] += 1
        if f"{kind} {made[kind]}" == place:
            os.kill(os.getpid(), int(number))
        return call(*arguments, **named)
    setattr(owner, name, counting)

def computed(argument):
    place, number, *words = argument.split("|")
    counted(sc.Simulation, "step", "step", place, number)
    for owner, name in ((results, "save"), (find, "estimated")):
        counted(owner, name, "end", place, number)
    outcome = CliRunner().invoke(main, words)
    return json.dumps([outcome.exit_code, outcome.stdout, outcome.stderr, *made.values()])
"""
)


@pytest.fixture(scope="module")
def nursery():
    with contextlib.closing(Nursery(COMMAND)) as made:
        yield made


class Stopped:
    """Commands of one case in one folder, which get a signal at a given point."""

    def __init__(self, nursery, kind, folder):
        text, self.spare = KINDS[kind]
        folder.mkdir()
        self.nursery, self.out, self.case = nursery, folder / "out", folder / "case.toml"
        self.searches = kind == "found load"
        self.case.write_text(
            f'{text}output = {{directory = "{self.out}"}}' if self.searches else text
        )

    def run(self, place="", number=0):
        """Return exit code, standard output and error, and numbers of calls of step and output."""
        if self.searches:
            words = [
                "find",
                self.case,
                "max_equivalent_plastic_strain=0.0005",
                "--tolerance",
                "0.1",
            ]
        elif (self.out / "checkpoints" / "case.txt").exists():
            words = ["resume", self.out, "--no-figures"]
        else:
            words = ["run", self.case, "--output", self.out, "--no-figures"]
        message, _ = self.nursery.run("|".join(map(str, [place, number, *words, "--quiet"])))
        return json.loads(message)

    def left(self):
        """Return the names of all files; empty for a load search."""
        return sorted(str(file.relative_to(self.out)) for file in self.out.rglob("*"))

    def contents(self):
        """Return digests of the stored numbers."""
        found = {}
        for file in sorted(self.out.glob("*.nc")):
            with xr.open_dataset(file) as data:
                parts = b"".join(data[n].values.tobytes() for n in sorted(data.data_vars))
            found[file.name] = hashlib.sha256(parts).hexdigest()
        return found


@with_trials("stop: command")
@pytest.mark.parametrize(
    "kind", [pytest.param(kind, marks=[pytest.mark.slow] * (kind == "wear")) for kind in KINDS]
)
def test_a_stopped_command_resumes_with_identical_bits(kind, nursery, tmp_path, count):
    whole = Stopped(nursery, kind, tmp_path / "whole")
    code, output, errors, steps, ends = whole.run()
    assert code == 0, errors
    places = random.Random(f"stopped {kind}")
    for trial in range(count):
        stopped = Stopped(nursery, kind, tmp_path / f"trial{trial}")
        signals = places.sample([signal.SIGTERM, signal.SIGINT], 2)
        # the latest place first
        step, end = (places.randint(2, steps), places.randint(1, ends)) if trial else (steps, ends)
        moments = f"step {step}", f"end {end}"
        done = 0
        for place, number in zip(moments, signals, strict=True):
            code, _, errors, made, _ = stopped.run(place, int(number))
            assert code == 128 + number, errors
            message = (
                "progress saved in" if stopped.searches else f"samcontact resume {stopped.out}"
            )
            assert message in errors
            done += made
        code, last, errors, again, _ = stopped.run()
        assert code == 0, errors
        assert done + again <= steps + 1 + 2 * stopped.spare
        assert last.replace(str(stopped.out), str(whole.out)) == output
        assert stopped.contents() == whole.contents()
        assert stopped.left() == whole.left()
