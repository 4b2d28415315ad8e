# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.scale: what the main jobs cost against their size."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
