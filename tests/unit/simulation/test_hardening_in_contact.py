# SPDX-License-Identifier: GPL-3.0-or-later
"""Voce's law and tabulated curves under a ball: other laws, checkpoints, case files."""

import re
from pathlib import Path

import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError

import samcontact as sc
from samcontact.cases import Case
from samcontact.cases.bodies import BodySection

E, NU = 210e9, 0.3
S0, S_INF, RATE = 900e6, 1500e6, 60.0
VOCE = sc.Material.voce(E, NU, S0, S_INF, RATE)
STRAIN, STRESS = (0.0, 1e-3, 2e-3, 8e-3, 0.02), (900e6, 950e6, 1300e6, 1310e6, 1600e6)
TABLE = sc.Material.tabulated(E, NU, STRAIN, STRESS)
LAWS = {"voce": VOCE, "tabulated": TABLE}
laws = pytest.mark.parametrize("law", LAWS)
RADIUS = 7.5e-3
EXACT = sc.hertz.point(RADIUS, E / (1 - NU**2) / 2, p0=2.6e9)
GRID = sc.Grid(15, 15, 0.2 * EXACT.a, 0.2 * EXACT.a, 10, 0.2 * EXACT.a)
BALL = sc.surfaces.paraboloid(GRID, RADIUS)


def pressed(material, loads=(0.5, 1.0), **more):
    """Press a ball step by step on a flat of this material."""
    simulation = sc.Simulation(
        GRID, sc.Material.elastic(E, NU), material, BALL, tol=1e-8, on_border="warn", **more
    )
    for load in loads:
        simulation.step(load=load * EXACT.load)
    return simulation


VOCE_FILE = {"law": "voce", "E": "210 GPa", "nu": NU, "yield_stress": "900 MPa",
        "saturation_stress": "1.5 GPa", "rate": RATE}  # fmt: skip
TABLE_FILE = {"law": "tabulated", "E": E, "nu": NU, "plastic_strain": list(STRAIN),
         "stress": ["900 MPa", *STRESS[1:]]}  # fmt: skip
read = TypeAdapter(BodySection).validate_python


def test_two_points_are_linear_hardening():
    Et = 0.05 * E
    modulus = E * Et / (E - Et)
    linear = sc.Material.linear_hardening(E, NU, 1e9, Et)
    line = sc.Material.tabulated(E, NU, [0.0, 0.5], [1e9, 1e9 + 0.5 * modulus])
    table, expected = pressed(line).state, pressed(linear).state
    for field in ("pressure", "equivalent_plastic_strain", "stress", "residual_displacement"):
        one, other = getattr(table, field), getattr(expected, field)
        one, other = (one, other) if field == "pressure" else (one(), other())
        assert np.abs(one - other).max() <= 1e-12 * np.abs(other).max()
        assert np.abs(other).max() > 0


def test_samples_of_swift_converge_at_second_order():
    """Differences of imprint volume and integrated strain converge with second order."""
    swift = sc.Material.swift(E, NU, 150e6, 3000.0, 0.25)
    errors = []
    for pieces in (8, 16, 32):
        g = np.linspace(0.0, 0.03, pieces + 1)
        table = sc.Material.tabulated(E, NU, g, swift.yield_stress(g))
        states = [pressed(one, loads=(1.0,)).state for one in (table, swift)]
        strain = [state.equivalent_plastic_strain() for state in states]
        prints = [state.residual_displacement().sum() for state in states]
        assert 2e-3 < strain[1].max() < 0.03
        errors.append((prints[0] / prints[1] - 1, strain[0].sum() / strain[1].sum() - 1))
    first, second, third = np.abs(errors)
    assert (first < 0.1).all()
    np.testing.assert_allclose(second / third, 4.0, rtol=0.2)


@laws
def test_an_increment_converges_to_the_yield_surface(law):
    state = pressed(LAWS[law]).state
    assert state.converged
    limit = LAWS[law].yield_stress(state.equivalent_plastic_strain())
    assert (state.von_mises() <= limit * (1 + 1e-6)).all()
    flowed = state.equivalent_plastic_strain() > 1e-4
    assert flowed.sum() > 20
    # the last increment made all of these flow
    np.testing.assert_allclose(state.von_mises()[flowed], limit[flowed], rtol=1e-6)


@laws
def test_softening_scales_the_curve(law):
    soft = LAWS[law].with_softening(lambda rise: np.full(rise.shape, 0.75))
    if law == "voce":
        scaled = sc.Material.voce(E, NU, 0.75 * S0, 0.75 * S_INF, RATE)
    else:
        scaled = sc.Material.tabulated(E, NU, STRAIN, 0.75 * np.array(STRESS))
    for terms in ((), (40e9, 30.0)):
        states = [
            pressed(one.with_kinematic_hardening(*terms) if terms else one).state
            for one in (soft, scaled)
        ]
        strain = [state.equivalent_plastic_strain() for state in states]
        assert strain[1].max() > 1e-3
        np.testing.assert_allclose(*strain, rtol=0, atol=1e-9 * strain[1].max())


