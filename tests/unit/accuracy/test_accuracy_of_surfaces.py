# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs to an accuracy of periodic, rough and measured surfaces."""

import itertools
import math

import numpy as np
import pytest

import samcontact as sc
from command import fields, invoke
from samcontact import report, surfaces
from samcontact.accuracy import estimate
from samcontact.accuracy.grids import slope_between_samples
from samcontact.accuracy.refinable_case import RefinableCase
from samcontact.cases import Case

SIDE, CELLS = 1e-4, 16
GRID = {"nx": CELLS, "ny": CELLS, "dx": SIDE / CELLS, "dy": SIDE / CELLS}
ROUGH = {"kind": "self_affine", "rms_height": 2e-8, "hurst": 0.7, "seed": 1}
E, NU = 70e9, 0.3
PRESSED = {
    "title": "rough",
    "grid": GRID | {"periodic": "xy"},
    "body1": {"law": "rigid"},
    "body2": {"law": "elastic", "E": E, "nu": NU},
    "surface": {"shape": "paraboloid", "Rx": math.inf, "roughness": ROUGH},
    "path": [{"load": 0.8}],
}
WAVY = """title = "Westergaard"
accuracy = 0.002

[grid]
nx = 32
ny = 1
dx = 3.125e-5
dy = 1e-3
periodic = "xy"

[body1]
law = "rigid"

[body2]
law = "elastic"
E = 70e9
nu = 0.3

[surface]
shape = "file"
path = "wave.txt"

[[path]]
load = LOAD
"""


def test_a_wave_in_a_file_is_closer_to_its_closed_form_than_the_stated_error(tmp_path, undrawn):
    """Westergaard (1939), doi:10.1115/1.4008919: heights from a file, in a case file and a report.

    The cubic interpolation of 32 samples differs from the wave by 1e-5 of its amplitude.
    """
    length, amplitude, filled = 1e-3, 1e-6, 0.3  # filled: mean pressure over that of full contact
    x = (np.arange(32) - 15.5) / 32
    np.savetxt(tmp_path / "wave.txt", amplitude * np.cos(2 * np.pi * x)[:, None])
    mean = filled * math.pi * E / (1 - NU**2) * amplitude / length
    (tmp_path / "wave.toml").write_text(WAVY.replace("LOAD", repr(mean * length**2)))
    outcome = invoke("run", tmp_path / "wave.toml", "--output", tmp_path, "--no-figures")
    assert outcome.exit_code == 0, outcome.output
    assert "errors do not include waves of the real surface that are shorter" in " ".join(
        outcome.stdout.split()
    )
    data = fields(tmp_path)
    angle = math.asin(math.sqrt(filled))
    truth = {
        "max_pressure": 2 * mean / math.sin(angle),
        "contact_area": 2 * angle / math.pi * length**2,
    }
    for name, exact in truth.items():
        value, error = (float(data[f"{name}_{part}"][-1]) for part in ("best", "error"))
        assert abs(value - exact) <= error <= 0.002 * exact
    report.write(data, tmp_path / "report.html")
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "heights interpolated between samples" in page


def grids_of(change, count, accuracy=0.01):
    refinable = RefinableCase(Case.model_validate(PRESSED | {"accuracy": accuracy} | change))
    refinable.accept(accuracy)
    values, margins = [], []
    for level in range(count):
        run = refinable.run(level, 1)
        values.append(run.values[-1])
        margins.append(run.margins[-1])
    return refinable, np.array(values), np.array(margins)


BALL = {"shape": "paraboloid", "Rx": 2e-3, "roughness": ROUGH | {"rms_height": 5e-8}}
OPEN = {"grid": GRID, "surface": BALL, "path": [{"load": 0.6}]}
WAVES = {
    "surface": PRESSED["surface"]
    | {
        "roughness": {
            "kind": "sinusoidal",
            "amplitude": 5e-8,
            "wavelength_x": SIDE / 2,
            "wavelength_y": SIDE,
        }
    }
}


def ratios(change):
    """Return true over stated errors after 3, 4 and 5 grids, as compared with 7 grids."""
    refinable, values, margins = grids_of(change, 7)
    truth = estimate.extrapolate_grids(values, np.full(values.shape[1], 1.99)).values
    found = []
    for count in (3, 4, 5):
        one = estimate.extrapolate_grids(values[:count], refinable.orders)
        found.append(np.abs(one.values - truth) / (one.errors + margins[count - 1]))
    return np.array(found)


