# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of lubricated contacts show the values of the solution."""

import functools
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

import samcontact as sc
from samcontact import plotting, results
from samcontact.lubrication import Boundary, FilmHeat, FilmLevel, FilmSolution, StribeckCurve
from samcontact.lubrication.film_solution import FilmPast

GRID = sc.Grid(12, 10, 1e-5, 1e-5)
OIL = sc.Lubricant.roelands(0.04, 22e-9).with_eyring(5e6)


@functools.cache
def film(speed=1.0, share=0.25):
    """Return a film that is thinner than the gap by a constant, with the pressure of Hertz."""
    gap = 1e-7 + (GRID.x[:, None] ** 2 + GRID.y[None, :] ** 2) / 2e-2
    pressure = 4e8 * np.sqrt(np.maximum(1 - 2e8 * (gap - 1e-7) * 0.05, 0))
    velocities = np.array([[1.1 * speed, 0.0], [0.9 * speed, 0.0]])
    return FilmSolution(
        GRID, OIL, velocities, gap - 1e-7, (1 - share) * pressure, share * pressure, gap,
        np.ones((12, 10)), 1e-7, float(pressure.sum() * GRID.cell_area), 1e-8,
        (FilmLevel((12, 10), 3, 9, 20.0, 1e-8, 1e-7),),
        Boundary(2e-9, friction=0.12),
    )  # fmt: skip


def test_the_profile_shows_pressure_and_film_on_the_middle_line():
    ax = plotting.film_profile(film())
    (right,) = (other for other in ax.figure.axes if other is not ax)
    row = GRID.ny // 2
    rows = film().film[:, [row - 1, row]]
    shown = right.lines[0].get_ydata()
    assert any(np.allclose(shown, 1e9 * rows[:, k]) for k in (0, 1))
    assert ax.lines[0].get_ydata().max() == pytest.approx(film().pressure.max() / 1e6)
    assert ax.get_ylabel() == "pressure [MPa]"
    assert "central film 100 nm" in ax.get_title()


def test_the_map_shows_the_film_in_its_unit():
    ax = plotting.film_map(film(), max_film=2e-7)
    mesh = ax.collections[0]
    assert np.asarray(mesh.get_array()).ravel() == pytest.approx(1e9 * film().film.T.ravel())
    assert mesh.get_clim() == pytest.approx((0.0, 200.0))


def test_the_interferogram_is_bright_and_dark_at_quarter_waves():
    dark = film().film.min() * 4 * 1.5
    for wavelength, intensity in ((dark, 0.0), (0.5 * dark, 1.0)):
        ax = plotting.interferogram(film(), wavelength=wavelength)
        values = np.asarray(ax.collections[0].get_array())
        centre = values[values.shape[0] // 2, values.shape[1] // 2]
        assert centre == pytest.approx(intensity, abs=0.02)


def test_fringes_that_no_pixel_resolves_are_grey():
    """The mean intensity over a pixel, not a false pattern (moire)."""
    values = plotting.interferogram(film(), wavelength=2e-12).collections[0].get_array()
    assert np.ptp(np.asarray(values)[:10]) < 1e-9
    assert np.asarray(values)[0, 0] == pytest.approx(0.5)


def test_the_stribeck_curve_shows_share_and_friction():
    films = tuple(film(speed, share) for speed, share in ((1e-3, 0.9), (1e-2, 0.4), (1e-1, 0.1)))
    ax = plotting.stribeck_curve(StribeckCurve(films, films[0].pressure))
    assert ax.lines[0].get_xdata() == pytest.approx([1e-3, 1e-2, 1e-1])
    assert ax.lines[0].get_ydata() == pytest.approx([90.0, 40.0, 10.0])
    (right,) = (other for other in ax.figure.axes if other is not ax)
    expected = [sc.lubrication.friction(one).coefficient for one in films]
    assert right.lines[0].get_ydata() == pytest.approx(expected)


def test_the_traction_curve_is_drawn_in_order():
    ax = plotting.traction_curve([0.1, 0.0], [0.02, 0.0])
    assert ax.lines[0].get_xdata() == pytest.approx([0.0, 0.1])


def in_time(count=3):
    """Return films at several times."""
    return tuple(
        replace(film(1.0 + 0.1 * n), past=FilmPast(
            1e-4 * n, np.zeros((2, 2)), film().content, film().gap, 4e8
        ))
        for n in range(count)
    )  # fmt: skip


def test_films_over_time_and_animated(tmp_path):
    """The lines have the values of the dataset, and the frames those of each film."""
    data = results.films_dataset(in_time())
    ax = plotting.film_over_time(data)
    assert ax.lines[0].get_xdata() == pytest.approx([0.0, 100.0, 200.0])
    assert ax.lines[0].get_ydata() == pytest.approx(1e9 * data["central_film"].values)
    assert ax.get_xlabel() == "time [µs]"
    shown = plotting.film_animation(in_time())
    plotting.save_animation(shown, tmp_path / "film.gif", dpi=40)
    assert shown._fig.get_suptitle() == "time 200 µs"
    with Image.open(tmp_path / "film.gif") as image:
        assert image.n_frames == 3
    with pytest.raises(ValueError, match="at least one film"):
        plotting.film_animation(())
    with pytest.raises(ValueError, match="dataset must contain times"):
        plotting.film_over_time(results.films_dataset([film()]))
    with pytest.raises(ValueError, match="dataset must contain residual displacements"):
        plotting.film_imprint(results.films_dataset([film()]))


def test_the_temperature_along_x_is_that_of_the_film():
    shape = GRID.surface_shape
    rise = np.multiply.outer([1.0, 2.0], 10.0 * np.ones(shape))
    warm = OIL.with_thermal(0.14, 1.7e6, 0.04).heat
    heat = FilmHeat(warm, rise, rise, np.zeros(shape), np.full(shape, 30.0), GRID.cell_area)
    ax = plotting.film_temperature(replace(film(), heat=heat))
    assert [line.get_ydata()[0] for line in ax.lines] == [30.0, 10.0, 20.0]
    with pytest.raises(ValueError, match="film must have temperatures"):
        plotting.film_temperature(film())


@pytest.mark.parametrize(
    ("load", "alpha"), [(20.0, 22e-9), (60.0, 10e-9), (1e-3, 22e-9), (20.0, 0.0)]
)
def test_the_regime_chart_marks_the_contact_in_its_regime(load, alpha):
    contact, oil = sc.hertz.point(0.01, 1.1e11, load=load), sc.Lubricant.roelands(0.04, alpha)
    ax = plotting.regime_chart(contact, (1.0, 1.0), oil)
    (point,) = ax.lines
    place = point.get_xdata()[0], point.get_ydata()[0]
    regime = sc.lubrication.regime(contact, (1.0, 1.0), oil)
    assert regime in {text.get_text().replace("\n", "-") for text in ax.texts}
    low, high = ax.get_ylim()
    assert low <= place[1] <= high
    texts = [text.get_position() for text in ax.texts]  # none hides the dot
    near = np.abs(np.log10(np.array(texts) / place))
    assert np.all((near[:, 0] > 1.0) | (near[:, 1] > 0.4))


def test_other_objects_are_refused():
    for draw in (plotting.film_map, plotting.film_profile, plotting.interferogram):
        with pytest.raises(TypeError, match="film must be a"):
            draw(film().film)
    with pytest.raises(TypeError, match="curve must be a"):
        plotting.stribeck_curve(film())
