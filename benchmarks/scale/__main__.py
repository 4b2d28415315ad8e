# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.scale: cost of the main jobs versus their size."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
