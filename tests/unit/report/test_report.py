# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports: displayed numbers equal the dataset, and checks fail for modified results."""

import re
from types import SimpleNamespace

import numpy as np
import pytest
from click.testing import CliRunner
from selenium.webdriver.common.by import By

import samcontact as sc
from browser import chromium, served
from case_texts import MINIMAL
from core_fakes import ELASTIC, SWIFT, FakeState, make_simulation
from samcontact import report, results
from samcontact.cases import parse_case
from samcontact.commands.main import main

MARGINS = ("contact_edge_distance", "plastic_edge_distance_body2")

# with layers that resolve the plastic zone
CASE = MINIMAL.replace("nz = 12\ndz = 60e-6", "nz = 36\ndz = 20e-6")


@pytest.fixture(scope="module")
def data():
    """Return the dataset of a real run of a case."""
    case = parse_case(CASE + "\n[output]\nbody = 2\n")
    case._text = CASE
    simulation, path = case.build()
    return results.to_dataset(simulation, simulation.run(path, progress=False), case)


@pytest.fixture(scope="module")
def folder(data, tmp_path_factory):
    """Return the folder of a run after the command `report`."""
    folder = tmp_path_factory.mktemp("run")
    results.save(data, folder / "results.nc")
    outcome = CliRunner().invoke(main, ["report", str(folder)])
    assert outcome.exit_code == 0, outcome.output
    assert outcome.stdout == f"{folder / 'report.html'}\n"
    assert outcome.stderr == ""
    return folder


@pytest.fixture(scope="module")
def page(folder):
    """Open the report in a browser; return its page and the requested paths."""
    with served(folder) as (address, requested), chromium() as driver:
        driver.get(f"{address}/report.html")
        yield SimpleNamespace(driver=driver, requested=requested)


def cells(page, table):
    """Return the texts of the cells of a table, row by row, starting with the heading."""
    rows = page.driver.find_elements(By.CSS_SELECTOR, f"#{table} tr")
    return [[cell.text for cell in row.find_elements(By.CSS_SELECTOR, "th, td")] for row in rows]


def exact(page, table):
    """Return the numbers of a table in SI units; None for cells without a number."""
    script = """return [...document.querySelectorAll('#' + arguments[0] + ' tbody tr')].map(
        row => [...row.querySelectorAll('td')].map(
            cell => cell.querySelector('data') && cell.querySelector('data').value))"""
    return page.driver.execute_script(script, table)


def test_the_browser_shows_every_figure(page):
    script = "return [...document.images].map(i => [i.complete, i.naturalWidth, i.alt])"
    images = page.driver.execute_script(script)
    captions = [e.text for e in page.driver.find_elements(By.TAG_NAME, "figcaption")]
    assert len(images) == len(captions) == 13
    for complete, width, description in images:
        assert complete
        assert width > 300
        assert len(description) > 20
    assert "Pressure along x, increment 2, 600 N" in captions
    assert "Residual imprint, increment 3, 0 N" in captions
    assert captions[-1] == "Convergence"


def test_the_page_is_self_contained(page):
    assert set(page.requested) <= {"/report.html", "/favicon.ico"}
    assert [e for e in page.driver.get_log("browser") if "favicon" not in e["message"]] == []


def test_title_and_parameters(page):
    assert page.driver.title == "two balls"
    assert page.driver.find_element(By.TAG_NAME, "h1").text == "two balls"
    rows = cells(page, "parameters-table")
    assert ["grid", "dx", "60 µm"] in rows
    assert ["body2", "B", "945 MPa"] in rows
    assert ["body2", "C", "20 microstrain"] in rows
    assert ["surface", "Rx", "7.5 mm"] in rows
    assert ["path, part 1", "load", "600 N"] in rows
    assert CASE.strip() in page.driver.find_element(By.TAG_NAME, "pre").text


