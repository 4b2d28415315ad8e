# SPDX-License-Identifier: GPL-3.0-or-later
"""Exposure of hardened cases: known maxima of a flank, governing depth, case files and figure."""

import numpy as np
import pytest
import xarray as xr

import samcontact as sc
from samcontact.cases import Case
from samcontact.commands.fatigue import write_fatigue
from samcontact.commands.tables import new_console

BODY = sc.Material.elastic(206e9, 0.3)
FLANK = sc.hertz.line(10e-3, 113e9, p0=1.5e9)
DEEP = sc.hardness.HardnessProfile([0.0], [400.0])


def test_maxima_of_a_flank():
    """Line contact, nu = 0.3: Dang Van 0.1707 p0, von Mises 0.5577 p0, orthogonal shear p0/4."""
    found = sc.fatigue.exposure(sc.fatigue.hertz_cycle(FLANK, BODY), DEEP)
    p0 = FLANK.p0
    assert found.stress["dang_van"].max() == pytest.approx(0.1707 * p0, rel=1e-3)
    assert found.stress["yield"].max() == pytest.approx(FLANK.max_von_mises(0.3)[0], rel=1e-4)
    assert found.stress["orthogonal_shear"].max() == pytest.approx(0.25 * p0, rel=1e-3)
    torsion = 1.6e6 * 400 * 0.6  # Dang Van's slope 0.3 belongs to t/f = 0.6
    assert found.max_value("dang_van") == pytest.approx(0.1707 * p0 / torsion, rel=1e-3)
    assert found.criterion == "orthogonal_shear"
    assert found.depth() == pytest.approx(0.5 * FLANK.b, rel=0.06)
    assert "governs" in found._repr_html_()


def test_a_thin_case_moves_the_governing_depth_below_the_case():
    seen = sc.fatigue.hertz_cycle(FLANK, BODY)
    at = []
    for depth in (0.4 * FLANK.b, 1.0 * FLANK.b):
        case = sc.hardness.hardened_case(620.0, 250.0, depth, limit=435.0)
        found = sc.fatigue.exposure(seen, case, defect=20e-6)
        at.append((found.max_value("yield"), found.depth("yield") / FLANK.b))
    assert at[0][0] > 1.2 * at[1][0]
    assert at[0][1] > 0.72  # at 0.70 b without a gradient of hardness


def test_residual_compression_relieves_dang_van_but_not_orthogonal_shear():
    treated = BODY.with_residual_stress([0.0, 1e-2], [-400e6, -400e6])
    plain, pressed = (
        sc.fatigue.exposure(sc.fatigue.hertz_cycle(FLANK, body), DEEP) for body in (BODY, treated)
    )
    # a constant stress shifts the path of the deviator only: sigma_h changes by 2/3 of it
    expected = plain.stress["dang_van"] + 0.3 * 2 / 3 * -400e6
    assert pressed.stress["dang_van"] == pytest.approx(expected, rel=1e-6, abs=1e3)
    same = plain.stress["orthogonal_shear"]
    assert pressed.stress["orthogonal_shear"] == pytest.approx(same, rel=1e-12)


def test_point_contacts_have_lines_across_and_wrong_contacts_are_refused():
    ball = sc.hertz.point(10e-3, 113e9, p0=2e9)
    seen = sc.fatigue.hertz_cycle(ball, BODY, z=[0.35 * ball.a], y=[-ball.a, 0.0])
    field = sc.fatigue.orthogonal_shear(seen)
    assert field.values.shape == (2, 1)
    assert field.max_value == pytest.approx(0.21389 * ball.p0, rel=1e-3)
    with pytest.raises(ValueError, match="y must be omitted"):
        sc.fatigue.hertz_cycle(FLANK, BODY, y=[0.0])
    with pytest.raises(TypeError, match="contact must be a LineContact or PointContact"):
        sc.fatigue.hertz_cycle(sc.hertz.elliptic(1e-2, 2e-2, 1e11, p0=1e9), BODY)
    with pytest.raises(ValueError, match="must have depths"):
        sc.fatigue.exposure(np.zeros((2, 6, 3)), DEEP)


FLANK_CASE = {
    "title": "flank",
    "grid": {"nx": 16, "ny": 12, "dx": 2e-5, "dy": 2e-5, "dz": 2e-5, "nz": 8},
    "body1": {"law": "rigid"},
    "body2": {
        "material": "18CrNiMo7-6",
        "hardness": {"surface": 620.0, "core": 380.0, "depth": "0.2 mm"},
    },
    "surface": {"shape": "paraboloid", "Rx": 5e-3},
    "path": [{"load": 20.0, "increments": 1}],
    "estimate_error": False,
    "fatigue": {
        "orthogonal_shear": "x", "steady_axis": "x", "exposure": {"defect": "20 um"},
        "life": {"criterion": "orthogonal_shear"},
    },
}  # fmt: skip


def test_a_case_file_writes_exposure_and_life(tmp_path, undrawn):
    case = Case.model_validate(FLANK_CASE)
    simulation, path = case.build()
    states = simulation.run(path, progress=False)
    written = write_fatigue(case, states, tmp_path, new_console(True), figures=True)
    assert {file.name for file in written} >= {"fatigue.nc", "fatigue_exposure.png"}
    cycle = sc.fatigue.steady_cycle(states[-1])
    profile = sc.hardness.hardened_case(620.0, 380.0, 2e-4)
    expected = sc.fatigue.exposure(cycle, profile, defect=20e-6)
    with xr.open_dataset(tmp_path / "fatigue.nc") as stored:
        values = stored["exposure_dang_van"].values
        np.testing.assert_allclose(values, expected.values["dang_van"], rtol=1e-12)
        assert stored.attrs["governing_criterion"] == expected.criterion
        integral = sc.fatigue.life(sc.fatigue.orthogonal_shear(cycle)).log_integral
        assert stored.attrs["life_log_integral"] == pytest.approx(integral, rel=1e-12)


def test_a_study_of_depth_and_material():
    studied = {"body2.hardness.depth": [1e-4, 2e-4], "body2.material": ["52100", "16MnCr5"]}
    found = sc.sweep(Case.model_validate(FLANK_CASE), studied, progress=False)
    exposed, lives = found["exposure_yield"].values, found["life_log_integral"].values
    assert (exposed[0] > exposed[1]).all()  # a thinner case is weaker
    assert (exposed[:, 0] < exposed[:, 1]).all()  # E = 210 and 211 GPa
    assert (lives[0] == lives[1]).all()  # the elastic stress does not depend on the hardness