@laws
def test_a_run_continues_from_a_checkpoint(law, tmp_path):
    material = LAWS[law].with_kinematic_hardening(40e9, 30.0)
    simulation = pressed(material, loads=(0.6,))
    simulation.save(tmp_path / "saved.h5")
    other = sc.Simulation.load(tmp_path / "saved.h5")
    assert other.body2 == material
    assert repr(other.body2) == repr(material)
    states = [one.step(load=EXACT.load) for one in (simulation, other)]
    for field in ("von_mises", "equivalent_plastic_strain", "plastic_strain"):
        np.testing.assert_array_equal(*[getattr(state, field)() for state in states])


def test_the_largest_table_fits_into_a_checkpoint(tmp_path):
    g = np.linspace(0.0, 0.1, 4096)
    table = sc.Material.tabulated(E, NU, g, VOCE.yield_stress(g))
    pressed(table, loads=()).save(tmp_path / "saved.h5")
    assert sc.Simulation.load(tmp_path / "saved.h5").body2 == table


def test_case_files_make_the_same_materials():
    assert read(VOCE_FILE).build() == VOCE
    assert read(TABLE_FILE).build() == TABLE
    moving = read(TABLE_FILE | {"kinematic": {"modulus": 1e9}}).build()
    assert moving == TABLE.with_kinematic_hardening(1e9)


@pytest.mark.parametrize(
    ("change", "text"),
    [
        (
            {"plastic_strain": [0.0, 0.1]},
            "number of values in stress must be the number of values in plastic",
        ),
        ({"plastic_strain": [0.1, 0.2, 0.3, 0.4, 0.5]}, "plastic_strain[0] must be 0"),
        ({"stress": [1e9, 0.9e9, 1e9, 1e9, 1e9]}, "stress[1] must be >= stress[0]"),
        ({"stress": [-1.0]}, "Input should be greater than 0"),
        ({"stress": 1e9}, "Input should be a valid list"),
    ],
)
def test_refused_by_name(change, text):
    with pytest.raises(ValidationError, match=re.escape(text)):
        read(TABLE_FILE | change)


@laws
def test_to_results(law):
    pytest.importorskip("xarray")
    grid = {"nx": 15, "ny": 15, "dx": GRID.dx, "dy": GRID.dy, "nz": 10, "dz": GRID.dz}
    case = Case.model_validate(
        {
            "title": "t",
            "grid": grid,
            "body1": {"law": "elastic", "E": E, "nu": NU},
            "body2": {"voce": VOCE_FILE, "tabulated": TABLE_FILE}[law],
            "surface": {"shape": "paraboloid", "Rx": RADIUS},
            "contact": {"tol": 1e-8, "on_border": "warn"},
            "path": [{"load": part * EXACT.load, "increments": 1} for part in (0.5, 1.0)],
        }
    )
    simulation, path = case.build()
    states = list(simulation.run(path, progress=False))
    material = LAWS[law]
    expected = pressed(material).state.equivalent_plastic_strain()
    np.testing.assert_allclose(
        states[-1].equivalent_plastic_strain(), expected, rtol=0, atol=1e-9 * expected.max()
    )
    dataset = sc.results.to_dataset(simulation, states)
    assert dataset.attrs["body2_law"] == material.law
    for name, value in material.parameters.items():
        np.testing.assert_array_equal(dataset.attrs[f"body2_{name}"], value)


def test_plastic_strain_of_the_exact_method_without_hardening():
    """The strains are those stated in the theory; a cell-to-cell pattern increases them."""
    file = Path(__file__).parents[3] / "docs" / "theory" / "accuracy.md"
    page = file.read_text(encoding="utf-8")
    stated = re.search(
        r"with (\d+) cells over \$3 \\sqrt\{R w\}\$, with R the radius of the ball and w the "
        r"interference, the maximum plastic strain is ([\d.]+) %. The fast operator gives "
        r"([\d.]+) %",
        " ".join(page.split()),
    )
    cells, modulus = int(stated[1]), E / (1 - NU**2)
    interference = 10 * sc.critical.green(10e-3, modulus, NU, 1e9).interference
    side = 3 * np.sqrt(10e-3 * interference) / cells
    grid = sc.Grid(cells, cells, side, side, dz=side)
    for method, strain in (("exact", stated[2]), ("fast", stated[3])):
        simulation = sc.Simulation(
            grid, sc.Material.rigid(), sc.Material.perfect_plastic(E, NU, 1e9),
            sc.surfaces.paraboloid(grid, 10e-3), residual_stress=method,
        )  # fmt: skip
        path = [{"approach": interference * k / 10} for k in range(1, 11)]
        state = simulation.run(path, progress=False)[-1]
        assert f"{100 * state.equivalent_plastic_strain(2).max():.2f}" == strain
