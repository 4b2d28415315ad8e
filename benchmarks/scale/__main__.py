# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.scale: cost of the main contact problems versus size."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
