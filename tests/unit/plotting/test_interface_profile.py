# SPDX-License-Identifier: GPL-3.0-or-later
"""Profiles along interfaces of a layered body show the stresses above and below them."""

import numpy as np
import pytest

import samcontact as sc
from samcontact import plotting
from samcontact.plotting import interface
from samcontact.plotting.contact_results import ContactResults
from samcontact.report import figures
from samcontact.results import to_dataset

GRID = sc.Grid(7, 5, 2e-6, 3e-6)
STRESS = 1e9 * np.random.default_rng(3).normal(size=(2, 6, 7, 5, 2))
STEEL = sc.Material.elastic(210e9, 0.3)
NITRIDE = sc.Material.elastic(440e9, 0.25)
RIGID = sc.Material.rigid()


def lines(ax):
    return {line.get_label(): line.get_xydata().T for line in ax.get_lines()}


@pytest.mark.parametrize(("axis", "along", "shear"), [("x", 0, 4), ("y", 1, 3)])
def test_lines_are_those_of_the_interface(axis, along, shear):
    ax = plotting.interface_profile(
        STRESS, GRID, interface=1, interfaces=[1e-6, 5e-6], axis=axis, position=4e-6
    )
    row, x = (np.s_[:, :, :, 3, 1], GRID.x) if axis == "x" else (np.s_[:, :, 5, :, 1], GRID.y)
    above, below = 1e-6 * STRESS[row]
    expected = {
        rf"$\sigma_{{{axis}{axis}}}$ above": above[along],
        rf"$\sigma_{{{axis}{axis}}}$ below": below[along],
        r"$\sigma_{zz}$": 0.5 * (above[2] + below[2]),
        rf"$\sigma_{{{axis}z}}$": 0.5 * (above[shear] + below[shear]),
    }
    drawn = lines(ax)
    (mark,) = set(drawn) - set(expected)
    for name, values in expected.items():
        np.testing.assert_allclose(drawn[name], [x * 1e6, values])
    most = max(values.max() for name, values in expected.items() if f"{axis}z" not in name)
    assert mark == f"maximum tension {most:.4g} MPa"
    assert drawn[mark][1] == pytest.approx([most])
    assert ax.get_ylabel() == "stress at 5 µm depth [MPa]"


def test_the_contact_bar_is_drawn_and_no_tension_is_marked():
    contact = np.zeros((7, 5))
    contact[2:4, 2] = 1.0
    ax = plotting.interface_profile(-np.abs(STRESS), GRID, contact=contact)
    assert not any("tension" in name for name in lines(ax))
    bar = ax.get_lines()[-1]
    assert bar.get_xdata() == pytest.approx([-3.0, 1.0])
    to_panel = bar.get_transform() - ax.transAxes
    assert to_panel.transform(bar.get_xydata())[:, 1] == pytest.approx([1.0, 1.0])


def test_invalid_arguments_are_named():
    for wrong, text in (
        ({"stress": STRESS[..., 0]}, r"stress must have shape \(2, 6, 7, 5, 5\)"),
        ({"interface": 2}, "interface must be an integer of magnitude <= 1, got 2"),
        ({"interfaces": [1e-6]}, r"interfaces must have shape \(2,\), got \(1,\)"),
        ({"axis": "z"}, "axis must be one of 'x', 'y', got 'z'"),
        ({"contact": [1.0]}, r"contact must have shape \(7, 5\)"),
    ):
        with pytest.raises(ValueError, match=text):
            plotting.interface_profile(**{"stress": STRESS, "grid": GRID} | wrong)


def pressed(body):
    grid = sc.Grid(16, 16, 2e-6, 2e-6, nz=4, dz=2e-6)
    run = sc.Simulation(grid, RIGID, body, sc.surfaces.paraboloid(grid, 2e-3), friction=0.1)
    state = run.step(load=0.3)
    return state, to_dataset(run, [state])


def test_both_sides_of_an_interface_in_one_material_coincide():
    """Both sides coincide inside one material; at a rigid base without stress one side is drawn."""
    state, _ = pressed(sc.Layered([(STEEL, 4e-6), (STEEL, 4e-6)], RIGID))
    stress = state.interface_stress()
    drawn = lines(plotting.interface_profile(stress, state.grid))
    above, below = (drawn[rf"$\sigma_{{xx}}$ {side}"] for side in ("above", "below"))
    np.testing.assert_allclose(above, below, atol=1e-6 * np.abs(above[1]).max())
    drawn = lines(plotting.interface_profile(stress, state.grid, interface=1))
    assert r"$\sigma_{xx}$ below" not in drawn
    np.testing.assert_allclose(drawn[r"$\sigma_{zz}$"][1], 1e-6 * stress[0, 2, :, 8, 1])


def test_the_interfaces_with_the_largest_tension_are_shown():
    layers = [(NITRIDE, 4e-6), (STEEL, 2e-6), (NITRIDE, 4e-6), (STEEL, 2e-6)]
    body = sc.Layered(layers, STEEL)
    _, dataset = pressed(body)
    scene = ContactResults(dataset, 2, None)
    stored = dataset.interface_stress_body2[0]
    pulled = stored.sel(component=["xx", "zz"]).max(("side", "component", "x", "y"))
    three = np.sort(body.interfaces[np.argsort(-pulled.values)[:3]])
    panels = interface.interface_figure(scene, 1).axes
    assert [ax.get_ylabel() for ax in panels] == [
        f"stress at {depth * 1e6:.4g} µm depth [MPa]" for depth in three
    ]
    # the table of a report has them all
    ((_, text, _),) = [made for made in figures._volume(scene) if "interfaces" in made[0]]
    tension = 1e-6 * float(stored.sel(component=["xx", "yy"]).max())
    assert f"in-plane tension {tension:.4g} MPa" in text
