# SPDX-License-Identifier: GPL-3.0-or-later
"""Figure of friction over the sliding velocity."""

import numpy as np
import pytest

from samcontact import plotting


def test_friction_curve_shows_speeds_in_order():
    velocity, friction = [-10.0, 0.0, 1.0, 0.1], [0.1, 0.0, 0.3, 0.2]
    ax = plotting.friction_curve(velocity, friction, contact_share=[0.2, 0.9, 0.3, 0.5], label="a")
    (line,) = ax.lines
    assert line.get_xdata() == pytest.approx([0.1, 1.0, 10.0])
    assert line.get_ydata() == pytest.approx([0.2, 0.3, 0.1])
    assert ax.get_xscale() == "log"
    assert (ax.get_xlabel(), ax.get_ylabel()) == (
        "sliding velocity [m/s]", "friction coefficient [-]",
    )  # fmt: skip
    (right,) = (other for other in ax.figure.axes if other is not ax)
    assert right.lines[0].get_ydata() == pytest.approx([50.0, 30.0, 20.0])
    assert right.get_ylim()[0] == 0.0


@pytest.mark.parametrize(
    ("velocity", "friction", "text"),
    [
        ([0.0], [0.1], "at least one velocity must differ from 0"),
        ([1.0, 2.0], [0.1], "friction must have shape"),
        ([1.0], [np.nan], "friction must be finite"),
    ],
)
def test_bad_input_is_refused(velocity, friction, text):
    with pytest.raises(ValueError, match=text):
        plotting.friction_curve(velocity, friction)
