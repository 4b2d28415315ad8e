# SPDX-License-Identifier: GPL-3.0-or-later
"""Comparisons shared by several tests."""

import xarray as xr

ADDED = ("Conventions", "history")
"""Attributes that a file has and the dataset that was saved has not."""


def assert_stored(found, expected):
    """Assert that a dataset read from a file equals the saved one, file attributes aside."""
    assert found.attrs["Conventions"].startswith("CF-1.")
    kept = found.load().copy()
    kept.attrs = {name: value for name, value in found.attrs.items() if name not in ADDED}
    xr.testing.assert_identical(kept, expected)
