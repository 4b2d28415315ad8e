# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.experiments: indentation beside what experiments found, as a page."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
