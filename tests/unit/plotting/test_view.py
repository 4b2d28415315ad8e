# SPDX-License-Identifier: GPL-3.0-or-later
"""Three-dimensional views: meshes, and the page in a browser without a network."""

import io
import re
import sys

import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image

import samcontact as sc
from browser import chromium
from core_fakes import ELASTIC, SWIFT, FakeState, make_grid, make_simulation
from samcontact import plotting, results
from samcontact.commands.folder import is_own
from samcontact.commands.main import main

needs_pyvista = pytest.mark.skipif(
    "not __import__('importlib').util.find_spec('pyvista')", reason="pip install samcontact[3d]"
)
# what PyVista needs warns of what is to come
pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")


def dataset():
    """Return results whose von Mises stress is largest at x = y = 0, at a depth of 100 µm."""
    simulation = make_simulation(4, SWIFT, SWIFT)
    grid = simulation.grid = make_grid(nx=21, ny=17, dx=5e-5, dy=5e-5, nz=12, dz=4e-5)
    simulation.initial_gap = np.zeros((21, 17))
    state = FakeState(grid, 700.0)
    x, y, z = grid.x[:, None, None], grid.y[:, None], grid.z
    state.von_mises = lambda body=2: 1e9 * np.exp(-(x**2 + y**2 + (z - 1e-4) ** 2) / 4e-8)
    return results.to_dataset(simulation, [state])


def meshes(plotter):
    """Return the meshes of the view, in the order of addition."""
    mappers = [getattr(actor, "mapper", None) for actor in plotter.actors.values()]
    return [mapper.dataset for mapper in mappers if hasattr(mapper, "dataset")]


@needs_pyvista
def test_the_body_is_cut_open_below_its_largest_value():
    body, *lines = meshes(plotting.view(dataset()))
    assert np.ravel(body.bounds) == pytest.approx([-525, 525, -425, 425, -480, 0], abs=1e-3)
    inside = (body.points[:, 0] > 1) & (body.points[:, 1] < -1)
    assert not inside.any()
    axis = np.abs(body.points[:, :2]).max(axis=1) < 1
    assert body["values"][axis].max() == pytest.approx(1000, rel=0.1)
    at = np.argmin(np.linalg.norm(body.points - [200, 0, -100], axis=1))
    expected = 1e3 * np.exp(
        -((body.points[at] * [1, 1, 1] + [0, 0, 100]) ** 2).sum() * 1e-12 / 4e-8
    )
    assert body["values"][at] == pytest.approx(expected, rel=0.1)
    edge = lines[0].points
    a = sc.hertz.point(7.5e-3, 115384615384.6154, load=700.0).a
    assert np.hypot(edge[:, 0], edge[:, 1]) == pytest.approx(a * 1e6, abs=15)
    assert np.all(edge[:, 2] == 0)


@needs_pyvista
def test_body_1_lies_above():
    body, *_ = meshes(plotting.view(dataset(), body=1))
    assert body.bounds[4:] == pytest.approx((0, 480), abs=1e-3)


@needs_pyvista
def test_inclusions_are_surfaces_in_the_view():
    data = dataset()
    x, y, z = (data[name].values for name in "xyz")
    radius, centre = 1.5e-4, np.array([1e-4, -1e-4, 2.4e-4])
    offset = np.sqrt((x[:, None, None] - centre[0]) ** 2 + (y[:, None] - centre[1]) ** 2
                     + (z - centre[2]) ** 2)  # fmt: skip
    share = np.clip((radius - offset) / 5e-5 + 0.5, 0.0, 1.0)
    data["share_body2"] = (("output_increment", "x", "y", "z"), share[None])
    sphere = meshes(plotting.view(data))[1]
    distance = np.linalg.norm(sphere.points * [1, 1, -1] - centre * 1e6, axis=1)
    assert distance == pytest.approx(radius * 1e6, rel=0.03)
    assert sphere.volume == pytest.approx(4 / 3 * np.pi * 150**3, rel=0.1)


