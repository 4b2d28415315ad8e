# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures: the data shown by artists, in displayed units, and the written files."""

import subprocess
import sys

import matplotlib
import numpy as np
import pytest
from drawn_fields import drawn_values, shows
from matplotlib.contour import QuadContourSet
from matplotlib.figure import Figure

from core_fakes import ELASTIC, SWIFT, FakeState, make_grid, make_simulation
from samcontact import ContactSolver, Grid, Simulation, hertz, plotting, surfaces
from samcontact._util.tensors import von_mises
from samcontact.plotting.parts import new_figure, save
from samcontact.results import to_dataset

E_STAR = 115384615384.6154


@pytest.fixture
def simulation():
    return make_simulation()


@pytest.fixture
def state(simulation):
    return FakeState(simulation.grid, 1500.0)


@pytest.fixture
def ax():
    return Figure().subplots()


def shown_label(ax):
    """Return the label of the colour bar, or the title if the section is flat."""
    return ax.get_title() or ax.figure.axes[1].get_ylabel()


def lines(ax):
    return {line.get_label(): line.get_xydata() for line in ax.get_lines()}


@pytest.mark.parametrize("axis", ["x", "y"])
def test_pressure_profile_shows_the_central_row_and_hertz(state, simulation, ax, axis):
    contact = hertz.point(7.5e-3, E_STAR, load=1500.0)
    shown = plotting.pressure_profile(state.pressure, simulation.grid, ax, hertz=contact, axis=axis)
    assert shown is ax
    drawn = lines(ax)
    row = state.pressure[:, 4] if axis == "x" else state.pressure[5, :]
    coordinates = simulation.grid.x if axis == "x" else simulation.grid.y
    np.testing.assert_allclose(drawn["computed"][:, 0], coordinates * 1e6)
    np.testing.assert_allclose(drawn["computed"][:, 1], row * 1e-9)
    # the fake state is Hertz contact: both curves agree where both are drawn
    np.testing.assert_allclose(
        np.interp(coordinates * 1e6, *drawn["Hertz"].T), row * 1e-9, atol=2e-2
    )
    assert ax.get_xlabel() == f"{axis} [µm]"
    assert ax.get_ylabel() == "pressure [GPa]"


def test_hertz_follows_the_row_of_cells_of_an_even_grid(ax):
    grid = make_grid(nx=10, ny=8)
    contact = hertz.point(7.5e-3, E_STAR, load=1500.0)
    plotting.pressure_profile(FakeState(grid, 1500.0).pressure, grid, ax, hertz=contact)
    peak = lines(ax)["Hertz"][:, 1].max()
    assert peak == pytest.approx(float(contact.pressure(0.0, grid.dy / 2)) * 1e-9, rel=1e-12)


def test_section_shows_the_plane_with_depth_downward(state, simulation, ax):
    grid = simulation.grid
    field = state.von_mises(body=2)
    plotting.section(field, grid, ax, quantity="von_mises", cells=True)
    (mesh,) = ax.collections
    np.testing.assert_allclose(mesh.get_array(), field[:, 4, :].T * 1e-6)
    corners = mesh.get_coordinates()
    assert corners[0, 0, 0] == pytest.approx((grid.x[0] - grid.dx / 2) * 1e6)
    assert corners[0, 0, 1] == 0.0
    assert corners[-1, 0, 1] == pytest.approx(grid.nz * grid.dz * 1e6)
    assert ax.yaxis_inverted()
    assert shown_label(ax) == "von Mises stress [MPa]"


def test_section_of_the_other_plane_and_signed_colours(state, simulation, ax):
    grid = simulation.grid
    field = state.hydrostatic(body=2)
    plotting.section(
        field, grid, ax, quantity="hydrostatic", plane="x", position=grid.x[2], cells=True
    )
    (mesh,) = ax.collections
    np.testing.assert_allclose(mesh.get_array(), field[2].T * 1e-6)
    assert mesh.norm.vmax == -mesh.norm.vmin == pytest.approx(np.abs(field[2]).max() * 1e-6)
    assert ax.get_xlabel() == "y [µm]"