def test_increments_equal_the_dataset(page, data):
    (_, *headings), *rows = cells(page, "increments-table")
    columns = {
        "load [N]": ("load", 1.0),
        "approach [µm]": ("approach", 1e6),
        "maximum pressure [MPa]": ("max_pressure", 1e-6),
        "contact area [mm²]": ("contact_area", 1e6),
        "maximum von Mises stress, body 2 [MPa]": ("max_von_mises_body2", 1e-6),
        "maximum equivalent plastic strain, body 2 [%]": (
            "max_equivalent_plastic_strain_body2",
            1e2,
        ),
        "residual imprint depth (within the grid), body 2 [µm]": ("imprint_depth_body2", 1e6),
    }
    assert headings == list(columns)
    assert [row[0] for row in rows] == ["1", "2", "3"]
    behind = np.array(exact(page, "increments-table"), dtype=float)
    for index, (variable, factor) in enumerate(columns.values()):
        np.testing.assert_array_equal(behind[:, index], data[variable])
        shown = [float(row[index + 1]) for row in rows]
        np.testing.assert_allclose(shown, data[variable] * factor, rtol=1e-5)


def test_convergence_equals_the_dataset(page, data):
    headings, *rows = cells(page, "convergence-table")
    assert headings[1:4] == ["plastic iterations", "plastic-strain residual", "yield violation"]
    names = [
        "iterations", "plastic_strain_residual", "yield_violation", "contact_iterations",
        "substeps",
    ]  # fmt: skip
    behind = exact(page, "convergence-table")
    for index, name in enumerate(names):
        found = np.array([row[index] for row in behind], dtype=float)
        np.testing.assert_array_equal(found, data[name])
    assert rows[-1][6:8] == ["none", "none"]  # unloaded: there is no contact
    names = [
        "contact_edge_distance", "cells_across_contact", "layers_across_plastic_zone_body2",
        "plastic_edge_distance_body2",
    ]  # fmt: skip
    assert [float(value) for value in behind[1][5:]] == [float(data[name][1]) for name in names]


def test_hertz_table(page, data):
    assert "600 N" in page.driver.find_element(By.CSS_SELECTOR, "#hertz-table caption").text
    rows = {name: values for name, *values in cells(page, "hertz-table")[1:]}
    contact = sc.hertz.point(7.5e-3, 210e9 / (2 * (1 - 0.3**2)), load=600.0)
    here = float(data["max_pressure"][1])
    exact_text, here_text, difference = rows["maximum pressure"]
    assert exact_text == f"{contact.p0 * 1e-9:.6g} GPa"
    assert here_text == f"{here * 1e-9:.6g} GPa"
    assert float(difference.removesuffix(" %")) == pytest.approx(
        100 * (here / contact.p0 - 1), abs=0.01
    )
    assert set(rows) == {
        "maximum pressure", "approach", "contact area", "maximum von Mises stress"
    }  # fmt: skip


def test_checks_in_the_browser(page, data):
    checks_found = report.checks(data)
    assert all(check.passed for check in checks_found)
    assert page.driver.find_element(By.ID, "outcome").text == "16 of 16 checks passed"
    assert 0 < sum(check.of_input for check in checks_found) < len(checks_found)
    for name, of_input in (("checks-table", False), ("input-table", True)):
        shown = [check for check in checks_found if check.of_input is of_input]
        expected = [[v.name, v.shown, v.condition, "✓ passed"] for v in shown]
        assert cells(page, name)[1:] == expected
        behind = np.array([row[0] for row in exact(page, name)], dtype=float)
        np.testing.assert_array_equal(behind, [v.value for v in shown])


def test_results_precede_figures_and_checks(page):
    headings = [h.text for h in page.driver.find_elements(By.CSS_SELECTOR, "h2, h3")]
    assert headings == [
        "Results", "Comparison with elastic Hertz contact", "Figures", "Checks",
        "Plausibility of the input", "Parameters", "Increments", "Convergence", "Case file",
    ]  # fmt: skip


def test_results_are_the_maxima_of_the_increments(page, data):
    _, *rows = cells(page, "results-table")
    shown = {name: (number, value) for name, number, value in rows}
    peak = float(data["max_pressure"].max()) * 1e-6
    number, value = shown["maximum pressure [MPa]"]
    assert number == str(1 + int(np.argmax(data["max_pressure"].values)))
    assert float(value) == pytest.approx(peak, rel=1e-5)


def test_the_page_is_accessible_and_printable(page):
    driver = page.driver
    assert driver.find_element(By.TAG_NAME, "html").get_attribute("lang") == "en"
    unscoped = "return document.querySelectorAll('th:not([scope])').length"
    assert driver.execute_script(unscoped) == 0
    # nothing sticks out sideways, on a narrow screen too
    wider = "return document.documentElement.scrollWidth - document.documentElement.clientWidth"
    assert driver.execute_script(wider) <= 0
    assert len(driver.print_page()) > 50_000  # a PDF with the figures, base64