@pytest.mark.parametrize(
    "change",
    [
        pytest.param({}, id="flat"),
        pytest.param(OPEN, id="ball", marks=pytest.mark.slow),
        pytest.param(WAVES, id="waves", marks=pytest.mark.slow),
    ],
)
def test_errors_of_many_spots_exceed_the_distance_from_finer_grids(change):
    assert np.all(ratios(change) <= 1.0)


@pytest.mark.slow
def test_errors_of_random_surfaces_cover_the_true_ones():
    found = []
    for case, seed in itertools.product((PRESSED, OPEN), range(2, 12)):
        surface = case["surface"]
        rough = surface["roughness"] | {"seed": seed}
        found.append(ratios(case | {"surface": surface | {"roughness": rough}}))
    assert np.max(found) < 1.1
    assert np.count_nonzero(np.array(found) > 1.0) <= 1


@pytest.mark.parametrize("periodic", ["xy", ""])
@pytest.mark.parametrize("cells", [2, 3, 4, 5, 8])
def test_the_slope_between_samples_is_stated_from_8_samples_on(cells, periodic):
    rough = ROUGH | {"wavelength_min": cells * SIDE / CELLS}
    round_ball = {"shape": "paraboloid", "Rx": 0.01, "roughness": rough}
    case = PRESSED | {"grid": GRID | {"periodic": periodic}}
    case |= {"surface": PRESSED["surface"] | {"roughness": rough} if periodic else round_ball}
    slope = slope_between_samples(Case.model_validate(case))
    assert 0.05 < slope < 1.0 if 2 * CELLS / cells >= 8 else math.isnan(slope)


def test_finer_grids_keep_the_extent_and_the_waves_of_the_given_one(tmp_path):
    found = sc.to_accuracy(PRESSED, 0.5, quantities=["max_pressure"], progress=False)
    assert found.reached
    for nx, ny, *_ in found.runs:
        assert nx == ny >= 2 * CELLS  # four cells per shortest wave
    assert found.grid.nx * found.grid.dx == pytest.approx(SIDE, rel=1e-12)
    assert found.grid.periodic == "xy"
    coarse = Case.model_validate(PRESSED).grid.build()
    heights = surfaces.rough_self_affine(coarse, 2e-8, 0.7, seed=1)
    gap = found.case.build()[0].initial_gap
    waves = np.abs(np.fft.fft2(gap)) / gap.size
    high = np.abs(np.fft.fftfreq(found.grid.nx, 1 / found.grid.nx)) > CELLS / 2
    assert waves[high].max() < 1e-12 * waves.max()
    assert np.abs(surfaces.interpolated(heights, coarse, coarse) - heights).max() < 1e-20
    # most of the slope of a fractal lies at the shortest waves of its grid
    assert 0.2 < found.slope_beyond < 1.0
    assert found.to_dataset().attrs["slope_beyond"] == found.slope_beyond


def test_measured_surfaces_start_at_their_own_samples(tmp_path):
    """The given cells are twice as long as the samples of the file."""
    x = np.arange(2 * CELLS) * SIDE / (2 * CELLS)
    z = 1e-8 * np.cos(2 * np.pi * 3 * x / SIDE)
    np.save(tmp_path / "z.npy", np.add.outer(z, z))
    step = SIDE / (2 * CELLS)
    surface = {"shape": "file", "path": str(tmp_path / "z.npy"), "dx": step, "periodic": "xy"}
    case = Case.model_validate(PRESSED | {"surface": surface, "accuracy": 0.1})
    refinable = RefinableCase(case)
    assert refinable.grids.sizes(0) == pytest.approx((step / 2, step / 2))
    gap = refinable.on(0, 1).build()[0].initial_gap
    assert np.ptp(gap) == pytest.approx(4e-8, rel=2e-2)


def test_a_line_contact_needs_a_period_along_its_axis():
    line = {
        "surface": {"shape": "cylinder", "R": 2e-3},
        "grid": {"nx": 31, "ny": 1, "dx": 4e-6, "dy": 1e-6, "periodic": "y"},
        "path": [{"load": 0.05}],
    }
    found = sc.to_accuracy(PRESSED | line, 0.01, progress=False)
    line_load = 0.05 / 1e-6
    modulus = E / (1 - NU**2)
    exact = math.sqrt(line_load * modulus / (math.pi * 2e-3))
    assert found.reached
    assert abs(found.values["max_pressure"] - exact) <= found.errors["max_pressure"] + 2e-4 * exact
    with pytest.raises(ValueError, match=r'infinite length.*periodic = "y"'):
        sc.to_accuracy(PRESSED | line | {"grid": GRID}, 0.01)