def test_strain_in_percent(state, simulation, ax):
    field = state.equivalent_plastic_strain(body=2)
    plotting.section(field, simulation.grid, ax, quantity="equivalent_plastic_strain", cells=True)
    np.testing.assert_allclose(ax.collections[0].get_array(), field[:, 4, :].T * 100)
    assert "[%]" in shown_label(ax)


def test_no_grid_lines_over_colours(state, simulation):
    with matplotlib.rc_context({"axes.grid": True}):
        ax = Figure().subplots()
    plotting.section(state.von_mises(), simulation.grid, ax, quantity="von_mises")
    assert not any(line.get_visible() for line in [*ax.get_xgridlines(), *ax.get_ygridlines()])


def test_a_zero_field_is_labelled(simulation, ax):
    grid = simulation.grid
    for quantity in ("equivalent_plastic_strain", "hydrostatic"):
        ax = Figure().subplots()
        plotting.section(np.zeros((grid.nx, grid.ny, grid.nz)), grid, ax, quantity=quantity)
        assert ax.texts[0].get_text() == "identically\nzero"
        assert len(ax.figure.axes) == 1  # no scale
        assert ax.get_title() != ""


@pytest.mark.parametrize("layers", [2, 12])
def test_the_label_of_a_section_fits(layers, ax):
    grid = make_grid(nz=layers, dz=1e-4)
    plotting.section(1e6 * np.ones((grid.nx, grid.ny, grid.nz)), grid, ax, quantity="von_mises")
    bar_label = ax.figure.axes[1].get_ylabel()
    assert (ax.get_title(), bar_label)[layers > 5] == "von Mises stress [MPa]"
    assert (ax.get_title(), bar_label)[layers < 5] == ""


@pytest.mark.parametrize("known", [True, False])
def test_maps_of_the_surface(simulation, known):
    grid = simulation.grid
    state = FakeState(grid, 1500.0)
    touching = state.pressure > 0
    state.gap = np.where(touching, 1e-15, 1e-6 * (1.0 + grid.x[:, None] + grid.y))
    printed = state.residual_displacement(body=2)
    fields = {"pressure": state.pressure, "gap": state.gap, "imprint": printed}
    expected = {
        "pressure": np.where(touching, state.pressure * 1e-9, np.nan),
        "gap": np.where(touching, np.nan, state.gap * 1e6),
        "imprint": printed * 1e6,
    }
    for quantity, field in fields.items():
        contact = touching if known else None
        ax = plotting.surface_map(field, grid, quantity=quantity, contact=contact, cells=True)
        (mesh,) = ax.collections
        shown = np.ma.filled(mesh.get_array().astype(float), np.nan)
        np.testing.assert_allclose(shown, expected[quantity].T)
    assert ax.get_title() == "residual displacement [µm]"
    with pytest.raises(ValueError, match="quantity must be one of 'pressure', 'gap', 'imprint'"):
        plotting.surface_map(state.gap, grid, quantity="shear")


def test_load_approach(simulation, ax):
    states = [FakeState(simulation.grid, load) for load in (100.0, 800.0, 0.0)]
    contact = hertz.point(7.5e-3, E_STAR, load=123.0)
    plotting.load_approach(to_dataset(simulation, states), ax, hertz=contact)
    drawn = lines(ax)
    np.testing.assert_allclose(drawn["increments"][:, 1], [100.0, 800.0, 0.0])
    np.testing.assert_allclose(drawn["increments"][:, 0], [s.approach * 1e6 for s in states])
    styles = {line.get_label(): line.get_linestyle() for line in ax.get_lines()}
    assert styles == {"_between": "-", "increments": "None", "Hertz": "--"}
    elastic = contact.load * (drawn["_between"][:, 0] * 1e-6 / contact.approach) ** 1.5
    np.testing.assert_allclose(drawn["_between"][:, 1], elastic, atol=1e-9)
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["increments", "Hertz"]
    assert drawn["Hertz"][-1, 1] == pytest.approx(800.0, rel=1e-12)  # states are Hertz contacts