@pytest.mark.parametrize("width", [390, 800, 1280])
def test_numbers_are_not_wrapped(page, width):
    """Every cell with a number fits on one line, also on a phone."""
    size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 500}
    page.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    script = """const cells = document.querySelectorAll(
        'td.number, .numbers table:not(#results-table) tbody th, td.passed');
    return [...cells].filter(cell => {
        const range = document.createRange();
        range.selectNodeContents(cell);
        const tops = [...range.getClientRects()].map(box => Math.round(box.top));
        return Math.max(...tops) - Math.min(...tops) > 4;
    }).map(cell => cell.textContent)"""
    try:
        assert page.driver.execute_script("return document.querySelectorAll('td.number').length")
        assert page.driver.execute_script(script) == []
        wider = "return document.documentElement.scrollWidth - document.documentElement.clientWidth"
        assert page.driver.execute_script(wider) <= 0
        moved = """return [...document.querySelectorAll('.wide')].filter(
            box => box.scrollWidth > box.clientWidth).map(box => box.firstElementChild.id)"""
        long = {"increments-table", "convergence-table"} if width < 1280 else set()
        assert set(page.driver.execute_script(moved)) <= long
    finally:
        page.driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def named(checks_found, start):
    (found,) = [v for v in checks_found if v.name.startswith(start)]
    return found


def find(dataset, start):
    return named(report.checks(dataset), start)


@pytest.fixture(scope="module")
def sound(data):
    return report.checks(data)


def spoilt(data, name, change):
    copy = data.copy(deep=True)
    copy[name] = change(copy[name])
    return copy


def one_cell(value):
    def change(field):
        field[1, 0, 0] = value
        return field

    return change


SPOILERS = [
    ("load balance", "pressure", lambda p: 1.00001 * p, 1e-5),
    ("minimum contact pressure", "pressure", one_cell(-5.0), -5.0),
    ("minimum gap", "gap", one_cell(-1e-9), None),
    ("complementarity", "pressure", one_cell(1e9), None),
    ("maximum relative violation", "yield_violation", lambda x: x + 2e-6, None),
    ("relative change", "plastic_strain_residual", lambda x: x * 0 + 1e-3, 1e-3),
    ("minimum distance between contact", "contact_edge_distance", lambda x: x * 0, 0.0),
    ("minimum distance between plastic", "plastic_edge_distance_body2", lambda x: x * 0, 0.0),
    ("cells across", "cells_across_contact", lambda x: x * 0 + 3, 3.0),
    ("layers across", "layers_across_plastic_zone_body2", lambda x: x * 0 + 3, 3.0),
    (
        "maximum plastic strain magnitude",
        "max_plastic_strain_magnitude_body2",
        lambda x: x * 0 + 0.06,
        0.06,
    ),
]


@pytest.mark.parametrize(("start", "name", "change", "value"), SPOILERS)
def test_every_check_can_fail(data, sound, start, name, change, value):
    bad = spoilt(data, name, change)
    check = find(bad, start)
    assert not check.passed
    if value is not None:
        assert check.value == pytest.approx(value, rel=1e-6)
    assert named(sound, start).passed


def test_a_failed_check_is_reported(data, tmp_path, undrawn):
    results.save(spoilt(data, "contact_edge_distance", lambda x: x * 0), tmp_path / "bad.nc")
    outcome = CliRunner().invoke(main, ["report", str(tmp_path / "bad.nc")])
    assert outcome.exit_code == 0
    assert (
        "check failed: minimum distance between contact and grid edge [cells]: 0" in outcome.stderr
    )
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "15 of 16 checks passed" in text
    assert text.count("✗ failed") == 1


def test_the_load_is_compared_with_the_case(data):
    other = data.copy(deep=True)
    other["load"] = other["load"] * 0.9
    other["pressure"] = other["pressure"] * 0.9  # consistent, but not the case's load
    assert find(other, "load balance").value == pytest.approx(0.1, rel=1e-6)


def test_contact_at_the_grid_edge_is_detected():
    grid = sc.Grid(13, 13, 40e-6, 40e-6, 6, 40e-6)
    gap = sc.surfaces.paraboloid(grid, 7.5e-3)
    simulation = sc.Simulation(grid, ELASTIC, SWIFT, gap, on_border="warn")
    with pytest.warns(sc.GridTooSmallWarning):
        states = simulation.run([{"load": 500.0}], progress=False)
    dataset = results.to_dataset(simulation, states)
    for name in MARGINS:
        assert float(dataset[name][0]) == 0.0
    assert not find(dataset, "minimum distance between contact").passed


