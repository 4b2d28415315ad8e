# SPDX-License-Identifier: GPL-3.0-or-later
"""Scripts of runs to be killed; `computed(folder)` of each returns a digest of all results."""

from pathlib import Path

BEGIN = """
import hashlib, sys, warnings
import numpy as np
import samcontact as sc
warnings.simplefilter("ignore")
elastic = sc.Material.elastic(210e9, 0.3)
hard = sc.Material.elastic(300e9, 0.2)
steel = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
MU = sc.Coulomb(0.3)

def digest(*fields):
    data = b"".join(np.ascontiguousarray(field, dtype=float).tobytes() for field in fields)
    return hashlib.sha256(data).hexdigest()

def ball(cells=15, **more):
    grid = sc.Grid(cells, cells, 60e-6, 60e-6, dz=60e-6, **more)
    return grid, sc.surfaces.paraboloid(grid, 7.5e-3)

def of_states(states, slips=False):
    fields = [[s.load, s.approach] for s in states]
    fields += [f for s in states for f in (s.pressure, s.gap, s.shear, s.plastic_strain())]
    if slips:
        fields += [f for s in states for f in (s.slip, s.shift, [s.friction_work, s.twist])]
    return digest(*fields)

def followed(sim, path, folder, slips=False):
    return of_states(sim.run(path, progress=False, checkpoint=folder), slips)
"""
BODIES = {
    "fretting": """
def computed(folder):
    grid, gap = ball(11)
    path = [{"load": 500.0}, *sc.paths.fretting_loop(load=500.0, force=(60.0, 20.0), increments=1)]
    return followed(sc.Simulation(grid, hard, steel, gap, MU, on_border="warn"), path, folder, True)
""",
    "creepage": """
def computed(folder):
    grid, gap = ball()
    way = 60e-6
    path = [{"load": 400.0}, *4 * [{"load": 400.0, "advance": (-1.01 * way, -way), "twist": 1e-3}]]
    sim = sc.Simulation(grid, elastic, steel, gap, MU, on_border="warn")
    return followed(sim, path, folder, True)
""",
    "layers": """
def computed(folder):
    grid, gap = ball(12)
    z = [0.0, 300e-6]
    core = steel.with_yield_profile(z, [1.5, 1.0]).with_residual_stress(z, [-2e8, 0.0])
    body = sc.Layered([(hard, 60e-6)], core)
    path = [{"load": 300.0}, {"load": 600.0}, {"load": 0.0}]
    return followed(sc.Simulation(grid, elastic, body, gap, on_border="warn"), path, folder)
""",
    "zones": """
def computed(folder):
    from rough_setups import simulation, PERCENT
    sim = simulation()
    states = sim.run([{"load": q * PERCENT} for q in (0.5, 1.0)], progress=False,
                     checkpoint=folder)
    assert len(states[1].zones(2)) > 1
    return of_states(states)
""",
    "periodic zones": """
def computed(folder):
    from rough_setups import SIZE, rough_gap, simulation
    cells = 128
    gap = rough_gap(0.0, sc.Grid(cells, cells, SIZE, SIZE))
    sim = simulation(grid=sc.Grid(cells, cells, SIZE, SIZE, 8, SIZE, "xy"), gap=gap)
    whole = 0.003 * 4.2e9 * (cells * SIZE) ** 2
    states = sim.run([{"load": q * whole} for q in (0.5, 1.0)], progress=False,
                     checkpoint=folder)
    assert len(states[1].zones(2)) > 1
    return of_states(states)
""",
    "periodic": """
def computed(folder):
    grid, _ = ball(16, periodic="xy")
    rough = sc.surfaces.rough_self_affine(grid, 0.5e-6, 0.8, seed=3)
    table = sc.Material.tabulated(210e9, 0.3, [0.0, 1e-3, 0.02], [0.9e9, 1.1e9, 1.4e9])
    path = [{"load": 100.0}, {"load": 200.0}, {"load": 50.0}]
    return followed(sc.Simulation(grid, elastic, table, rough, MU), path, folder, True)
""",
    "heat of slip": """
def computed(folder):
    grid, gap = ball(11)
    warm = elastic.with_thermal(50.0, 12e-6, 1.4e-5)
    sim = sc.Simulation(grid, warm, warm, gap, MU, heat=sc.Heat(partition=0.5))
    loop = sc.paths.fretting_loop(load=300.0, shift=(2e-6, 0.0), increments=1)
    path = [step | {"duration": 1e-3} for step in [{"load": 300.0}, *loop]]
    return followed(sim, path, folder, True)
""",
    "shakedown": """
def computed(folder):
    grid, gap = ball(11)
    soft = sc.Material.perfect_plastic(210e9, 0.3, 1e9).with_kinematic_hardening(20e9)
    sim = sc.Simulation(grid, elastic, soft, gap, on_border="warn")
    found = sc.shakedown.run(sim, [{"load": 400.0}, {"load": 0.0}], cycles=6, progress=False,
                             checkpoint=folder)
    numbers = [[c.flow, c.net] for c in found.cycles]
    return digest(numbers, sim.state.plastic_strain(), sim.state.residual_stress())
""",
    "fretting wear": """
def computed(folder):
    grid, gap = ball()
    pulls = [{"load": 300.0, "tangential_load": (q, 0.0)} for q in (0.0, 50.0, -50.0, 50.0)]
    found = sc.wear.fretting(grid, elastic, elastic, gap, cycle=pulls, friction=MU, energy=1e-13,
                             cycles=4, repeats=200, checkpoint=folder + ".h5", progress=False)
    return digest(found.heights[2], [c.friction_work for c in found.cycles])
""",
    "accuracy": """
def computed(folder):
    body, surface = dict(law="elastic", E=210e9, nu=0.3), dict(shape="paraboloid", Rx=7e-3)
    case = dict(title="t", accuracy=0.2, quantities=["max_pressure"], path=[dict(load=300.0)],
                body1=body, body2=body, surface=surface)
    found = sc.to_accuracy(case, progress=False, checkpoint=folder)
    return digest(*(found.values[name] for name in sorted(found.values)),
                  *(found.errors[name] for name in sorted(found.errors)))
""",
    "adhesion": """
def computed(folder):
    grid = sc.Grid(16, 16, 1e-8, 1e-8, dz=1e-8)
    body = sc.Material.elastic(1e9, 0.3).with_relaxation([1.0], [0.4])
    law = sc.Adhesion.exponential(0.05, range=3e-9)
    sim = sc.Simulation(grid, sc.Material.rigid(), body, sc.surfaces.paraboloid(grid, 2e-7), MU,
                        adhesion=law, stiffness=10.0, on_border="warn")
    there = [-3e-9, 0.0, 2e-9, 0.0, -3e-9]
    path = [{"approach": z, "shift": (0.2 * z, 0.0), "duration": 0.3} for z in there]
    return followed(sim, path, folder, True)
""",
    "pull off": """
def computed(folder):
    grid = sc.Grid(20, 20, 1e-8, 1e-8, dz=1e-8)
    law = sc.Adhesion.exponential(0.05, range=2e-9)
    sim = sc.Simulation(grid, sc.Material.rigid(), sc.Material.elastic(1e9, 0.3),
                        sc.surfaces.paraboloid(grid, 2e-7), adhesion=law, on_border="warn")
    path = [{"load": 1e-7}, {"pull_off": sc.paths.Retraction(1e-9)}, {"approach": 0.0}]
    states = sim.run(path, progress=False, checkpoint=folder)
    assert len(states) > 8 and not states[-2].in_contact.any()
    return of_states(states)
""",
    "creep": """
def computed(folder):
    grid, gap = ball()
    rubber = sc.Material.elastic(10e6, 0.45).with_relaxation([0.1, 2.0], [0.3, 0.4])
    sim = sc.Simulation(grid, rubber, rubber, gap, MU, on_border="warn")
    steps = [(0.02, 0.0), (0.05, 0.2), (0.05, -0.1), (0.01, 0.1), (0.0, 0.0)]
    path = [{"load": w, "tangential_load": (0.3 * q * w, 0.0), "duration": 0.2} for w, q in steps]
    return followed(sim, path, folder, True)
""",
    "inclusion": """
def computed(folder):
    grid, gap = ball(16)
    oxide = sc.Inclusion.sphere((-130e-6, 0.0, 240e-6), 130e-6, hard, misfit=1e-3)
    pore = sc.Inclusion.void.sphere((250e-6, 0.0, 300e-6), 125e-6)
    body = sc.Heterogeneous(steel, [oxide, pore])
    path = [{"load": 400.0}, {"load": 800.0}, {"load": 0.0}]
    sim = sc.Simulation(grid, elastic, body, gap, tol=1e-3, on_border="warn")
    return followed(sim, path, folder)
""",
    "transient film": """
def computed(folder):
    grid, oil = sc.Grid(24, 16, 25e-6, 25e-6), sc.Lubricant.roelands(0.04, 22e-9)
    gap = sc.surfaces.paraboloid(grid, 0.01)
    film = sc.lubrication.steady(grid, elastic, elastic, gap, load=40.0, speed=(1.0, 1.0),
                                 lubricant=oil, tol=1e-4)
    dent = lambda x, y: -1e-7 * np.exp(-((x + 1e-4) ** 2 + y**2) / 4e-9)
    run = sc.lubrication.transient(film, duration=2e-4, steps=6, relief2=dent, tol=1e-4,
                                   load=lambda t: 40.0 * (1 + 500 * t), checkpoint=folder)
    return digest(run.time, run.film, run.pressure, *(one.content for one in run.solutions))
""",
    "pressed film": """
def computed(folder):
    grid, oil = sc.Grid(32, 22, 54e-6, 54e-6, 8, 60e-6), sc.Lubricant.roelands(0.1, 20e-9)
    sim = sc.Simulation(grid, elastic, steel, sc.surfaces.paraboloid(grid, 0.01), on_border="warn")
    films = sc.lubrication.press_loads(sim, loads=[600.0, 1100.0], speed=(4.0, 4.0), lubricant=oil,
                                       order=1, tol=1e-3, checkpoint=folder)
    assert films[1].plasticity.equivalent_plastic_strain.max() > 0
    stresses = [one.plasticity.von_mises for one in films]
    return digest(*(f for one in films for f in (one.film, one.pressure, one.gap)), *stresses,
                  sim.state.plastic_strain())
""",
    "roller": """
def computed(folder):
    grid = sc.Grid(8, 16, 30e-6, 75e-6, dz=30e-6)
    gap = sc.surfaces.roller(grid, 5e-3, 0.9e-3, "lundberg", design_load=500.0,
                             E_star=115e9, tilt=2e-4)
    ended = hard.with_free_faces(low=-0.45e-3, high=0.45e-3)
    path = [{"load": q, "moment": (1e-5 * q, None)} for q in (200.0, 500.0, 0.0)]
    sim = sc.Simulation(grid, steel, ended, gap, on_border="warn")
    return followed(sim, path, folder)
""",
    "coated": """
def computed(folder):
    grid, gap = ball(12)
    soft, stiff = (sc.Material.elastic(E, 0.35).with_relaxation([0.1], [0.5]) for E in (3e9, 9e9))
    body = sc.Layered([(soft, 60e-6)], stiff)
    path = [{"load": w, "duration": 0.1} for w in (50.0, 100.0, 20.0)]
    sim = sc.Simulation(grid, elastic, body, gap, MU, on_border="warn")
    return followed(sim, path, folder, True)
""",
    "found load": """
def computed(folder):
    def problem(load):
        grid = sc.Grid(8, 8, 120e-6, 120e-6, dz=120e-6)
        gap = sc.surfaces.paraboloid(grid, 7.5e-3)
        return sc.Simulation(grid, elastic, steel, gap, on_border="warn"), [{"load": load}]
    found = sc.find_load(problem, "max_equivalent_plastic_strain", 5e-4, tolerance=0.1,
                         largest_load=1200.0, progress=False, checkpoint=folder)
    return digest([found.load, found.value, found.load_error])
""",
}
ANY = (
    BEGIN
    + f"""
import itertools, locale, os, pathlib, resource, signal, time
import h5py, scipy.ndimage, scipy.optimize, scipy.special, samcontact.cases  # once for all
from unittest import mock
from samcontact._util import memory as _memory
from samcontact.restart import lock
sys.path.insert(0, {str(Path(__file__).parents[1])!r})
# The influence of free faces is computed once in a process.
sc.Simulation(sc.Grid(2, 4, 1e-5, 1e-5, dz=1e-5), steel,
              hard.with_free_faces(low=-2e-5, high=2e-5), np.zeros((2, 4)))
KINDS = {BODIES!r}

def computed(argument):
    kind, way, folder = argument.split("|")
    signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))  # a batch script's
    space = dict(globals())
    exec(KINDS[kind], space)
    word, _, amount = way.partition(" ")
    if word == "disk":
        resource.setrlimit(resource.RLIMIT_FSIZE, (int(amount), resource.RLIM_INFINITY))
    if word == "clock":
        time.time = itertools.count(float(amount), -3600.0).__next__
    if word == "locale":
        os.environ["LOCPATH"] = amount
        locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
        assert locale.localeconv()["decimal_point"] == ","
    if word == "twice":
        return refused(space["computed"], folder)
    if word == "memory":
        return poor(space["computed"], folder, float(amount))
    return space["computed"](folder)

def poor(run, folder, there):
    require, requested = _memory.require, [0.0]
    def report(what, needed, *more):
        requested.append(needed)
        with mock.patch.object(_memory, "available", lambda: there):
            require(what, needed, *more)
    _memory._MAX_UNCHECKED_BYTES, _memory.require = 0.0, report
    try:
        return f"{{run(folder)}} {{max(requested)}}"
    except (MemoryError, ValueError) as error:
        return str(error)

def refused(run, folder):
    taken, messages = lock._take, []
    def take(*arguments):
        handle = taken(*arguments)
        if not messages:
            messages.append("")
            try:
                run(folder)
            except OSError as error:
                messages.append(str(error))
        return handle
    lock._take = take
    return run(folder) + " " + messages[-1]
"""
)
"""Script for a run of any kind: `computed("kind|way|folder")`. The way is empty, or one of
"disk BYTES": the largest size of a file;
"clock SECONDS": a clock that is set back by an hour whenever it is read;
"locale FOLDER": a locale in this folder, with decimal comma;
"twice": a second run starts in the folder, and its error follows the digest;
"memory BYTES": available memory; the largest request, or the error, follows the digest."""
