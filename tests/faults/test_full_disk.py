# SPDX-License-Identifier: GPL-3.0-or-later
"""A disk that fills up during a write: only the old file is kept.

A limit on the file size makes the same system calls fail at a chosen byte, for any
user; in a separate process, which would also reveal a crash at its end.
"""

from faulting import start, with_trials

SCRIPT = """
import errno, os, resource, signal, sys, warnings
import numpy as np, xarray as xr
import samcontact as sc
from samcontact import report, results
warnings.simplefilter("ignore")
report.contact.contact_figures = lambda *_: []  # they take a second
count = int(sys.argv[2])
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
grid = sc.Grid(11, 11, 80e-6, 80e-6, 8, 80e-6)
sim = sc.Simulation(grid, sc.Material.elastic(210e9, 0.3), steel,
                    sc.surfaces.paraboloid(grid, 7.5e-3))
first = sim.step(load=500.0)
second = sim.step(load=600.0)
old, new = (results.to_dataset(sim, [state]) for state in (first, second))
writers = {
    "h5": lambda now: sim.save(path),
    "nc": lambda now: results.save(new if now else old, path),
    "html": lambda now: report.write(new if now else old, path),
}
for kind, write in writers.items():
    folder = os.path.join(sys.argv[1], kind)
    os.mkdir(folder)
    path = os.path.join(folder, "file." + kind)
    write(False)
    before = open(path, "rb").read()
    failed = 0
    for trial in range(count):
        limit = int((trial + 0.5) / count * len(before))
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY))
        try:
            write(True)
        except OSError as error:
            assert error.errno == errno.EFBIG, error
            assert error.filename == path, error
            assert path in str(error)
            failed += 1
        resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY,) * 2)
        assert open(path, "rb").read() == before
        assert os.listdir(folder) == [os.path.basename(path)]
    assert failed == count
    write(True)
    assert open(path, "rb").read() != before or kind == "h5"
    print(kind, "survived", failed)
"""


@with_trials("full disk")
def test_a_failed_write_keeps_the_old_file(tmp_path, count):
    """Checkpoints, results and reports."""
    with start(SCRIPT, tmp_path, count) as process:
        output, errors = process.communicate()
    assert (process.returncode, errors) == (0, "")
    assert output == "".join(f"{kind} survived {count}\n" for kind in ("h5", "nc", "html"))


JOURNAL = """
import resource, signal, sys, warnings
import samcontact as sc
warnings.simplefilter("ignore")
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
grid = sc.Grid(15, 15, 60e-6, 60e-6, 12, 60e-6)

def problem():
    return sc.Simulation(grid, sc.Material.elastic(210e9, 0.3), steel,
                         sc.surfaces.paraboloid(grid, 7.5e-3))

path = [{"load": 100.0}, {"load": 500.0}, {"load": 600.0}]
resource.setrlimit(resource.RLIMIT_FSIZE, (25_000, resource.RLIM_INFINITY))
sim = problem()
try:
    sim.run(path, progress=False, checkpoint=sys.argv[1])
    raise SystemExit("all was written")
except OSError as error:
    assert "increment_0000" in str(error), error
    done = error.states
assert 1 <= len(done) < 3
assert sim.state.load == done[-1].load
resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY,) * 2)
again = problem().run(path, progress=False, checkpoint=sys.argv[1])
alone = problem().run(path, progress=False)
for one, other in zip(again, alone, strict=True):
    assert one.pressure.tobytes() == other.pressure.tobytes()
    assert one.plastic_strain().tobytes() == other.plastic_strain().tobytes()
print("survived")
"""


def test_a_run_resumes_when_disk_space_is_available_again(tmp_path):
    with start(JOURNAL, tmp_path / "kept") as process:
        output, errors = process.communicate()
    assert (process.returncode, errors, output) == (0, "", "survived\n")
