# SPDX-License-Identifier: GPL-3.0-or-later
"""Arbitrary arguments: the core computes, or raises a documented error.

The bindings are called through the public functions and classes; a crash would end the process.
"""

import warnings

import numpy as np
from fuzzing import tried, try_all, unless_refused
from hypothesis import strategies as st

import samcontact as sc
from samcontact import dents, hertz, operators, surfaces

REFUSED = (ValueError, TypeError, sc.ConvergenceError, MemoryError)
STEEL = sc.Material.swift(210e9, 0.3, 945e6, 20.0, 0.121)
ELASTIC = sc.Material.elastic(210e9, 0.3)

tame = st.sampled_from([1e-6, 1e-5, 0.3, 1.0, 2.0, 210e9])
wild = st.one_of(
    tame,
    tame,
    tame,
    st.floats(),
    st.sampled_from([0, -1, 1, True, None, "1", 1j, 2**40, -(2**70), np.nan, np.inf]),
    st.sampled_from([np.float32(0.3), np.int64(3), np.array(0.3), np.array([1.0, 2.0]), [1.0]]),
)
counts = st.one_of(
    st.integers(1, 7),
    st.integers(1, 7),
    st.sampled_from([0, -1, 1.5, True, "3", None, 2**24, 2**31 - 1, 2**31, 2**63, np.int8(4)]),
)
few_iterations = counts.filter(lambda n: not isinstance(n, int) or n < 1000)  # takes its time
fill = st.one_of(
    st.floats(0, 1e9),
    st.sampled_from([0.0, 1.0, 1e-7, 1e-3, -1.0, 1e308, -1e308, 5e-324, np.nan, np.inf]),
)
OTHER_TYPES = ("f4", "i4", "U", "O", ">f8")


@st.composite
def arrays(draw, *shapes):
    """Draw an array, mostly of one of these shapes, of any values, layout and type."""
    shape = draw(st.sampled_from(shapes))
    if draw(st.integers(0, 7)) == 0:
        shape = draw(st.lists(st.integers(0, 4), max_size=4).map(tuple))
    values = np.full(shape, draw(fill))
    kind = draw(st.sampled_from(["constant", "noise", "one", "mixed"]))
    with np.errstate(all="ignore"):
        if kind == "noise":
            values = values * np.random.default_rng(draw(st.integers(0, 9))).random(shape)
        if kind == "one" and values.size:
            values = np.zeros(shape)
            values.flat[draw(st.integers(0, values.size - 1))] = draw(fill)
        if kind == "mixed" and values.size:
            values.flat[draw(st.integers(0, values.size - 1))] = draw(fill)
        layout = draw(
            st.sampled_from(["C", "C", "F", "stride", "list", "f4", "i4", "U", "O", ">f8"])
        )
        if layout == "F":
            return np.asfortranarray(values)
        if layout == "stride":
            return np.repeat(values, 2, axis=-1)[..., ::2] if values.ndim else values
        if layout == "list":
            return values.tolist()
        if layout in OTHER_TYPES:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                return values.astype(layout)
    return values


@tried("arguments of the grid, materials and surfaces")
def test_small_things(count):
    grid = sc.Grid(5, 6, 1e-5, 1e-5, 3, 1e-5)
    calls = {
        "grid": lambda n, x: sc.Grid(n[0], n[1], x[0], x[1], n[2], x[2]).surface_shape,
        "elastic": lambda n, x: sc.Material.elastic(x[0], x[1]),
        "linear": lambda n, x: sc.Material.linear_hardening(*x[:4]),
        "swift": lambda n, x: sc.Material.swift(*x[:5]),
        "voce": lambda n, x: sc.Material.voce(*x[:5]).plastic_work(1e-3),
        "tabulated": lambda n, x: sc.Material.tabulated(x[0], x[1], [0.0, x[2]], x[3:5]),
        "kinematic": lambda n, x: STEEL.with_kinematic_hardening(x[0], x[1]),
        "thermal": lambda n, x: STEEL.with_thermal(x[0], x[1], x[2]),
        "paraboloid": lambda n, x: surfaces.paraboloid(grid, x[0], x[1]),
        "sphere": lambda n, x: surfaces.sphere(grid, x[0]),
        "cylinder": lambda n, x: surfaces.cylinder(grid, x[0]),
        "sinusoidal": lambda n, x: surfaces.sinusoidal(grid, x[0], x[1], x[2]),
        "rough": lambda n, x: surfaces.rough_self_affine(grid, x[0], x[1], seed=n[0]),
        "dent": lambda n, x: dents.spherical(grid, x[0], x[1], x[2], x[3]),
        "furrow": lambda n, x: dents.furrow(grid, x[0], x[1], "y", x[2]),
        "point": lambda n, x: hertz.point(R=x[0], E_star=x[1], load=x[2]),
        "elliptic": lambda n, x: hertz.elliptic(x[0], x[1], x[2], load=x[3]),
        "ramp": lambda n, x: sc.paths.ramp(load=x[0], increments=n[0], start=x[1]),
        "rolling": lambda n, x: sc.paths.rolling(
            load=x[0], distance=x[1], step=x[2], passes=n[0], increments=n[1]
        ),
    }

    def check(name, n, x):
        with np.errstate(all="ignore"):
            unless_refused(lambda: calls[name](n, x), REFUSED)

    try_all(
        check,
        count,
        name=st.sampled_from(sorted(calls)),
        n=st.lists(counts, min_size=3, max_size=3),
        x=st.lists(wild, min_size=5, max_size=5),
    )


