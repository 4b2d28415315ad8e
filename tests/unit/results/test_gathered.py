# SPDX-License-Identifier: GPL-3.0-or-later
"""Results with plastic strain in several subdomains store only the cells with strain."""

import warnings

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkCellCenters
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

import samcontact as sc
from rough_setups import PERCENT, RIGID, SOFT, STEEL, simulation
from samcontact import plotting, report, results
from samcontact.commands.folder import is_own

TENSORS = ("stress", "residual_stress", "plastic_strain")
SCALARS = ("von_mises", "hydrostatic", "equivalent_plastic_strain")


@pytest.fixture(scope="module")
def solved(tmp_path_factory):
    """Return states, and their results from a file."""
    run = simulation(SOFT, STEEL, friction=0.2)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        states = [run.step(load=percent * PERCENT) for percent in (2, 3, 0.5)]
    file = tmp_path_factory.mktemp("gathered") / "results.nc"
    results.save(results.to_dataset(run, states), file)
    with results.open_results(file) as dataset:
        yield states, dataset


@pytest.mark.parametrize("body", [1, 2])
def test_fields_are_those_of_the_states(solved, body):
    states, dataset = solved
    for number in dataset["output_increment"].values:
        state = states[number - 1]
        strained = state.equivalent_plastic_strain(body) > 0
        for name in TENSORS + SCALARS:
            stored = dataset[f"{name}_body{body}"].sel(output_increment=number)
            assert stored.shape[-1] < 0.1 * strained.size
            found = results.on_grid(stored, dataset).values
            expected = getattr(state, name)(body)
            if "strain" in name:
                np.testing.assert_array_equal(found, expected)
                continue
            far = np.abs(found - expected)[..., strained].max()
            assert far < 3e-3 * np.abs(expected).max()
            if number == dataset["output_increment"][-1]:
                assert np.isnan(found[..., ~strained]).all()
        largest = float(dataset[f"max_von_mises_body{body}"].sel(increment=number))
        assert largest == pytest.approx(state.von_mises(body).max(), rel=2e-3)
    pressure = dataset["pressure"]
    assert results.on_grid(pressure, dataset) is pressure


def test_temperature_covers_all_cells(tmp_path):
    hot = STEEL.with_thermal(45.0, 12e-6, 12e-6)
    run = simulation(RIGID, hot, friction=0.1, heat=sc.Heat(factor=(0.0, 0.01)))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        state = run.step(load=3 * PERCENT)
    assert len(state.zones()) > 1
    dataset = results.to_dataset(run, [state])
    volume, _ = results.to_vtk(dataset, tmp_path / "results.vtr")
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(volume))
    reader.Update()
    read = vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("temperature"))
    expected = state.temperature()[state.equivalent_plastic_strain() > 0]
    np.testing.assert_array_equal(read, expected)


@pytest.mark.parametrize("body", [1, 2])
def test_vtk_files_contain_the_gathered_cells(solved, body, tmp_path):
    states, dataset = solved
    volume, _ = results.to_vtk(dataset, tmp_path / "results.vtr", increment=3, body=body)
    assert is_own(volume)
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(volume))
    reader.Update()
    centres = vtkCellCenters()
    centres.SetInputData(reader.GetOutput())
    centres.Update()
    x, y, z = vtk_to_numpy(centres.GetOutput().GetPoints().GetData()).T
    grid, up = states[-1].grid, 1 if body == 1 else -1
    cells = [
        np.rint(v / size + shift).astype(int)
        for v, size, shift in (
            (x, grid.dx, 0.5 * (grid.nx - 1)),
            (y, grid.dy, 0.5 * (grid.ny - 1)),
            (up * z, grid.dz, -0.5),
        )
    ]
    read = reader.GetOutput().GetCellData()
    strain = np.zeros((*grid.surface_shape, grid.nz))
    strain[tuple(cells)] = vtk_to_numpy(read.GetArray("equivalent_plastic_strain"))
    np.testing.assert_array_equal(strain, states[-1].equivalent_plastic_strain(body))
    tensor = vtk_to_numpy(read.GetArray("plastic_strain"))
    assert read.GetArray("plastic_strain").GetComponentName(5) == "xz"
    expected = states[-1].plastic_strain(body)[(slice(None), *cells)]
    np.testing.assert_array_equal(tensor.T[[0, 3, 5]], expected[[0, 5, 4]] * [[1], [1], [up]])


def test_figures_and_a_report_show_the_strain(solved, tmp_path, undrawn):
    _, dataset = solved
    drawn = {file.stem for file in plotting.summary_figures(dataset, tmp_path)}
    assert {"sections", "imprint"} <= drawn
    assert not {"axis_stress", "residual"} & drawn
    assert all(check.passed for check in report.checks(dataset) if "residual" in check.name)
    page = report.write(dataset, tmp_path / "report.html").read_text(encoding="utf-8")
    assert "equivalent plastic strain, body 2" in page.lower()


def test_strain_in_one_box_is_stored_in_all_cells():
    run = simulation(zones="one")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        state = run.step(load=PERCENT)
    dataset = results.to_dataset(run, [state])
    assert dataset["stress_body2"].dims[-3:] == ("x", "y", "z")
