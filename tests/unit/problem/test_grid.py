# SPDX-License-Identifier: GPL-3.0-or-later
"""Grid: positions of its points, and refused arguments."""

import math
import pickle
import re

import numpy as np
import pytest

import samcontact as sc


def test_points_are_centred_and_layers_start_at_the_surface():
    grid = sc.Grid(4, 3, 2e-6, 5e-6, 3, 4e-6)
    np.testing.assert_allclose(grid.x, [-3e-6, -1e-6, 1e-6, 3e-6], rtol=1e-14)
    np.testing.assert_allclose(grid.y, [-5e-6, 0.0, 5e-6], rtol=1e-14, atol=0)
    np.testing.assert_allclose(grid.z, [2e-6, 6e-6, 10e-6], rtol=1e-14)
    assert (grid.surface_shape, grid.volume_shape) == ((4, 3), (4, 3, 3))
    assert grid.cell_area == pytest.approx(1e-11, rel=1e-14)


def test_surface_only():
    grid = sc.Grid(4, 3, 1.0, 1.0)
    assert (grid.nz, grid.dz, grid.z.shape, grid.volume_shape) == (0, None, (0,), (4, 3, 0))


def test_is_a_value():
    grid = sc.Grid(4, 3, 1e-6, 2e-6, 5, 3e-6)
    same = sc.Grid(np.int64(4), 3, np.float64(1e-6), 2e-6, nz=5, dz=3e-6)
    assert same == grid
    assert hash(same) == hash(grid)
    assert sc.Grid(4, 3, 1e-6, 2e-6, 6, 3e-6) != grid
    _ = grid.x  # what is cached must not stand in the way of a copy
    copy = pickle.loads(pickle.dumps(grid))
    assert copy == grid
    np.testing.assert_array_equal(copy.z, grid.z)
    with pytest.raises(AttributeError):
        grid.nx = 5


@pytest.mark.parametrize(
    ("changed", "error", "text"),
    [
        ({"nx": 0}, ValueError, "nx must be an integer >= 1, got 0"),
        ({"ny": -3}, ValueError, "ny must be an integer >= 1, got -3"),
        ({"nz": -1}, ValueError, "nz must be an integer >= 0, got -1"),
        ({"nx": 4.0}, TypeError, "nx must be an integer, got 4.0"),
        ({"ny": True}, TypeError, "ny must be an integer, got True"),
        ({"nx": "4"}, TypeError, "nx must be an integer, got '4'"),
        ({"dx": 0.0}, ValueError, "dx must be a finite number > 0 [m], got 0"),
        ({"dy": -1e-6}, ValueError, "dy must be a finite number > 0 [m], got -1e-06"),
        ({"dx": math.nan}, ValueError, "dx must be a finite number > 0 [m], got nan"),
        ({"dy": math.inf}, ValueError, "dy must be a finite number > 0 [m], got inf"),
        ({"dx": "1e-6"}, TypeError, "dx must be a number, got '1e-6'"),
        ({"dx": None}, TypeError, "dx must be a number, got None"),
        ({"dz": 0.0}, ValueError, "dz must be a finite number > 0 [m], got 0"),
        ({"dz": math.nan}, ValueError, "dz must be a finite number > 0 [m], got nan"),
        ({"dz": None}, ValueError, "dz must be a finite number > 0 [m] with nz = 2, got None"),
    ],
)
def test_refused(changed, error, text):
    good = {"nx": 4, "ny": 3, "dx": 1e-6, "dy": 1e-6, "nz": 2, "dz": 1e-6}
    with pytest.raises(error, match=re.escape(text)):
        sc.Grid(**(good | changed))
