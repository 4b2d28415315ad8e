# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress of long calls: a bar in a terminal, a few lines in a log."""

import io
import subprocess
import sys

import pytest

import samcontact as sc
from core_fakes import ELASTIC
from samcontact._util.progress import MAX_LINES, progress_bar


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.mark.parametrize("initial", [0, 3])
@pytest.mark.parametrize("total", [1, 7, 10, 11, 1000])
def test_a_log_gets_a_few_lines(total, initial, monkeypatch):
    log = io.StringIO()
    monkeypatch.setattr(sys, "stderr", log)
    with progress_bar(total, "increment", shown=True, initial=min(initial, total)) as bar:
        for _ in range(total - min(initial, total)):
            bar.update()
            bar.set_postfix(iterations=3)
    lines = log.getvalue().splitlines()
    assert len(lines) <= min(MAX_LINES, total)
    assert "\r" not in log.getvalue()
    if total > initial:
        assert lines[-1] == f"increment {total} of {total}"
    # more steps than expected, as in asperity collisions, cause no further output
    bar.update()
    assert log.getvalue().splitlines() == lines


def test_a_terminal_gets_a_bar(monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with progress_bar(2, "cycle", shown=True) as bar:
        bar.update()
        bar.update()
    assert "\r" in terminal.getvalue()
    assert "2/2" in terminal.getvalue()


def test_nothing_is_written_on_request_or_without_a_stream(monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with progress_bar(2, "cycle", shown=False) as bar:
        bar.update()
    assert terminal.getvalue() == ""
    monkeypatch.setattr(sys, "stderr", None)  # as under pythonw
    with progress_bar(2, "cycle", shown=True) as bar:
        bar.update(2)


def test_a_run_from_python_keeps_a_log_short(capsys):
    grid = sc.Grid(8, 8, 60e-6, 60e-6)
    simulation = sc.Simulation(grid, ELASTIC, ELASTIC, sc.surfaces.paraboloid(grid, 7.5e-3))
    simulation.run([{"load": 1.0 + n / 40} for n in range(40)])
    out, err = capsys.readouterr()
    assert out == ""
    assert err.splitlines() == [f"increment {4 * n} of 40" for n in range(1, 11)]


def test_the_progress_bar_is_not_loaded_without_need():
    code = "import sys, samcontact; sys.exit('tqdm' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
