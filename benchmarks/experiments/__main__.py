# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.experiments: page that compares indentation with experiments."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