@needs_pyvista
def test_the_page_in_a_browser_without_a_network(tmp_path):
    file = results.save(dataset(), tmp_path / "results.nc")
    outcome = CliRunner().invoke(main, ["export", str(file), "--html"])
    assert outcome.exit_code == 0, outcome.output
    page = tmp_path / "results.html"
    assert outcome.stdout.split() == [str(page)]
    assert is_own(page)
    offline = "--host-resolver-rules=MAP * ~NOTFOUND"
    with chromium(offline, "--use-angle=swiftshader", "--enable-unsafe-swiftshader") as driver:
        driver.get(page.as_uri())
        assert driver.execute_script("return document.querySelectorAll('canvas').length") == 1
        driver.execute_async_script(
            "const done = arguments[0]; let n = 0;"
            "const next = () => ++n > 60 ? done() : requestAnimationFrame(next); next()"
        )
        image = np.asarray(Image.open(io.BytesIO(driver.get_screenshot_as_png())).convert("RGB"))
        severe = [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"]
    assert severe == []
    colours = image[image.max(axis=2) - image.min(axis=2) > 60]
    assert len(colours) > 0.1 * image[..., 0].size  # the body, not only a frame
    yellow = (colours[:, 0] > 180) & (colours[:, 1] > 180) & (colours[:, 2] < 110)
    purple = (colours[:, 2] > colours[:, 1] + 40) & (colours[:, 0] < 110)
    assert yellow.sum() > 100  # most stress, and least
    assert purple.sum() > 100


def test_bad_input_is_named(tmp_path):
    data = dataset()
    with pytest.raises(ValueError, match="body must be one of 1, 2, got 3"):
        plotting.view(data, body=3)
    with pytest.raises(ValueError, match=r"quantity must be one of 'von_mises', .* got 'stress'"):
        plotting.view(data, quantity="stress")
    with pytest.raises(ValueError, match=r"increment must be one of .* got 5"):
        plotting.view(data, increment=5)
    flat = results.to_dataset(make_simulation(0, body2=ELASTIC), [FakeState(make_grid(), 1.0)])
    with pytest.raises(ValueError, match="dataset must have volume fields of body 2, got none"):
        plotting.view(flat)
    with pytest.raises(ValueError, match=r"path must end in \.html, got '.*view\.png'"):
        plotting.save_view(None, tmp_path / "view.png")


def test_a_missing_pyvista_is_reported_with_its_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(ModuleNotFoundError, match=re.escape("pip install samcontact[3d]")):
        plotting.view(dataset())


def test_command_refuses(tmp_path):
    file = results.save(dataset(), tmp_path / "results.nc")
    for options in ([], ["--html", "--all"]):
        assert CliRunner().invoke(main, ["export", str(file), *options]).exit_code == 2


@needs_pyvista
def test_a_folder_of_a_run_is_exported_in_both_formats(tmp_path):
    """Body 1 is exported, since body 2 is rigid and no body is selected."""
    rigid = make_simulation(4, SWIFT, sc.Material.rigid())
    grid = rigid.grid = make_grid(nx=9, ny=7, dx=5e-5, dy=5e-5, nz=4, dz=4e-5)
    rigid.initial_gap = np.zeros((9, 7))
    file = results.save(
        results.to_dataset(rigid, [FakeState(grid, 700.0)]), tmp_path / "results.nc"
    )
    for run, options in (
        (tmp_path, ["--vtk", "--html"]),
        (file, ["--vtk", "--html", "--output", str(tmp_path / "other.html")]),
        (tmp_path, ["--vtk", "--all", "--html"]),
    ):
        outcome = CliRunner().invoke(main, ["export", str(run), *options])
        assert outcome.exit_code == 0, outcome.output
    names = {path.name for path in tmp_path.iterdir()}
    assert {"results.vtr", "results_surface.vtr", "results.html", "results.pvd"} <= names
    assert {"other.vtr", "other_surface.vtr", "other.html"} <= names
    outcome = CliRunner().invoke(main, ["export", str(tmp_path), "--html", "--body", "2"])
    assert "dataset must have volume fields of body 2, got none" in outcome.stderr


def test_an_empty_folder_has_nothing_to_export(tmp_path):
    (tmp_path / "wear.nc").touch()
    outcome = CliRunner().invoke(main, ["export", str(tmp_path), "--vtk"])
    assert outcome.exit_code == 2
    assert "must contain one of results.nc, got wear.nc: specify the file" in outcome.stderr
    file = results.save(dataset()[["load"]], tmp_path / "wear.nc")
    outcome = CliRunner().invoke(main, ["export", str(file), "--html"])
    assert outcome.exit_code == 2
    assert "contains no contact fields to export" in outcome.stderr