@tried("arguments of operators")
def test_operators(count):
    grid, flat = sc.Grid(5, 6, 1e-5, 1e-5, 3, 1e-5), sc.Grid(5, 6, 1e-5, 1e-5)
    calls = {
        "displacement": lambda g, p, e, x: operators.surface_displacement(g, p, x[0], x[1]),
        "sheared": lambda g, p, e, x: operators.surface_displacement(g, p, 2e11, x[0], e),
        "stress": lambda g, p, e, x: operators.surface_stress(g, p, x[0], x[1], p),
        "depths": lambda g, p, e, x: operators.surface_stress(g, p, e, 0.3),
        "residual": lambda g, p, e, x: operators.residual_stress(g, e, x[0], x[1]),
        "fast": lambda g, p, e, x: operators.residual_stress(
            g, e, 2e11, x[0], method="fast", image_tol=x[1]
        ),
        "print": lambda g, p, e, x: operators.residual_displacement(g, e, x[0]),
    }

    def check(name, where, pressure, strain, x):
        with np.errstate(all="ignore"):
            field = unless_refused(lambda: calls[name](where, pressure, strain, x), REFUSED)
        assert field is None or field.dtype == np.float64

    try_all(
        check,
        count,
        name=st.sampled_from(sorted(calls)),
        where=st.sampled_from([grid, grid, flat]),
        pressure=arrays((5, 6)),
        strain=arrays((6, 5, 6, 3), (2, 5, 6), (4,)),
        x=st.lists(wild, min_size=2, max_size=2),
    )


@tried("arguments of contacts")
def test_contacts(count):
    grid = sc.Grid(7, 6, 1e-5, 1e-5)
    dent = surfaces.paraboloid(grid, 1e-3)

    def solve(gap, x, settings, start):
        settings = dict(settings)
        if "heat" in settings:
            settings["heat"] = sc.Heat(**settings["heat"])
        solver = sc.ContactSolver(grid, ELASTIC, ELASTIC, x[0], on_border="warn", **settings)
        return solver.solve(gap, initial_pressure=start, **{x[2]: x[1]})

    def check(gap, x, settings, start):
        gap = dent if gap is None else gap
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore", sc.GridTooSmallWarning)
            solution = unless_refused(lambda: solve(gap, x, settings, start), REFUSED)
        if solution is not None:
            assert solution.converged
            assert np.isfinite(solution.pressure).all()
            assert solution.pressure.min() >= 0

    try_all(
        check,
        count,
        gap=st.one_of(st.none(), arrays((7, 6))),
        x=st.tuples(
            st.one_of(st.just(0.0), wild), wild, st.sampled_from(["load", "load", "approach"])
        ),
        settings=st.fixed_dictionaries(
            {},
            optional={
                "tol": wild,
                "max_iterations": few_iterations,
                "heat": st.fixed_dictionaries(
                    {"factor": wild}, optional={"time": wild, "reference": wild}
                ),
            },
        ),
        start=st.one_of(st.none(), arrays((7, 6))),
    )


@tried("arguments of steps")
def test_steps(count):
    """After a refused step the simulation continues like a new one."""
    grid = sc.Grid(7, 7, 1e-4, 1e-4, 5, 1e-4)
    gap = surfaces.paraboloid(grid, 7.5e-3)

    def scene():
        return sc.Simulation(grid, ELASTIC, STEEL, gap, on_border="warn", tol=1e-4)

    def last(simulation):
        state = simulation.step(load=500.0)
        return state.pressure.tobytes() + state.plastic_strain().tobytes()

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", sc.GridTooSmallWarning)
        expected = last(scene())

    def check(arguments, strain):
        simulation = scene()
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore", (sc.GridTooSmallWarning))
            warnings.simplefilter("ignore", sc.PlasticStrainWarning)
            warnings.simplefilter("ignore", sc.IncrementWarning)
            if strain is not None:
                given = (2, strain) if isinstance(strain, np.ndarray) else strain
                unless_refused(lambda: simulation.set_plastic_strain(*given), REFUSED)
                return
            state = unless_refused(lambda: simulation.step(**arguments), REFUSED)
            if state is None:
                assert last(simulation) == expected
            else:
                assert np.isfinite(state.pressure).all()

    try_all(
        check,
        count,
        arguments=st.fixed_dictionaries(
            {},
            optional={
                "load": st.one_of(st.floats(0, 1000), st.floats(0, 1000), wild),
                "approach": wild,
                "pressure": arrays((7, 7)),
                "shear": arrays((7, 7), (2, 7, 7)),
                "advance": st.one_of(
                    st.tuples(wild, wild), st.sampled_from([(1e-4, 0.0), (3e-5, -1e-4), (1e300, 0)])
                ),
                "duration": wild,
                "heat_factor": wild,
            },
        ),
        strain=st.one_of(
            st.none(), st.none(), arrays((6, 7, 7, 5)), st.tuples(counts, arrays((6, 7, 7, 5)))
        ),
    )
