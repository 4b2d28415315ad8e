# SPDX-License-Identifier: GPL-3.0-or-later
"""Empirical models of a flattened sphere: limits, branches, and errors."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from samcontact import critical, flattening, hertz

SPHERE = {"R": 10e-3, "E_star": 222.8e9, "nu": 0.3, "yield_stress": 0.9e9}
MODELS = {
    flattening.kogut_etsion: critical.kogut_etsion(**SPHERE),
    flattening.jackson_green: critical.jackson_green(**SPHERE),
}
both = pytest.mark.parametrize(("model", "onset"), MODELS.items())


def at(model, ratio, **changed):
    """Return the model at a multiple of its own critical interference."""
    sphere = {**SPHERE, **changed}
    onset = getattr(critical, model.__name__)(**sphere)
    return model(ratio * onset.interference, **sphere)


@both
@pytest.mark.parametrize("ratio", [0.1, 0.5, 1.0])
def test_is_hertz_up_to_the_onset_of_yield(model, onset, ratio):
    found = at(model, ratio)
    contact = hertz.point(SPHERE["R"], SPHERE["E_star"], approach=ratio * onset.interference)
    assert found.load == pytest.approx(contact.load, rel=1e-12)
    assert found.area == pytest.approx(math.pi * contact.a**2, rel=1e-12)
    assert found.mean_pressure == pytest.approx(contact.p0 * 2 / 3, rel=1e-12)
    assert found.interference_ratio == pytest.approx(ratio, rel=1e-12)
    assert found.critical == onset


@both
def test_no_interference_no_contact(model, onset):
    found = model(0.0, **SPHERE)
    assert (found.load, found.area, found.mean_pressure) == (0.0, 0.0, 0.0)


@both
def test_is_vectorised(model, onset):
    w = onset.interference * np.linspace(0, 100, 12).reshape(3, 4)
    found = model(w, **SPHERE)
    assert found.load.shape == found.area.shape == found.mean_pressure.shape == (3, 4)
    single = model(w[1, 2], **SPHERE)
    assert isinstance(single.load, float)
    assert single.load == pytest.approx(found.load[1, 2], rel=1e-14)
    assert single.area == pytest.approx(found.area[1, 2], rel=1e-14)
    np.testing.assert_allclose(found.load, onset.load * found.load_ratio, rtol=1e-14)
    np.testing.assert_allclose(found.area, math.pi * onset.a**2 * found.area_ratio, rtol=1e-14)


@given(ratio=st.floats(1e-3, 110.0))
def test_mean_pressure_is_load_over_area(ratio):
    for model in MODELS:
        found = at(model, ratio)
        assert found.mean_pressure * found.area == pytest.approx(found.load, rel=1e-13)
        assert found.mean_pressure < 2.84 * SPHERE["yield_stress"]


@pytest.mark.parametrize(("ratio", "load", "area"), [(1.0, 0.03, -0.07), (6.0, 0.0168, 0.0292)])
def test_kogut_etsion_jumps_as_published(ratio, load, area):
    below = at(flattening.kogut_etsion, ratio * (1 - 1e-9))
    above = at(flattening.kogut_etsion, ratio * (1 + 1e-9))
    assert above.load / below.load - 1 == pytest.approx(load, abs=2e-4)
    assert above.area / below.area - 1 == pytest.approx(area, abs=2e-4)


@pytest.mark.parametrize("ratio", [1.5, 5.0, 7.0, 30.0, 110.0])
def test_kogut_etsion_mean_pressure_is_the_published_fit(ratio):
    fit = 1.19 * ratio**0.289 if ratio < 6 else 1.61 * ratio**0.117
    found = at(flattening.kogut_etsion, ratio).mean_pressure / SPHERE["yield_stress"]
    assert found == pytest.approx(fit, rel=1e-2)


def test_jackson_green_is_continuous():
    below = at(flattening.jackson_green, 1.9 * (1 - 1e-9))
    above = at(flattening.jackson_green, 1.9 * (1 + 1e-9))
    assert above.load == pytest.approx(below.load, rel=1e-2)
    assert above.area == pytest.approx(below.area, rel=1e-8)


def test_jackson_green_hardness_falls_with_the_contact_radius():
    found = [
        at(flattening.jackson_green, 50.0, yield_stress=y).mean_pressure / y
        for y in (1e3, 1e6, 1e8, 1e9)
    ]
    assert np.all(np.diff(found) < 0)
    # for a contact radius far below R the hardness is 2.84 yield stresses
    C = 1.295 * math.exp(0.736 * 0.3)
    load = math.exp(-0.25 * 50 ** (5 / 12)) * 50**1.5
    load += 4 * 2.84 / C * (1 - math.exp(-(50 ** (5 / 9)) / 25)) * 50
    area = 50 * (50 / 1.9) ** 0.14
    assert found[0] == pytest.approx(load / area * 2 / 3 * C, rel=1e-3)


def test_the_models_agree_with_each_other():
    w = np.linspace(2, 100, 50) * MODELS[flattening.kogut_etsion].interference
    soft = {**SPHERE, "yield_stress": 1e-3 * SPHERE["yield_stress"]}
    w = w * 1e-6
    one, other = (model(w, **soft) for model in MODELS)
    assert np.abs(one.load / other.load - 1).max() < 0.06
    assert np.abs(one.area / other.area - 1).max() < 0.08


def test_kogut_etsion_ends_at_110():
    limit = 110 * MODELS[flattening.kogut_etsion].interference
    assert flattening.kogut_etsion(limit, **SPHERE).load > 0
    with pytest.raises(ValueError, match=r"must be <= .* \(110 times the critical value\), got"):
        flattening.kogut_etsion([0.0, 1.01 * limit], **SPHERE)
    assert flattening.jackson_green(1.01 * limit, **SPHERE).load > 0


@both
@pytest.mark.parametrize(
    ("changed", "error", "message"),
    [
        ({"interference": -1e-9}, ValueError, "interference must be finite and >= 0, got -1e-09"),
        ({"interference": [1e-9, math.nan]}, ValueError, "interference must be finite and >= 0"),
        (
            {"interference": "deep"},
            TypeError,
            "interference must be an array of numbers, got texts",
        ),
        ({"R": 0.0}, ValueError, "R must be a finite number > 0, got 0.0"),
        ({"E_star": math.inf}, ValueError, "E_star must be a finite number > 0, got inf"),
        ({"nu": 0.6}, ValueError, r"nu must be in \[0, 0\.5\], got 0\.6"),
        ({"yield_stress": -1.0}, ValueError, "yield_stress must be a finite number > 0, got -1"),
    ],
)
def test_bad_input_is_named(model, onset, changed, error, message):
    with pytest.raises(error, match=message):
        model(**{"interference": 1e-9, **SPHERE, **changed})
