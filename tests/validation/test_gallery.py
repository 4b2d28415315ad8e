# SPDX-License-Identifier: GPL-3.0-or-later
"""Values and trends stated in the thesis for the figures of docs/gallery, on coarse grids."""

import importlib

import pytest

from gallery.parts import PARTS


@pytest.mark.filterwarnings("ignore::samcontact.PlasticStrainWarning")
@pytest.mark.parametrize("name", PARTS)
def test_stated_values(name):
    part = importlib.import_module(f"gallery.{name}")
    entries = part.stated(part.compute(quick=True))
    assert entries
    wrong = [f"{e.quantity}: thesis {e.thesis}, computed {e.ours}" for e in entries if not e.holds]
    assert not wrong
