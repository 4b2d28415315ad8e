# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.roofline: time of the main jobs over their physical limit."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
