# SPDX-License-Identifier: GPL-3.0-or-later
"""The finite element files are complete and consistent with their own summaries."""

import numpy as np
import pytest

from reference import fem


@pytest.mark.parametrize("name", fem.CASES)
def test_case_agrees_with_its_summary(name):
    case = fem.load(name)
    assert case.parameters["nu"] > 0.0
    for axis, key in ((case.axis_loaded, "loaded"), (case.axis_unloaded, "unloaded")):
        assert axis["z_m"][0] == 0.0
        assert np.all(np.diff(axis["z_m"]) > 0.0)
        # The summary holds the maximum below the surface, interpolated.
        below = axis[axis["z_m"] > 0.2 * case.summary[key]["max_vm_depth_m"]]
        assert below["vonMises_Pa"].max() == pytest.approx(case.summary[key]["max_vm_Pa"], rel=5e-3)
        assert axis["gamma_p"].max() == pytest.approx(case.summary[key]["max_gamma_p"], rel=1e-3)
        mean = (axis["srr_Pa"] + axis["szz_Pa"] + axis["stt_Pa"]) / 3.0
        np.testing.assert_allclose(axis["hydrostatic_Pa"], mean, atol=2e4)
    assert case.surface_uz["uz_loaded_m"][0] == pytest.approx(
        case.summary["uz_center_loaded_m"], rel=1e-6
    )
    assert case.load_displacement["load_N"].max() > 0.0


@pytest.mark.parametrize("name", ["2a", "2b1500"])
def test_pressure_carries_the_load(name):
    case = fem.load(name)
    r, p = case.pressure_r["r_m"], case.pressure_r["p_Pa"]
    # Linear p between the nodes, integrated exactly against 2 pi r.
    ring = np.diff(r) * (r[:-1] * (2 * p[:-1] + p[1:]) + r[1:] * (p[:-1] + 2 * p[1:])) / 6.0
    assert 2.0 * np.pi * ring.sum() == pytest.approx(case.summary["W_N"], rel=1e-5)


def test_unknown_case_is_rejected():
    with pytest.raises(ValueError, match="expected one of"):
        fem.load("3x")