def test_imprint_profile(state, simulation, ax):
    field = state.residual_displacement(body=1)
    plotting.imprint_profile(field, simulation.grid, ax, label="body 1")
    field = state.residual_displacement(body=2)
    plotting.imprint_profile(field, simulation.grid, ax, label="body 2")
    drawn = lines(ax)
    np.testing.assert_allclose(drawn["body 1"][:, 1], 0.1 * np.arange(11))
    np.testing.assert_allclose(drawn["body 2"][:, 1], 0.2 * np.arange(11))
    assert ax.yaxis_inverted()


def test_temperature_profile(simulation, ax):
    field = np.add.outer(np.arange(11.0), 100.0 * np.arange(9.0))
    plotting.temperature_profile(field, simulation.grid, ax, label="along x")
    plotting.temperature_profile(field, simulation.grid, ax, axis="y", label="along y")
    drawn = lines(ax)
    np.testing.assert_allclose(drawn["along x"][:, 0], simulation.grid.x * 1e6)
    np.testing.assert_allclose(drawn["along x"][:, 1], field[:, 4])
    np.testing.assert_allclose(drawn["along y"][:, 1], field[5])
    assert ax.get_ylabel() == "temperature rise [K]"


def test_temperature_of_the_wrong_shape(simulation, ax):
    with pytest.raises(ValueError, match="temperature"):
        plotting.temperature_profile(np.zeros((2, 3)), simulation.grid, ax)


def test_section_of_temperature(simulation, ax):
    grid = simulation.grid
    field = np.arange(float(grid.nx * grid.ny * grid.nz)).reshape(grid.nx, grid.ny, grid.nz)
    plotting.section(field, grid, ax, quantity="temperature", cells=True)
    np.testing.assert_allclose(ax.collections[0].get_array(), field[:, 4, :].T)
    assert shown_label(ax) == "temperature rise [K]"


def test_axis_profile(state, simulation, ax):
    plotting.axis_profile(
        state.stress(), simulation.grid, ax, components=("von_mises", "hydrostatic", "zz")
    )
    first, mean, second = ax.get_lines()
    np.testing.assert_allclose(first.get_ydata(), simulation.grid.z * 1e6)
    stress = state.stress()[:, 5, 4]
    np.testing.assert_allclose(first.get_xdata(), von_mises(stress) * 1e-6)
    np.testing.assert_allclose(mean.get_xdata(), stress[:3].mean(axis=0) * 1e-6)
    np.testing.assert_allclose(second.get_xdata(), state.stress()[2, 5, 4] * 1e-6)
    assert ax.yaxis_inverted()


def test_axis_profile_names_its_components(state, simulation, ax):
    names = ("xx", "yy", "zz", "yz", "xz", "xy")
    plotting.axis_profile(state.stress(), simulation.grid, ax, components=names)
    for index, (name, line) in enumerate(zip(names, ax.get_lines(), strict=True)):
        assert name in line.get_label()
        np.testing.assert_allclose(line.get_xdata(), state.stress()[index, 5, 4] * 1e-6)