def written(dataset, tmp_path):
    return report.write(dataset, tmp_path / "report.html").read_text(encoding="utf-8")


def test_elastic_surface_run_without_case(tmp_path, undrawn):
    grid = sc.Grid(16, 16, 40e-6, 40e-6)
    simulation = sc.Simulation(grid, ELASTIC, ELASTIC, sc.surfaces.paraboloid(grid, 7.5e-3))
    states = simulation.run([{"load": 300.0}], progress=False)
    text = written(results.to_dataset(simulation, states), tmp_path)
    assert "<h1>Contact</h1>" in text
    assert "6 of 6 checks passed" in text
    assert "40 µm × 40 µm" in text
    assert 'id="hertz-table"' not in text
    assert "Case file" not in text
    # only what was computed is drawn
    assert re.findall(r"<figcaption>(.*?)</figcaption>", text) == [
        "Pressure along x, increment 1, 300 N",
        "Pressure along y, increment 1, 300 N",
        "Map of the pressure, increment 1, 300 N",
        "Map of the gap, increment 1, 300 N",
    ]


def test_moving_contact_has_a_track(tmp_path, undrawn):
    grid = sc.Grid(15, 13, 60e-6, 60e-6, 12, 60e-6)
    simulation = sc.Simulation(grid, ELASTIC, SWIFT, sc.surfaces.paraboloid(grid, 7.5e-3))
    move = {"load": 600.0, "advance": (-60e-6, -60e-6)}
    states = simulation.run([{"load": 600.0}, move, move, {"load": 0.0}], progress=False)
    dataset = results.to_dataset(simulation, states)
    text = written(dataset, tmp_path)
    for caption in ("Residual imprint", "Map of the residual imprint", "Residual von Mises stress"):
        assert f"{caption} of the track, body 2, unloaded" in text
    assert "Residual imprint, increment" not in text  # a corner of it
    assert "travel, body 2 [µm]" in text
    # what the contact leaves behind may leave the grid, too
    assert all(check.passed for check in report.checks(dataset))


def test_prescribed_tractions_have_no_complementarity(tmp_path, undrawn):
    grid = sc.Grid(8, 8, 60e-6, 60e-6)
    simulation = sc.Simulation(grid, ELASTIC, ELASTIC, np.zeros((8, 8)))
    pressure = np.zeros((8, 8))
    pressure[3:5, 3:5] = 1e9
    dataset = results.to_dataset(simulation, [simulation.step(pressure=pressure)])
    names = [check.name for check in report.checks(dataset)]
    solved = ("minimum gap", "minimum contact pressure", "complementarity")
    assert not any(name.startswith(solved) for name in names)
    assert "Load–approach curve" not in written(dataset, tmp_path)


def test_the_selected_heated_body_is_reported(tmp_path, undrawn):
    thermal = SWIFT.with_thermal(50.2, 11.7e-6, 1.37e-5)
    simulation = make_simulation(body1=thermal, body2=ELASTIC)
    states = [FakeState(simulation.grid, load) for load in (100.0, 300.0)]
    dataset = results.to_dataset(simulation, states, body=1)
    text = written(dataset, tmp_path)
    assert "Flash temperature, body 1, increment 2, 300 N" in text
    assert "Von Mises stress, body 1, increment 2, 300 N" in text


def test_texts_are_escaped_and_old_cases_are_accepted(data, tmp_path, undrawn):
    other = data.copy()
    other.attrs = data.attrs | {"title": "<script>1</script>", "case": "[grid]\nunknown = 1\n"}
    text = written(other, tmp_path)
    assert "<script" not in text
    assert "&lt;script&gt;" in text
    assert 'id="hertz-table"' not in text


def test_folders_without_a_run_are_refused(data, tmp_path):
    with pytest.raises(ValueError, match="must be from a run, but has no pressure"):
        report.write(data.drop_vars("pressure"), tmp_path / "report.html")
    outcome = CliRunner().invoke(main, ["report", str(tmp_path / "results.nc")])
    assert outcome.exit_code == 1
    assert "no results file at" in outcome.stderr
