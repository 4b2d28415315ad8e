# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files that describe parts: loads of gears, and files of profiles."""

import numpy as np
import pytest

import samcontact as sc
from case_kinds import GEAR
from samcontact import results
from samcontact.cases import Case, CaseError, load_case
from samcontact.plotting.contact_results import ContactResults
from samcontact.plotting.maps import peak_map

ELASTIC = {"law": "elastic", "E": 206e9, "nu": 0.3}
PLAIN = {
    "title": "t", "body1": ELASTIC, "body2": ELASTIC,
    "grid": {"nx": 25, "ny": 1, "dx": 2e-5, "dy": 7e-3, "periodic": "y"},
    "surface": {name: GEAR[name] for name in ("shape", "module", "teeth", "face_width",
                                              "profile_shift")} | {"torque": 150.0},
    "path": [{"load_factor": 1.0, "increments": 1}],
}  # fmt: skip


def test_the_torque_gives_the_pressure_of_a_line_contact():
    case = Case.model_validate(PLAIN)
    simulation, path = case.build()
    found = simulation.run(path, progress=False)[-1].pressure.max()
    pair = sc.parts.GearPair(4.5e-3, (16, 24), 14e-3, profile_shift=(0.18, 0.17))
    steel = case.body1.build()
    expected = pair.at("C").hertz(150.0, sc.hertz.effective_modulus(steel, steel)).p0
    assert found == pytest.approx(expected, rel=5e-3)


def test_a_changed_part_has_another_load():
    """A sweep changes the fields that were given, and computes the load again."""
    given = Case.model_validate(PLAIN).model_dump(exclude_unset=True)
    given["surface"]["torque"] *= 2.0
    doubled = Case.model_validate(given).path[0].load
    assert doubled == pytest.approx(2.0 * Case.model_validate(PLAIN).path[0].load, rel=1e-14)


def test_the_load_of_a_part_requires_one():
    other = PLAIN | {"surface": {"shape": "cone", "half_angle": 1.4}}
    with pytest.raises(CaseError, match=r"path\[0\]: load_factor requires a part with a load"):
        Case.model_validate(other)
    both = PLAIN | {"path": [{"load_factor": 1.0, "load": 2.0}]}
    with pytest.raises(CaseError, match="exactly one of load, approach and"):
        Case.model_validate(both)
    many = PLAIN["surface"] | {"centre_distance": 91.5e-3, "tip_diameter": [82.5e-3, 118.4e-3]}
    with pytest.raises(CaseError, match="profile_shift has no effect with both"):
        Case.model_validate(PLAIN | {"surface": many})
    pressed = other | {"grid": {"nx": 9, "ny": 9, "dx": 1e-5, "dy": 1e-5}, "path": [{"load": 1.0}]}
    assert "Hertz theory does not apply" in Case.model_validate(pressed).reason_for_grid


def test_profiles_are_read_from_files_next_to_the_case(tmp_path):
    y = np.linspace(-30.0, 30.0, 61)
    for name, radius in (("rail", 300.0), ("wheel", -400.0)):
        z = y**2 / (2.0 * radius)
        np.savetxt(tmp_path / f"{name}.csv", np.column_stack([y, z]), delimiter=",")
    (tmp_path / "case.toml").write_text(
        """title = "t"
grid = {nx = 9, ny = 9, dx = 1e-3, dy = 1e-3}
body1 = {law = "rigid"}
body2 = {law = "elastic", E = 210e9, nu = 0.3}
path = [{load = 1e4}]
[surface]
shape = "wheel_rail"
rail = "rail.csv"
wheel = "wheel.csv"
unit = "mm"
wheel_radius = 0.46
"""
    )
    simulation, _ = load_case(tmp_path / "case.toml").build()
    expected = sc.surfaces.paraboloid(simulation.grid, 0.46, 1.0 / (1.0 / 0.3 + 1.0 / 0.4))
    assert simulation.initial_gap == pytest.approx(expected, rel=1e-3, abs=1e-12)
    (tmp_path / "rail.csv").unlink()
    with pytest.raises(CaseError, match=r"cannot read heights from .*rail.csv"):
        load_case(tmp_path / "case.toml").build()


def test_the_map_of_the_gap_is_blank_beyond_the_face():
    """Cells without a body have an infinite gap."""
    matplotlib = pytest.importorskip("matplotlib")
    grid = {"nx": 17, "ny": 17, "dx": 4e-5, "dy": 1e-3}
    crowned = PLAIN["surface"] | {"crowning": 2e-5}
    case = Case.model_validate(PLAIN | {"grid": grid, "surface": crowned})
    simulation, path = case.build()
    dataset = results.to_dataset(simulation, simulation.run(path, progress=False), case)
    assert np.isinf(dataset["gap"].values).any()
    ax = matplotlib.figure.Figure().add_subplot()
    peak_map(ContactResults(dataset, 2, None), "gap", ax)
    assert "no body" in ax.get_title()


LIFT = {"max_lift": 6e-3, "event_angle": 2.4}
CAM = PLAIN | {
    "surface": {"shape": "cam", "base_radius": 18e-3, "cam_angle": 0.3} | LIFT,
    "grid": {"nx": 65, "ny": 1, "dx": 8e-6, "dy": 10e-3, "periodic": "y"},
    "path": [{"load": 3e3, "increments": 1}],
}


def test_a_cam_has_the_pressure_of_its_curvature():
    case = Case.model_validate(CAM)
    simulation, path = case.build()
    found = simulation.run(path, progress=False)[-1].pressure.max()
    contact = sc.parts.Cam.harmonic(18e-3, 6e-3, 2.4).at(0.3)
    steel = case.body1.build()
    expected = contact.hertz(3e3, 10e-3, sc.hertz.effective_modulus(steel, steel)).p0
    assert found == pytest.approx(expected, rel=5e-3)
    degrees = CAM["surface"] | {"event_angle": f"{np.degrees(2.4)} deg"}
    assert Case.model_validate(CAM | {"surface": degrees}).surface.cam_angle == 0.3


@pytest.mark.parametrize(
    ("changed", "says"),
    [
        ({"eccentricity": 1e-3}, "exactly one of eccentricity, max_lift with event_angle, or"),
        ({"event_angle": None}, "exactly one of eccentricity"),
        ({"max_lift": 60e-3}, "a flat tappet cannot follow a concave cam"),
    ],
)
def test_impossible_cams_are_refused(changed, says):
    with pytest.raises(CaseError, match=f"surface: .*{says}"):
        Case.model_validate(CAM | {"surface": CAM["surface"] | changed})