def test_new_figure_without_pyplot():
    code = (
        "import sys; from samcontact import plotting; sys.exit('matplotlib.pyplot' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_new_axes_are_made_when_none_are_given(state, simulation):
    grid = simulation.grid
    for ax in (
        plotting.pressure_profile(state.pressure, grid),
        plotting.section(state.von_mises(), grid),
        plotting.load_approach(to_dataset(simulation, [state])),
        plotting.imprint_profile(state.gap, grid),
        plotting.axis_profile(state.stress(), grid),
    ):
        assert ax.figure.get_layout_engine() is not None


def test_bad_input_is_named(state, simulation, ax):
    grid = simulation.grid
    with pytest.raises(ValueError, match=r"pressure must have shape \(11, 9\), got \(3, 3\)"):
        plotting.pressure_profile(np.zeros((3, 3)), grid, ax)
    with pytest.raises(ValueError, match="axis must be one of 'x', 'y', got 'z'"):
        plotting.imprint_profile(state.gap, grid, ax, axis="z")
    with pytest.raises(ValueError, match=r"quantity must be one of 'von_mises', .* got 'heat'"):
        plotting.section(state.von_mises(), grid, ax, quantity="heat")
    with pytest.raises(ValueError, match="grid must have layers, got a grid without dz"):
        plotting.section(state.von_mises(), make_grid(), ax)
    with pytest.raises(ValueError, match=r"components must be one of .* got 'rr'"):
        plotting.axis_profile(state.stress(), grid, ax, components=("rr",))
    with pytest.raises(ValueError, match=r"stress must have shape \(6, 11, 9, 4\)"):
        plotting.axis_profile(state.von_mises(), grid, ax)
    with pytest.raises(ValueError, match=r"contact must have shape \(11, 9\), got \(3,\)"):
        plotting.surface_map(state.gap, grid, ax, contact=np.zeros(3, dtype=bool))


def test_a_missing_latex_is_reported(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", "")
    with matplotlib.rc_context({"text.usetex": True}):
        figure = new_figure()
        figure.suptitle(f"of {tmp_path.name}")
        with pytest.raises(OSError, match=r"cannot draw a figure: .* latex could not be found"):
            save(figure, tmp_path / "f.png")


def test_stress_curves_are_interrupted_at_interfaces(ax):
    grid = Grid(3, 3, 1e-6, 1e-6, nz=6, dz=1e-6)
    stress = np.zeros((6, 3, 3, 6))
    stress[0, :, :, 2:] = 1e9
    plotting.axis_profile(stress, grid, ax, components=["xx"], interfaces=[2e-6, 9e-6])
    values, depths = ax.lines[0].get_data()
    assert np.isnan(values[2])
    assert list(values[:2]) == [0.0, 0.0]
    assert list(values[3:]) == [1000.0] * 4
    assert depths == pytest.approx([0.5, 1.5, 2.0, 2.5, 3.5, 4.5, 5.5])
    assert ax.lines[1].get_ydata() == pytest.approx([2.0, 2.0])
    ax = ax.figure.add_subplot()
    plotting.section(stress[0], grid, ax, quantity="stress", interfaces=[2e-6, 9e-6])
    assert [line.get_ydata()[0] for line in ax.lines] == pytest.approx([2.0])


@pytest.mark.parametrize("quantity", ["von_mises", "hydrostatic", "equivalent_plastic_strain"])
def test_smooth_colours_are_those_of_the_values(quantity):
    """At the cell centres, including those at the border, colours represent the field values."""
    grid = make_grid(nx=21, ny=9, nz=16, dz=1e-4)
    x, z = grid.x[:, None, None] * 1e4, grid.z * 1e4
    field = np.exp(-(x**2) / 40 - (z - 5) ** 2 / 20) * np.ones((1, 9, 1))
    field *= {"von_mises": 1e9, "hydrostatic": -1e9}.get(quantity, 0.02)
    ax = new_figure().subplots()
    plotting.section(field, grid, ax, quantity=quantity)
    factor = 100.0 if "strain" in quantity else 1e-6
    assert shows(ax, grid.x, grid.z, field[:, 4] * factor)


def test_the_colour_scale_of_an_imprint_spans_its_values():
    """The scale covers the values of both signs, with white for zero, and is not symmetric."""
    grid = make_grid(nx=31, ny=29)
    x, y = grid.x[:, None] * 1e4, grid.y * 1e4
    field = 1e-6 * np.exp(-(x**2 + y**2) / 20) - 3e-8
    ax = plotting.surface_map(field, grid, new_figure().subplots(), quantity="imprint")
    low, high = ax.figure.axes[1].get_ylim()
    assert -0.1 < low < -0.03
    assert high == pytest.approx(0.97)
    assert shows(ax, grid.x, grid.y, field * 1e6)
    assert ax.collections[0].norm(0.0) == pytest.approx(0.5)


@pytest.mark.parametrize("cells", [31, 32, 45])
def test_the_edge_of_a_contact_lies_between_cells(cells):
    """The edge agrees with Hertz' circle to a fraction of a cell."""
    grid = make_grid(nx=cells, ny=cells, dx=2e-5, dy=2e-5)
    pressure = (
        ContactSolver(grid, ELASTIC, ELASTIC)
        .solve(surfaces.paraboloid(grid, 7.5e-3), load=300.0)
        .pressure
    )
    ax = plotting.surface_map(pressure, grid, quantity="pressure", contact=pressure)
    edge = ax.collections[-1]
    assert isinstance(edge, QuadContourSet)
    (path,) = edge.get_paths()
    radii = np.hypot(*path.vertices.T) * 1e-6
    a = hertz.point(7.5e-3, E_STAR, load=300.0).a
    assert abs(radii.mean() - a) < 0.1 * grid.dx
    assert np.abs(radii - a).max() < 0.25 * grid.dx
    assert np.isnan(drawn_values(ax, [a + grid.dx], [0.0])).all()
    assert np.isfinite(drawn_values(ax, [a - grid.dx], [0.0])).all()


def test_one_cell_in_contact_has_an_edge():
    pressure = np.zeros((9, 7))
    pressure[4, 3] = pressure[7, 1] = 1e9
    ax = plotting.surface_map(pressure, Grid(9, 7, 1e-6, 1e-6), quantity="pressure")
    rings = ax.collections[-1].get_paths()[0].to_polygons()
    assert len(rings) == 2
    assert np.mean(rings[0], axis=0) == pytest.approx([0.0, 0.0], abs=0.2) or np.mean(
        rings[1], axis=0
    ) == pytest.approx([0.0, 0.0], abs=0.2)


def test_a_section_marks_the_contact(state, simulation, ax):
    grid = simulation.grid
    touching = np.zeros((grid.nx, grid.ny))
    touching[[2, 3, 7], 4] = 1e9
    plotting.section(state.von_mises(), grid, ax, quantity="von_mises", contact=touching)
    ends = [line.get_xdata() * 1e-6 for line in ax.lines]
    sides = grid.x[[2, 3, 7, 7]] + grid.dx * np.array([-0.5, 0.5, -0.5, 0.5])
    assert np.ravel(ends) == pytest.approx(sides)
    assert all(np.all(line.get_ydata() == 0) for line in ax.lines)


def test_the_unloading_curve_agrees_with_smaller_increments():
    """In unloading the approach is about linear in load^(2/3), as for elastic bodies."""
    grid = Grid(31, 31, 40e-6, 40e-6, 20, 40e-6)
    simulation = Simulation(grid, ELASTIC, SWIFT, surfaces.paraboloid(grid, 7.5e-3))
    loads = [1500.0, 1000.0, 500.0, 200.0, 0.0]
    states = simulation.run([{"load": load} for load in loads], progress=False)
    assert states[-1].residual_displacement(body=2).max() > 2e-7
    ax = plotting.load_approach(to_dataset(simulation, [states[0], states[-1]]))
    approach, load = lines(ax)["_between"].T
    for state in states[1:-1]:
        found = np.interp(state.load, load[::-1], approach[::-1]) * 1e-6
        assert found == pytest.approx(state.approach, abs=0.01 * states[0].approach)
    straight = states[-1].approach + states[0].approach * 500.0 / 1500.0
    assert abs(straight - states[2].approach) > 0.1 * states[0].approach
