# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m benchmarks.stability: what extreme scenes cost and lose."""

from .page import STUDY

if __name__ == "__main__":
    STUDY.main()
