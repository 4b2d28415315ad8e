# SPDX-License-Identifier: GPL-3.0-or-later
"""Labels of fields in figures name only the given and possible quantity."""

import numpy as np
import pytest
from drawn_fields import shows
from matplotlib.contour import QuadContourSet

from core_fakes import ELASTIC, FakeState, make_grid, make_simulation
from samcontact import Grid, Simulation, plotting, surfaces
from samcontact.plotting.contact_results import ContactResults
from samcontact.plotting.maps import peak_map
from samcontact.plotting.parts import new_figure
from samcontact.results import to_dataset


@pytest.fixture
def simulation():
    return make_simulation()


@pytest.fixture
def state(simulation):
    return FakeState(simulation.grid, 1500.0)


def shown_label(ax):
    """Return the label of the colour bar, or the title if the section is flat."""
    return ax.get_title() or ax.figure.axes[1].get_ylabel()


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_field_without_a_name_has_a_neutral_label(simulation, sign):
    """Residual stress was drawn as a von Mises stress, with all compression white."""
    grid = simulation.grid
    x, y, z = grid.x[:, None, None] * 1e4, grid.y[:, None] * 1e4, grid.z * 1e4
    stress = 3e8 * (sign * 1.5 - np.cos(x) * np.exp(-z / 9)) * np.exp(-(y**2) / 50)
    for label in (None, r"residual $\sigma_{xx}$ [Pa]"):
        sections = new_figure().subplots()
        plotting.section(stress, grid, sections, label=label)
        surface = new_figure().subplots()
        plotting.surface_map(stress[..., 0], grid, surface, label=label)
        assert shows(sections, grid.x, grid.z, stress[:, 4])  # in the unit that was given
        assert shows(surface, grid.x, grid.y, stress[..., 0])
        for ax in (sections, surface):
            assert shown_label(ax) == (label or "value")
            filled = next(c for c in ax.collections if isinstance(c, QuadContourSet) and c.filled)
            both = stress.min() < 0
            assert (filled.cmap.name == "RdBu_r") == both
            assert (filled.norm(0.0) == pytest.approx(0.5)) == both


@pytest.mark.parametrize("value", [2.5, -4e8])
@pytest.mark.parametrize("cells", [False, True])
def test_a_field_of_one_value_is_shown(value, cells):
    grid = make_grid()
    ax = plotting.surface_map(np.full((grid.nx, grid.ny), value), grid, cells=cells)
    low, high = ax.figure.axes[1].get_ylim()
    assert low <= min(value, 0.0) + 1e-9 * abs(value) < max(value, 0.0) <= high + 1e-9 * abs(value)


def test_impossible_values_of_a_quantity_are_an_error(state, simulation):
    grid = simulation.grid
    stress, strain = state.hydrostatic(), np.full((grid.nx, grid.ny, grid.nz), 1e9)
    print_ = state.residual_displacement(body=2) - 5e-7
    volume = {
        "von_mises": (
            stress,
            "field must be >= 0 to be shown as von Mises stress, got .* Pa: check",
        ),
        "residual_von_mises": (stress, "field must be >= 0 to be shown as residual von Mises"),
        "equivalent_plastic_strain": (
            strain,
            "field must be at most 100 to be .* got 1e.09: check",
        ),
        "temperature": (strain, "field must be at most 1e.06 K to be shown as temperature rise"),
    }
    for quantity, (field, message) in volume.items():
        with pytest.raises(ValueError, match=message):
            plotting.section(field, grid, quantity=quantity)
    for quantity in ("pressure", "gap", "temperature"):
        with pytest.raises(ValueError, match=f"{quantity} must be >= 0 to be shown as .* -5e-07"):
            plotting.surface_map(print_, grid, quantity=quantity)
    with pytest.raises(
        ValueError, match=r"imprint must be at most .* m to be shown as residual dis"
    ):
        plotting.surface_map(state.pressure, grid, quantity="imprint")
    shear = np.zeros((2, grid.nx, grid.ny))
    for draw, message in (
        (lambda: plotting.pressure_profile(print_, grid), "pressure must be >= 0"),
        (
            lambda: plotting.imprint_profile(state.pressure, grid),
            "residual displacement must be at",
        ),
        (lambda: plotting.temperature_profile(print_, grid), "temperature rise must be >= 0"),
        (lambda: plotting.shear_profile(print_, shear, grid, 0.3), "pressure must be >= 0"),
    ):
        with pytest.raises(ValueError, match=message):
            draw()


def test_rounding_below_zero_is_accepted(state, simulation):
    grid = simulation.grid
    rounded = state.pressure - 1e-8 * state.pressure.max()
    plotting.surface_map(rounded, grid, quantity="pressure")
    plotting.surface_map(np.full((grid.nx, grid.ny), -1e-14), grid, quantity="gap")  # all touches


def test_prescribed_tension_is_shown(tmp_path):
    """Prescribed tension and overlap of the bodies are drawn in colour, not white."""
    grid = Grid(21, 21, 1e-6, 1e-6)
    gap = surfaces.paraboloid(grid, 1e-3)
    simulation = Simulation(grid, ELASTIC, ELASTIC, gap)
    pressure = 1e8 * np.cos(0.3e6 * grid.x[:, None]) * np.ones(grid.ny)
    dataset = to_dataset(simulation, simulation.run([{"pressure": pressure}], progress=False))
    problem = ContactResults(dataset, 2, None)
    ax = peak_map(problem, "pressure", new_figure().subplots())
    assert ax.get_title() == "pressure [GPa]"
    assert shows(ax, grid.x, grid.y, pressure * 1e-9)
    ax = peak_map(problem, "gap", new_figure().subplots())
    assert ax.get_title() == "gap [nm]"  # a small one
    dataset["gap"][:] -= 2e-8
    ax = peak_map(problem, "gap", new_figure().subplots())
    assert shows(ax, grid.x, grid.y, dataset["gap"].values[0] * 1e9)
    assert len(plotting.summary_figures(dataset, tmp_path)) == 3
