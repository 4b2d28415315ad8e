# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.static_capacity: which load leaves 1e-4 of the diameter, as a page."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
