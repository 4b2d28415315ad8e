# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.combinations: pairs of capabilities, tried in small contacts."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
